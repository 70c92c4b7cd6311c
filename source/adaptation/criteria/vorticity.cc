// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/cell_gradients.h>
#include <thalweg/adaptation/refinement_criterion.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// |curl v| times the size of the cell.
    template <int dim>
    class Vorticity : public FlowCriterion<dim>
    {
    public:
      void
      declare_for_flow(const Section &) override
      {}



      void
      evaluate_for_flow(const FlowView<dim> &solution,
                        const LevelRange &,
                        const double,
                        CellWishes &wishes) override
      {
        const CellGraph<dim> &graph = solution.mesh.graph();
        for (unsigned int c = 0; c < wishes.indicator.size(); ++c)
          {
            std::array<std::array<double, dim>, (1 << dim)> values;
            for (unsigned int v = 0; v < values.size(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                values[v][d] = solution.velocity.local_element(
                  dim * solution.space.nodes(c)[v] + d);
            const auto gradients =
              gradient_at_center<dim, dim>(graph.cell(c), values);
            double squares = 0.;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < i; ++j)
                squares += std::pow(gradients[i][j] - gradients[j][i], 2);
            wishes.indicator[c] =
              std::sqrt(squares) * cell_size<dim>(graph.cell(c));
          }
      }
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   Vorticity,
                   "vorticity",
                   "the curl of the velocity at the centre of a cell times "
                   "the cell's size, in m/s.")
} // namespace Thalweg
