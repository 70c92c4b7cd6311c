// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/cell_gradients.h>
#include <thalweg/adaptation/refinement_criterion.h>
#include <thalweg/fields/expression.h>
#include <thalweg/postprocess/cell_access.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// How much a field changes over a cell.
    template <int dim>
    class Gradient : public FlowCriterion<dim>
    {
    public:
      void
      declare_for_flow(const Section &section) override
      {
        section.add("Field",
                    field,
                    "",
                    "Whose gradient counts. The kinetic energy is that of a "
                    "cubic metre; the level set is a distance near the "
                    "interface and constant far away.",
                    dealii::Patterns::Selection(
                      "velocity|pressure|level set|kinetic energy|"
                      "expression"));
        section.add("Expression",
                    text,
                    "",
                    "A function of x, y, z and t, for 'Field = expression'.",
                    dealii::Patterns::Anything());
      }



      void
      check_for_flow(const FlowOutline<dim> &,
                     const LevelRange &) const override
      {
        if (field == "expression")
          parse_expression<dim>(text, 1, parameter);
      }



      void
      evaluate_for_flow(const FlowView<dim> &solution,
                        const LevelRange &,
                        const double,
                        CellWishes &wishes) override
      {
        if (field == "expression" && expression == nullptr)
          expression = parse_expression<dim>(text, 1, parameter);
        if (expression != nullptr)
          expression->set_time(solution.time);
        const CellGraph<dim> &graph = solution.mesh.graph();
        for (unsigned int c = 0; c < wishes.indicator.size(); ++c)
          wishes.indicator[c] =
            norm(solution, c) * cell_size<dim>(graph.cell(c));
      }

    private:
      template <int n_components>
      using Values = std::array<std::array<double, n_components>, (1 << dim)>;



      double
      norm(const FlowView<dim> &solution, const unsigned int c) const
      {
        const auto &cell = solution.mesh.graph().cell(c);
        if (field == "velocity")
          {
            Values<dim> values;
            for (unsigned int v = 0; v < values.size(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                values[v][d] = velocity(solution, c, v, d);
            double squares = 0.;
            for (const auto &gradient :
                 gradient_at_center<dim, dim>(cell, values))
              squares += gradient.norm_square();
            return std::sqrt(squares);
          }
        Values<1> values;
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v][0] = value(solution, c, v);
        return gradient_at_center<dim, 1>(cell, values)[0].norm();
      }



      double
      value(const FlowView<dim> &solution,
            const unsigned int   cell,
            const unsigned int   vertex) const
      {
        const unsigned int node = solution.space.nodes(cell)[vertex];
        if (field == "pressure")
          return solution.pressure.local_element(node);
        if (field == "level set")
          return cell_level_set(solution, cell)[vertex];
        if (field == "expression")
          return expression->value(
            solution.mesh.graph().cell(cell).vertices[vertex]);
        double squares = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          squares += std::pow(velocity(solution, cell, vertex, d), 2);
        const bool in_first = cell_level_set(solution, cell)[vertex] < 0.;
        return .5 * solution.fluids[in_first ? 0 : 1].density * squares;
      }



      static double
      velocity(const FlowView<dim> &solution,
               const unsigned int   cell,
               const unsigned int   vertex,
               const unsigned int   component)
      {
        return solution.velocity.local_element(
          dim * solution.space.nodes(cell)[vertex] + component);
      }



      static constexpr const char *parameter =
        "Refinement/Adaptive/gradient/Expression";

      std::string                                  field = "velocity";
      std::string                                  text  = "0";
      std::unique_ptr<dealii::FunctionParser<dim>> expression;
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   Gradient,
                   "gradient",
                   "by how much a field changes over a cell: its gradient at "
                   "the centre times the cell's size, in the field's unit.")
} // namespace Thalweg
