#include <thalweg/fields/expression.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The difference between the fluids' exact places and the computed ones.
    template <int dim>
    class InterfaceError : public Postprocessor<dim>
    {
    public:
      InterfaceError()
        : schedule(1e30)
      {}


      void
      declare_parameters(const Section &section) override
      {
        section.add("Level set",
                    expression,
                    "m",
                    "The exact level set as a function of x, y, z and t, "
                    "negative in the first fluid. Its values should vary no "
                    "faster than a distance would.",
                    dealii::Patterns::Anything());
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        AssertThrow(solution.fluids.size() == 2,
                    dealii::ExcMessage(
                      "The postprocessor 'interface error' needs two fluids, "
                      "but the section 'Fluids' has one. Remove it from "
                      "'Postprocess/Models' or name a second fluid."));
        exact = parse_expression<dim>(expression,
                                      1,
                                      "Postprocess/interface error/Level set");
        file.open(context,
                  "interface_error.csv",
                  {"time [s]",
                   "error [" + length_unit(dim) + "]",
                   "relative error",
                   "relative volume error"});
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        exact->set_time(solution.time);
        const CellGraph<dim> &graph = solution.mesh.graph();
        double                error = 0, volume = 0, exact_volume = 0;
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          {
            const auto  &cell = graph.cell(c);
            const double computed =
              negative_volume<dim>(cell, cell_level_set(solution, c));
            const double wanted = sampled_negative_volume<dim>(cell, *exact);
            error += std::abs(computed - wanted);
            volume += computed;
            exact_volume += wanted;
          }
        const auto &communicator =
          solution.mesh.triangulation().get_communicator();
        for (double *sum : {&error, &volume, &exact_volume})
          *sum = dealii::Utilities::MPI::sum(*sum, communicator);
        file.write_row(context,
                       {solution.time,
                        error,
                        error / exact_volume,
                        volume / exact_volume - 1.});
      }

    private:
      std::string                                  expression = "1";
      std::unique_ptr<dealii::FunctionParser<dim>> exact;
      Schedule                                     schedule;
      CsvFile                                      file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   InterfaceError,
                   "interface error",
                   "how much of the volume is on the wrong side of an exact "
                   "interface: the sum over the cells of the difference in "
                   "the first fluid's volume, also relative to its exact "
                   "volume; writes interface_error.csv at the start and the "
                   "end, or more often.")
} // namespace Thalweg
