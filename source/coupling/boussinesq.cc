// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/coupling/coupling.h>
#include <thalweg/fluid/flow_terms.h>
#include <thalweg/fluid/scalar_view.h>

#include <memory>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief Buoyancy as J. Boussinesq has it: a scalar makes a fluid lighter
     * where it is large, and gravity acts on that, -beta (s - s_0) g; else the
     * density is what it is.
     */
    template <int dim>
    class Boussinesq : public Coupling<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Expansion",
                    expansion,
                    "",
                    "By which part of it the density is less for each unit of "
                    "the scalar, 1/K of temperature; negative for salt.");
        section.add("Reference value",
                    reference,
                    "",
                    "Of the scalar, at which the density is that of the "
                    "fluid.");
      }

      std::vector<std::vector<std::string>>
      needs() const override
      {
        return {{FlowTerms<dim>::port}, {"scalars"}};
      }

      void
      create(const Host<dim>                &host_,
             const std::vector<std::string> &methods_) override
      {
        host    = std::make_unique<Host<dim>>(host_);
        methods = methods_;
      }

      void
      release() override
      {
        buoyancy = {};
      }

      void
      attach() override
      {
        for (Vector *vector : {&buoyancy.before, &buoyancy.now})
          terms().space().initialize_velocity(*vector);
        terms().accelerate(host->name, buoyancy);
      }

      void
      initialize() override
      {
        buoyancy.time_before = buoyancy.time_now = 0.;
        find(0., buoyancy.now);
        buoyancy.before = buoyancy.now;
      }

      void
      keep(const State<dim> &state) override
      {
        state.values().value("time before", buoyancy.time_before);
        state.values().value("time now", buoyancy.time_now);
        const auto &space = terms().space();
        state.field("before", space, buoyancy.before, dim);
        state.field("now", space, buoyancy.now, dim);
      }

      void
      transfer(const double time, const double dt) override
      {
        // What the flow took for the end of the step.
        const double part = buoyancy.part_of_now(time + dt);
        Vector       expected(buoyancy.before);
        expected.zero_out_ghost_values();
        expected.sadd(1. - part, part, buoyancy.now);
        // Of an iterated step only its end is found anew.
        if (time == buoyancy.time_now)
          buoyancy.before.swap(buoyancy.now);
        buoyancy.time_before = time;
        buoyancy.time_now    = time + dt;
        find(time + dt, buoyancy.now);
        const double largest = buoyancy.now.linfty_norm();
        expected.add(-1., buoyancy.now);
        difference = largest > 0. ? expected.linfty_norm() / largest : 0.;
      }

      double
      change() const override
      {
        return difference;
      }

    private:
      FlowTerms<dim> &
      terms() const
      {
        return host->ports.template get<FlowTerms<dim>>(
          methods[0], FlowTerms<dim>::port, "'Couplings/" + host->name + "'");
      }

      /// What acts at @p time, s.
      void
      find(const double time, Vector &acceleration) const
      {
        const auto &scalar = host->ports.template get<const ScalarView<dim>>(
          methods[1], "scalars", "'Couplings/" + host->name + "'");
        const dealii::Tensor<1, dim> gravity = host->forces.gravity(time);
        acceleration.zero_out_ghost_values();
        for (unsigned int n = 0; n < scalar.space.n_owned_nodes(); ++n)
          {
            const double lighter =
              expansion * (scalar.field.local_element(n) - reference);
            for (unsigned int d = 0; d < dim; ++d)
              acceleration.local_element(dim * n + d) = -lighter * gravity[d];
          }
        terms().space().interpolate(acceleration, dim);
      }

      double                     expansion = 0., reference = 0.;
      double                     difference = 0.; ///< see change()
      std::unique_ptr<Host<dim>> host;
      std::vector<std::string>   methods;
      NodalAcceleration          buoyancy;
    };
  } // namespace

  THALWEG_REGISTER(Coupling,
                   Boussinesq,
                   "boussinesq",
                   "buoyancy: a scalar, the second of the two methods, makes "
                   "the fluid of the first one lighter")
} // namespace Thalweg
