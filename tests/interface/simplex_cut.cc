// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/simplex_cut.h>

#include <cmath>
#include <gtest/gtest.h>

using namespace Thalweg;

namespace
{
  /// Values at the vertices of a function given by a lambda.
  template <int dim, typename F>
  std::array<double, (1 << dim)>
  at_vertices(const F &f)
  {
    std::array<double, (1 << dim)> values;
    for (unsigned int v = 0; v < values.size(); ++v)
      {
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = (v >> d) & 1u;
        values[v] = f(x);
      }
    return values;
  }



  /// The reference cell as a cell of a graph, stretched by @p extent.
  template <int dim>
  typename CellGraph<dim>::Cell
  make_cell(const dealii::Tensor<1, dim> &extent)
  {
    typename CellGraph<dim>::Cell cell{};
    cell.axis_parallel = true;
    cell.measure       = 1.;
    cell.extent        = extent;
    for (unsigned int d = 0; d < dim; ++d)
      {
        cell.measure *= extent[d];
        cell.inverse_extent[d] = 1. / extent[d];
        for (unsigned int v = 0; v < cell.vertices.size(); ++v)
          cell.vertices[v][d] = ((v >> d) & 1u) * extent[d];
      }
    return cell;
  }
} // namespace



TEST(SimplexCut, SimplicesFillTheCell)
{
  double sum = 0;
  for (const auto &simplex : SimplexCut::divide<2>({{1, 1, 1, 1}}))
    sum += SimplexCut::measure(simplex);
  EXPECT_NEAR(sum, 1., 1e-14);
  sum = 0;
  for (const auto &simplex : SimplexCut::divide<3>({{1, 1, 1, 1, 1, 1, 1, 1}}))
    sum += SimplexCut::measure(simplex);
  EXPECT_NEAR(sum, 1., 1e-14);
}



TEST(SimplexCut, PlanesCutExactVolumes)
{
  for (const double height : {1e-9, .1, .5, .77, 1. - 1e-9})
    {
      EXPECT_NEAR(SimplexCut::negative_fraction<2>(at_vertices<2>(
                    [=](const auto &x) { return x[1] - height; })),
                  height,
                  1e-14);
      EXPECT_NEAR(SimplexCut::negative_fraction<3>(at_vertices<3>(
                    [=](const auto &x) { return x[2] - height; })),
                  height,
                  1e-14);
    }
  // a corner cut off: c^dim / dim!
  const double c = .4;
  EXPECT_NEAR(SimplexCut::negative_fraction<2>(
                at_vertices<2>([=](const auto &x) { return x[0] + x[1] - c; })),
              c * c / 2,
              1e-14);
  EXPECT_NEAR(SimplexCut::negative_fraction<3>(at_vertices<3>(
                [=](const auto &x) { return x[0] + x[1] + x[2] - c; })),
              c * c * c / 6,
              1e-14);
}



TEST(SimplexCut, BothSidesAddUp)
{
  std::array<double, 8> phi      = {{-.3, .2, .7, -.1, .4, -.9, .05, .6}};
  const double          negative = SimplexCut::negative_fraction<3>(phi);
  for (double &value : phi)
    value = -value;
  EXPECT_NEAR(negative + SimplexCut::negative_fraction<3>(phi), 1., 1e-13);
  EXPECT_GT(negative, 0.);
  EXPECT_LT(negative, 1.);
}



TEST(SimplexCut, QuadratureIsExactForDegreeDim)
{
  double integral = 0;
  for (const auto &simplex : SimplexCut::divide<3>({{1, 1, 1, 1, 1, 1, 1, 1}}))
    for (const auto &q : SimplexCut::quadrature(simplex))
      integral += q.weight * q.xi[0] * q.xi[1] * q.xi[2];
  EXPECT_NEAR(integral, 1. / 8., 1e-14);
  integral = 0;
  for (const auto &simplex : SimplexCut::divide<2>({{1, 1, 1, 1}}))
    for (const auto &q : SimplexCut::quadrature(simplex))
      integral += q.weight * q.xi[0] * q.xi[1];
  EXPECT_NEAR(integral, 1. / 4., 1e-14);
}



// A hydrostatic pressure with a kink on a tilted plane lies in the enriched
// space, and its gradient balances rho g in every row, wherever the plane is.
template <int dim>
void
check_hydrostatic_balance(const double offset)
{
  dealii::Tensor<1, dim> g, extent;
  for (unsigned int d = 0; d < dim; ++d)
    {
      g[d]      = d == dim - 1 ? -9.81 : -2.5;
      extent[d] = .3 + .2 * d;
    }
  const auto cell = make_cell<dim>(extent);
  // phi = -g.x/|g|^2 - offset: the level of the liquid
  std::array<double, (1 << dim)> phi, w, p;
  const Fluids                   fluids;
  const double rho[2] = {fluids[0].density, fluids[1].density};
  for (unsigned int v = 0; v < phi.size(); ++v)
    {
      phi[v] = -(g * cell.vertices[v]) / g.norm_square() - offset;
      w[v]   = std::abs(phi[v]);
      // p = -rho |g|^2 phi on each side
      p[v] = -(phi[v] < 0 ? rho[0] : rho[1]) * g.norm_square() * phi[v];
    }
  const auto cut = integrate_cut_cell<dim>(
    0, cell, phi, w, .1, fluids, PressureEnrichment::gradient);
  ASSERT_TRUE(cut.enriched);

  // p = mean slope part + jump |phi| / 2, and |phi| = I w - psi length
  const double star = .5 * (rho[0] - rho[1]) * g.norm_square() * -.1;
  for (unsigned int i = 0; i < phi.size(); ++i)
    {
      double row = 0;
      for (unsigned int j = 0; j < phi.size(); ++j)
        row += cut.laplace_star[i][j] * star;
      for (unsigned int j = 0; j < phi.size(); ++j)
        row += cut.laplace[i][j] * p[j];
      double expected = 0;
      for (unsigned int q = 0; q < Q1::Gauss<dim>::n_points; ++q)
        {
          const Q1::Gauss<dim> gauss;
          const auto           point = gauss.evaluate(cell, q);
          expected +=
            gauss.weight * point.determinant * (g * point.gradients[i]);
        }
      EXPECT_NEAR(row, expected, 1e-10 * std::abs(expected) + 1e-12);
    }
  for (unsigned int i = 0; i < phi.size(); ++i)
    {
      double row = 0;
      for (unsigned int j = 0; j < phi.size(); ++j)
        row +=
          cut.laplace_star_star[i][j] * star + cut.laplace_star[j][i] * p[j];
      EXPECT_NEAR(row, g * cut.star_load[i], 1e-10 * g.norm() * cell.measure);
    }
}



TEST(CutCell, HydrostaticPressureIsExact2d)
{
  for (const double offset : {.001, .02, .03})
    check_hydrostatic_balance<2>(offset);
}



TEST(CutCell, HydrostaticPressureIsExact3d)
{
  for (const double offset : {.005, .02, .05})
    check_hydrostatic_balance<3>(offset);
}
