// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_integrals.h>

#include "cut_cells.h"
#include "support/dimensions.h"

using namespace Thalweg;
using namespace CutCells;

namespace
{
  template <typename T>
  class CutCellTest : public testing::Test
  {};
  TYPED_TEST_SUITE(CutCellTest, Dimensions);
} // namespace



TYPED_TEST(CutCellTest, VolumesOfTiltedPlanesAreExact)
{
  constexpr int    dim = TypeParam::value;
  const Cells<dim> cells;
  for (const double level : {-.1, .01, .2, .5, .73, 1.1, 2.})
    EXPECT_NEAR(negative_volume<dim>(cells.cell(),
                                     cells.nodal(tilted<dim>(level))),
                tilted<dim>(level).fraction({}, 1.),
                1e-14)
      << level;
}



TYPED_TEST(CutCellTest, VolumesOfBothSidesFillBentCells)
{
  constexpr int    dim = TypeParam::value;
  const Cells<dim> cells(3, true);
  const auto       plane = tilted<dim>(.6);
  double           sum   = 0;
  for (unsigned int c = 0; c < cells.mesh.graph().n_owned_cells(); ++c)
    {
      const auto phi = cells.nodal(plane, c);
      auto       psi = phi;
      for (double &value : psi)
        value = -value;
      const double volume = negative_volume<dim>(cells.cell(c), phi);
      EXPECT_NEAR(volume + negative_volume<dim>(cells.cell(c), psi),
                  cells.cell(c).measure,
                  1e-15);
      sum += volume;
    }
  EXPECT_NEAR(sum, plane.fraction({}, 1.), 1e-14);
}



TYPED_TEST(CutCellTest, MassesAreThoseOfTheParts)
{
  constexpr int    dim = TypeParam::value;
  const Cells<dim> cells;
  for (const double level : {.3, .6})
    {
      const double f   = tilted<dim>(level).fraction({}, 1.);
      double       sum = 0;
      for (const double mass : cells.cut(tilted<dim>(level)).mass)
        sum += mass;
      EXPECT_NEAR(sum, f * rho[0] + (1. - f) * rho[1], 1e-10);
    }

  const double a    = .37;
  const auto   cut  = cells.cut(flat<dim>(a));
  const double high = .5 * (a * a * rho[0] + (1. - a * a) * rho[1]);
  const double all  = a * rho[0] + (1. - a) * rho[1];
  for (unsigned int v = 0; v < cut.mass.size(); ++v)
    EXPECT_NEAR(cut.mass[v] * (1 << (dim - 1)),
                is_upper<dim>(v) ? high : all - high,
                1e-10);
}



TYPED_TEST(CutCellTest, StiffnessOfLinearFunctionsIsExact)
{
  constexpr int          dim   = TypeParam::value;
  const auto             plane = tilted<dim>(.55);
  const Cells<dim>       cells;
  const auto             cut     = cells.cut(plane);
  const double           f       = plane.fraction({}, 1.);
  const double           inverse = f / rho[0] + (1. - f) / rho[1];
  dealii::Tensor<1, dim> g, h;
  for (unsigned int d = 0; d < dim; ++d)
    {
      g[d] = 1. + d;
      h[d] = 2. - d * d;
    }
  const auto p      = cells.nodal([&](const auto &x) { return g * x; });
  const auto q      = cells.nodal([&](const auto &x) { return 1. + h * x; });
  double     energy = 0;
  dealii::Tensor<1, dim> gradient;
  for (unsigned int i = 0; i < p.size(); ++i)
    {
      gradient += p[i] * cut.gradient[i];
      for (unsigned int j = 0; j < p.size(); ++j)
        energy += p[i] * cut.laplace[i][j] * q[j];
    }
  EXPECT_NEAR(energy, (g * h) * inverse, 1e-13);
  EXPECT_NEAR((gradient - inverse * g).norm(), 0., 1e-13);
}



TYPED_TEST(CutCellTest, EnrichmentOfAFlatInterface)
{
  constexpr int    dim = TypeParam::value;
  const double     a   = .37;
  const Cells<dim> cells;
  const auto       cut = cells.cut(flat<dim>(a));
  ASSERT_TRUE(cut.enriched);
  // The slopes of psi are 2 (1 - a) below and -2 a above.
  const double inverse   = 2. * a * (1. - a) * (1. / rho[0] - 1. / rho[1]);
  const auto   star_star = Enrichment<dim>::stiffness(cut);
  EXPECT_NEAR(star_star,
              4. * a * (1. - a) * ((1. - a) / rho[0] + a / rho[1]),
              1e-14);
  EXPECT_NEAR(Enrichment<dim>::sum(cut.star_load).norm(), 0., 1e-14);
  auto load = Enrichment<dim>::sum(cut.star_inverse_load);
  load[dim - 1] -= inverse;
  EXPECT_NEAR(load.norm(), 0., 1e-14);
  // The integral of psi over the height, a triangle of height 2 a (1 - a).
  const double area = a * (1. - a);
  for (unsigned int v = 0; v < cut.mass.size(); ++v)
    {
      const double part = (is_upper<dim>(v) ? 1. : -1.) / (1 << (dim - 1));
      dealii::Tensor<1, dim> divergence;
      for (unsigned int j = 0; j < cut.mass.size(); ++j)
        divergence += cut.star_divergence[j][v];
      EXPECT_NEAR(Enrichment<dim>::sum(cut.laplace_star[v]),
                  part * inverse,
                  1e-14);
      EXPECT_NEAR(divergence[dim - 1], part * area, 1e-14);
      EXPECT_NEAR(Enrichment<dim>::sum(cut.star_gradient[v])[dim - 1],
                  -part * area,
                  1e-14);
    }
}



TYPED_TEST(CutCellTest, EnrichmentIsShapeFunctionsTimesPsi)
{
  // Integrals of N_j psi over a flat interface: psi is linear on both sides,
  // and so is N along the axis.
  constexpr int    dim = TypeParam::value;
  const double     a   = .37;
  const Cells<dim> cells;
  const auto       cut = cells.cut(flat<dim>(a));
  // int psi z and int psi (1 - z) of the triangle with its top at a
  const double area = a * (1. - a), high = area * (1. + a) / 3.;
  for (unsigned int j = 0; j < cut.mass.size(); ++j)
    {
      dealii::Tensor<1, dim> divergence;
      for (unsigned int i = 0; i < cut.mass.size(); ++i)
        if (is_upper<dim>(i))
          divergence += cut.star_divergence[j][i];
      EXPECT_NEAR(divergence[dim - 1] * (1 << (dim - 1)),
                  is_upper<dim>(j) ? high : area - high,
                  1e-14);
    }
}



TYPED_TEST(CutCellTest, CondensedItConductsAsLayersInSeries)
{
  constexpr int dim = TypeParam::value;
  for (const double a : {1e-6, .2, .5, .9})
    {
      const Cells<dim> cells;
      const auto       cut       = cells.cut(flat<dim>(a));
      double           energy    = 0;
      const double     stiffness = Enrichment<dim>::stiffness(cut);
      for (unsigned int i = 0; i < cut.mass.size(); ++i)
        for (unsigned int j = 0; j < cut.mass.size(); ++j)
          if (is_upper<dim>(i) && is_upper<dim>(j))
            energy += cut.laplace[i][j] -
                      Enrichment<dim>::sum(cut.laplace_star[i]) *
                        Enrichment<dim>::sum(cut.laplace_star[j]) / stiffness;
      EXPECT_NEAR(energy * (a * rho[0] + (1. - a) * rho[1]), 1., 1e-12) << a;
    }
}



TYPED_TEST(CutCellTest, StarGradientAndStarDivergenceBelongTogether)
{
  // int N grad psi + int psi grad N is an integral over the cell's faces; a
  // constant N leaves one of them, and constants pass without divergence.
  constexpr int    dim = TypeParam::value;
  const Cells<dim> cells(2);
  for (const double level : {.35, .5, .8})
    for (unsigned int c = 0; c < cells.mesh.graph().n_owned_cells(); ++c)
      {
        const auto   plane = tilted<dim>(level);
        const double f     = plane.fraction(cells.cell(c).vertices[0], .5);
        if (f <= 0. || f >= 1.)
          continue;
        const auto             cut = cells.cut(plane, c);
        dealii::Tensor<1, dim> gradient, divergence;
        double                 laplace = 0;
        for (unsigned int v = 0; v < cut.mass.size(); ++v)
          {
            gradient += Enrichment<dim>::sum(cut.star_gradient[v]);
            divergence += Enrichment<dim>::sum(cut.star_divergence[v]);
            laplace += Enrichment<dim>::sum(cut.laplace_star[v]);
          }
        EXPECT_NEAR((gradient - Enrichment<dim>::sum(cut.star_load)).norm(),
                    0.,
                    1e-14);
        EXPECT_NEAR(divergence.norm(), 0., 1e-14);
        EXPECT_NEAR(laplace, 0., 1e-14);
      }
}



TYPED_TEST(CutCellTest, WithEqualDensitiesItIsAnOrdinaryCell)
{
  constexpr int            dim = TypeParam::value;
  const Cells<dim>         cells(2, true);
  Fluids                   alike;
  dealii::ParameterHandler prm;
  alike.declare_parameters(Section(prm));
  prm.parse_input_from_string(two_fluids(4., 4.));
  const Q1Integrals<dim> integrals;
  const auto             plane = tilted<dim>(.5);
  for (unsigned int c = 0; c < cells.mesh.graph().n_owned_cells(); ++c)
    {
      const auto phi = cells.nodal(plane, c);
      const auto cut = integrate_cut_cell<dim>(
        c, cells.cell(c), phi, phi, 1., alike, PressureEnrichment::none);
      const auto measure = integrals.node_measures(cells.cell(c));
      const auto laplace = integrals.laplace(cells.cell(c));
      EXPECT_FALSE(cut.enriched);
      for (unsigned int i = 0; i < measure.size(); ++i)
        {
          EXPECT_NEAR(cut.mass[i] / (4. * measure[i]), 1., 1e-13);
          for (unsigned int j = 0; j < measure.size(); ++j)
            EXPECT_NEAR(4. * cut.laplace[i][j], laplace[i][j], 1e-13);
        }
    }
}



TYPED_TEST(CutCellTest, FluidsLieInLayersForViscosity)
{
  constexpr int    dim   = TypeParam::value;
  const auto       plane = tilted<dim>(.55);
  const Cells<dim> cells;
  const auto       cut = cells.cut(plane);
  const double     f   = plane.fraction({}, 1.);
  EXPECT_NEAR(cut.negative_fraction, f, 1e-14);
  EXPECT_NEAR((cut.normal - plane.slope).norm(), 0., 1e-14);
  EXPECT_NEAR(cut.arithmetic_viscosity, f * mu[0] + (1. - f) * mu[1], 1e-13);
  EXPECT_NEAR(cut.harmonic_viscosity,
              1. / (f / mu[0] + (1. - f) / mu[1]),
              1e-13);
}



TYPED_TEST(CutCellTest, AnInterfaceThroughAVertexDoesNotEnrich)
{
  constexpr int    dim = TypeParam::value;
  const Cells<dim> cells;
  EXPECT_FALSE(cells.cut(tilted<dim>(1e-12)).enriched);
  EXPECT_TRUE(cells.cut(tilted<dim>(1e-2)).enriched);
}
