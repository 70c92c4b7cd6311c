// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/expression.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The difference between the fluids' exact places and the computed ones.
    template <int dim>
    class InterfaceError : public TableOutput<dim>
    {
    public:
      InterfaceError()
        : TableOutput<dim>("interface_error.csv", 1e30)
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(outline.fluids.size() == 2,
                    dealii::ExcMessage(
                      "The postprocessor 'interface error' needs two fluids, "
                      "but the section 'Fluids' has one. Remove it from "
                      "'Postprocess/Models' or name a second fluid."));
        parse();
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Level set",
                    expression,
                    "m",
                    "The exact level set as a function of x, y, z and t, "
                    "negative in the first fluid. Its values should vary no "
                    "faster than a distance would.",
                    dealii::Patterns::Anything());
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        exact = parse();
        return {"error [" + length_unit(dim) + "]",
                "relative error",
                "relative volume error"};
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
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
        return {error, error / exact_volume, volume / exact_volume - 1.};
      }


      std::unique_ptr<dealii::FunctionParser<dim>>
      parse() const
      {
        return parse_expression<dim>(expression,
                                     1,
                                     "Postprocess/interface error/Level set");
      }


      std::string                                  expression = "1";
      std::unique_ptr<dealii::FunctionParser<dim>> exact;
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
