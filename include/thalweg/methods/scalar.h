// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_scalar_h
#define thalweg_methods_scalar_h

#include <thalweg/fluid/scalar_diffusion.h>
#include <thalweg/fluid/scalar_view.h>
#include <thalweg/methods/medium.h>
#include <thalweg/methods/method.h>
#include <thalweg/methods/particle_heat.h>
#include <thalweg/methods/scalar_parameters.h>
#include <thalweg/particles/particle_host.h>
#include <thalweg/transfer/scalar_projection.h>

#include <deal.II/base/function.h>

#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief A scalar, temperature or salt, that the particles of a flow carry,
   * each its own value, and that diffuses on the mesh.
   *
   * A step in two halves around the motion of the particles (G. Strang, SIAM
   * J. Numer. Anal. 5, 1968, p. 506), so that it is of second order in time
   * at any Courant number:
   *
   * 1. on the mesh it diffuses for half of the step, of which the particles
   *    take the increment,
   * 2. they move, and their values are projected to the mesh,
   * 3. there it diffuses for the other half, of which they take the increment.
   *
   * Where something melts, particles carry their molten part, too, which is
   * projected by itself: the scalar goes on from one fluid to the other, what
   * is molten ends there.
   */
  template <int dim>
  class Scalar : public Method<dim>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      parameters.declare(section);
    }

    void
    declare_sections(const Section &) override
    {}

    void
    check(std::vector<std::string> &faults) const override
    {
      parameters.template check<dim>(faults);
    }

    void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const override;

    void
    check_on_outline(const RunOutline<dim>    &outline,
                     std::vector<std::string> &faults) const override;

    void
    publish(const std::string &name, RunOutline<dim> &outline) const override
    {
      outline.offered.add(name, "scalars");
    }

    using Method<dim>::publish;

    std::vector<Need>
    needs() const override
    {
      return {{parameters.carrier, "particles"},
              {parameters.carrier, "medium"}};
    }

    void
    create(const Host<dim> &host) override;

    void
    release() override;

    void
    attach() override;

    void
    offer(Ports &ports) const override
    {
      ports.offer<const ScalarView<dim>>(host->name, "scalars", *view);
    }

    void
    initialize() override;

    void
    keep(const State<dim> &state) override;

    void
    update() override
    {
      update_operator();
    }

    void
    repopulate() override
    {
      fill_unknown(heat.value, view->field);
      if (parameters.melts())
        fill_unknown(heat.molten, view->molten);
    }

    void
    begin_step(const double time, const double dt) override;

    void
    advance(const double time, const double dt) override;

    std::vector<std::string>
    columns() const override;

    void
    record(const double time) override;

    std::string
    size() const override;

    std::string
    headline() const override;

  private:
    const Medium<dim> &
    medium() const
    {
      return host->ports.template get<const Medium<dim>>(parameters.carrier,
                                                         "medium",
                                                         who());
    }

    /// "'Methods/temperature'"
    std::string
    who() const
    {
      return host->name.empty() ? "'Method/Model = scalar'"
                                : "'Methods/" + host->name + "'";
    }

    /// "least [K]"
    std::string
    with_unit(const std::string &column) const;

    /// Where the fluid melts, without its latent heat.
    Melting
    melting_point() const
    {
      return {0., parameters.solidus, parameters.liquidus};
    }

    /// What comes in through a boundary, see InflowValue.
    double
    inflow(const dealii::types::boundary_id id,
           const dealii::Point<dim>        &place,
           const double                     before_end) const;

    /// Lets the scalar diffuse from @p time on for @p dt, s, and gives the
    /// particles the increment.
    void
    diffuse(const double time, const double dt);

    /// What there is of the scalar: on the particles where they carry volumes,
    /// else on the mesh. Collective.
    double
    content() const;

    /// The scalar and its molten part at the nodes.
    struct Fields
    {
      Vector value, molten;
    };

    /// What the view has, ghosted.
    Fields
    fields() const;

    /// The heat of values and molten parts at the nodes; ghosted if something
    /// melts.
    Vector
    heat_at_nodes(const Vector &value, const Vector &molten) const;

    /// Lets @p action(heat) change the heat at the nodes, ghosted, and divides
    /// it between the fields of the view: the scalar itself if nothing melts.
    template <typename Action>
    void
    change_heat(const Action &action);

    /// Divides the heat at the nodes anew, which stays as it is.
    void
    divide_heat();

    /// Calls @p add(row of a particle, increments of its value, its molten part
    /// and its heat, capacity of its volume) with what the fields less
    /// @p before have at the particles.
    template <typename Add>
    void
    for_each_increment(const Fields &before, const Add &add);

    /// Adds the fields less @p before to what particles carry; where they carry
    /// volumes it is made to hold @p supply.
    void
    add_increment(const Fields &before, const double supply);

    /// Gives particles that do not know a property what @p field says.
    void
    fill_unknown(const unsigned int property, const Vector &field);

    /// What was projected, within the bounds of the particles; owned values.
    static Vector
    within_bounds(const Vector &field, const ScalarProjection<dim> &projection);

    /// Projects what particles carry, and fills those that do not know it.
    void
    project_particles();

    /// From the particles to the mesh; where nothing flows in or out what
    /// there is of the scalar stays what it is.
    void
    project();

    /// Lets what was projected melt or freeze at each node by itself, without
    /// any heat from elsewhere.
    void
    balance();

    /// Gives the nodes what the motion has taken from the content, in
    /// proportion to how far they are from the bounds of the particles around
    /// them.
    void
    give_back(Vector &heats);

    /// Says of the operator where the fluids are now.
    void
    update_operator();

    ScalarParameters                       parameters;
    std::unique_ptr<Host<dim>>             host;
    std::unique_ptr<ScalarConditions<dim>> conditions;
    std::unique_ptr<dealii::Function<dim>> source; ///< nullptr without one
    ParticleHost<dim>                     *particles  = nullptr;
    Population<dim>                       *population = nullptr;
    ParticleHeat                           heat;
    std::array<double, 2>                  capacity{}, conductivity{};
    std::array<double, 2>                  latent_heat{};
    std::unique_ptr<ScalarView<dim>>       view;
    std::unique_ptr<ScalarProjection<dim>> projection;
    /// Of the molten part; nullptr where nothing melts.
    std::unique_ptr<ScalarProjection<dim>> molten_projection;
    std::unique_ptr<ScalarDiffusion<dim>>  diffusion;
    double                                 end_of_step = 0.; ///< s
    double                                 half_step   = 0.; ///< s
    unsigned int                           iterations  = 0;
    double correction = 0.; ///< of the content in the last step
    /// What there was at the start, and since came in through boundaries, was
    /// supplied, and came in with the flow.
    double at_start = 0., through = 0., supplied = 0., with_flow = 0.;
    double before_motion = 0.; ///< content
  };
} // namespace Thalweg

#endif
