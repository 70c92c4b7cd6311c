// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_integrals.h>

#include <algorithm>

#include "cut_cells.h"
#include "support/dimensions.h"

using namespace Thalweg;
using namespace CutCells;

namespace
{
  template <typename T>
  class BentCutCell : public testing::Test
  {};
  TYPED_TEST_SUITE(BentCutCell, Dimensions);
} // namespace



TYPED_TEST(BentCutCell, HydrostaticPressureBalancesGravity)
{
  constexpr int          dim = TypeParam::value;
  const Cells<dim>       cells(3, true);
  const Q1Integrals<dim> integrals;
  const auto             plane = tilted<dim>(.6);
  const auto             g     = -9.81 * plane.slope;
  unsigned int           n_cut = 0;
  for (unsigned int c = 0; c < cells.mesh.graph().n_owned_cells(); ++c)
    {
      const auto phi = cells.nodal(plane, c);
      if (*std::min_element(phi.begin(), phi.end()) >= 0. ||
          *std::max_element(phi.begin(), phi.end()) <= 0.)
        continue;
      ++n_cut;
      const auto &cell = cells.cell(c);
      const auto  cut  = cells.cut(plane, c);
      // p = rho g . x on both sides
      std::array<double, (1 << dim)> p;
      for (unsigned int v = 0; v < p.size(); ++v)
        p[v] = -9.81 * phi[v] * rho[phi[v] < 0 ? 0 : 1];
      const double                        star = -9.81 * .5 * (rho[0] - rho[1]);
      typename Q1Integrals<dim>::Velocity force{};
      integrals.add_gradient(cell, p, force);
      const auto loads = integrals.gradient_integrals(cell);
      for (unsigned int i = 0; i < p.size(); ++i)
        {
          double row      = g * loads[i];
          double star_row = g * cut.star_load[i];
          for (unsigned int j = 0; j < p.size(); ++j)
            {
              row -= cut.laplace[i][j] * p[j] + cut.laplace_star[i][j] * star;
              star_row -= cut.laplace_star[j][i] * p[j] +
                          cut.laplace_star_star[i][j] * star;
            }
          EXPECT_NEAR(row, 0., 1e-12);
          EXPECT_NEAR(star_row, 0., 1e-12);
          const auto gradient = Enrichment<dim>::sum(cut.star_gradient[i]);
          for (unsigned int d = 0; d < dim; ++d)
            EXPECT_NEAR(force[dim * i + d] + gradient[d] * star,
                        cut.mass[i] * g[d],
                        1e-12 * rho[0]);
        }
    }
  EXPECT_GT(n_cut, 2u);
}
