// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/scalar_view.h>
#include <thalweg/postprocess/offered_output.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// The scalars of all methods that have one, by the methods' names.
    template <int dim>
    std::map<std::string, const ScalarView<dim> *>
    all_scalars(const SolutionView<dim> &solution)
    {
      return solution.ports->template all<const ScalarView<dim>>("scalars");
    }



    /// Scalars on the mesh for ParaView.
    template <int dim>
    class ScalarOutput : public OfferedSeries<dim, const ScalarView<dim>>
    {
    public:
      ScalarOutput()
        : OfferedSeries<dim, const ScalarView<dim>>("scalars",
                                                    "temperature: scalar")
      {}

    private:
      void
      write(Context               &context,
            const std::string     &name,
            const ScalarView<dim> &scalar,
            const Moment          &now,
            PvdRecord             &record) const override
      {
        dealii::DataOut<dim> data;
        data.add_data_vector(scalar.space.scalar(), scalar.field, name);
        if (scalar.molten.size() > 0)
          data.add_data_vector(scalar.space.scalar(),
                               scalar.molten,
                               name + "_molten");
        data.build_patches();
        record.write(context, data, now.time, now.step);
      }
    };



    /// What flows out through boundaries where a scalar is given.
    template <int dim>
    class ScalarFluxes : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        schedule.declare_parameters(section, "rows");
      }

      void
      check(const RunOutline<dim> &outline) const override
      {
        check_offered(outline.offered,
                      "scalars",
                      "scalar fluxes",
                      "temperature: scalar");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[method, scalar] : all_scalars(solution))
          {
            std::vector<std::string> columns{"time [s]"};
            for (const auto &[id, boundary] : scalar->given)
              for (const std::string what : {"mean ", "least ", "greatest "})
                columns.push_back(what + boundary);
            tables[method].open(context,
                                file_name_of(method, "scalar") + "_fluxes.csv",
                                columns);
          }
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        const Moment &now = solution.moment;
        if (!schedule.is_due(now.time, now.last_step))
          return;
        for (const auto &[method, scalar] : all_scalars(solution))
          {
            std::vector<double>  row{now.time};
            const BoundaryFluxes fluxes = scalar->fluxes(now.time);
            for (const auto &[id, boundary] : scalar->given)
              for (const double value :
                   summary(context.communicator, fluxes, id))
                row.push_back(value);
            tables[method].write_row(context, row);
          }
      }

      void
      keep(const State<dim> &state) override
      {
        schedule.keep(state.values());
        tables.keep(state.values(), schedule.was_due_for_the_end());
      }

    private:
      /// Mean, least and greatest flux. Collective.
      static std::array<double, 3>
      summary(const MPI_Comm                   communicator,
              const BoundaryFluxes            &fluxes,
              const dealii::types::boundary_id id)
      {
        using namespace dealii::Utilities;
        double     flow = 0., area = 0.;
        double     least    = std::numeric_limits<double>::max();
        double     greatest = std::numeric_limits<double>::lowest();
        const auto found    = fluxes.find(id);
        if (found != fluxes.end())
          for (const auto &[flux, measure] : found->second)
            {
              flow += flux * measure;
              area += measure;
              least    = std::min(least, flux);
              greatest = std::max(greatest, flux);
            }
        return {{MPI::sum(flow, communicator) / MPI::sum(area, communicator),
                 MPI::min(least, communicator),
                 MPI::max(greatest, communicator)}};
      }

      Schedule        schedule{.05};
      TablesOfMethods tables;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ScalarOutput,
                   "scalars",
                   "scalars on the mesh, for ParaView; writes METHOD.pvd.")
  THALWEG_REGISTER(Postprocessor,
                   ScalarFluxes,
                   "scalar fluxes",
                   "what flows out through an area in a second where a scalar "
                   "is given, in units of the scalar times the capacity: mean, "
                   "least and greatest of each boundary; writes "
                   "METHOD_fluxes.csv.")
} // namespace Thalweg
