// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_integrals.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class Q1IntegralsTest : public testing::Test
  {};
  TYPED_TEST_SUITE(Q1IntegralsTest, Dimensions);

  /// The locally owned cells of bent, of sheared and of plain boxes.
  template <int dim, typename Visitor>
  void
  for_each_cell(const Visitor &visit)
  {
    for (const auto &change :
         {typename Scene<dim>::MeshChange(),
          typename Scene<dim>::MeshChange(Meshes::shear<dim>),
          typename Scene<dim>::MeshChange(Meshes::distort_and_refine<dim>)})
      {
        const Scene<dim> scene(unit_box<dim>(3), change);
        for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
          visit(scene.mesh.graph().cell(c),
                scene.mesh.graph().iterator(c)->measure());
      }
  }


  /// The slopes of a linear function.
  template <int dim>
  dealii::Tensor<1, dim>
  slope(const unsigned int which)
  {
    dealii::Tensor<1, dim> g;
    for (unsigned int d = 0; d < dim; ++d)
      g[d] = std::cos(2. * d + which);
    return g;
  }


  template <int dim>
  std::array<double, (1 << dim)>
  nodal(const typename CellGraph<dim>::Cell &cell,
        const dealii::Tensor<1, dim>        &slope)
  {
    std::array<double, (1 << dim)> values;
    for (unsigned int v = 0; v < values.size(); ++v)
      values[v] = 3. + slope * cell.vertices[v];
    return values;
  }
} // namespace



TYPED_TEST(Q1IntegralsTest, ShapeFunctionsAddUpToTheMeasure)
{
  constexpr int          dim = TypeParam::value;
  const Q1Integrals<dim> integrals;
  for_each_cell<dim>([&](const auto &cell, const double measure) {
    double sum = 0;
    for (const double value : integrals.node_measures(cell))
      sum += value;
    EXPECT_NEAR(sum, measure, 1e-14);
    EXPECT_NEAR(cell.measure, measure, 1e-14);
  });
}



TYPED_TEST(Q1IntegralsTest, GradientsOfLinearFunctionsAreExactOnBentCells)
{
  constexpr int          dim = TypeParam::value;
  const Q1Integrals<dim> integrals;
  const auto             g = slope<dim>(0), h = slope<dim>(1);
  for_each_cell<dim>([&](const auto &cell, const double measure) {
    const auto             p = nodal<dim>(cell, g), q = nodal<dim>(cell, h);
    const auto             gradients = integrals.gradient_integrals(cell);
    const auto             laplace   = integrals.laplace(cell);
    dealii::Tensor<1, dim> gradient;
    double                 energy = 0;
    for (unsigned int i = 0; i < p.size(); ++i)
      {
        double row = 0;
        gradient += p[i] * gradients[i];
        for (unsigned int j = 0; j < p.size(); ++j)
          {
            energy += p[i] * laplace[i][j] * q[j];
            row += laplace[i][j];
            EXPECT_NEAR(laplace[i][j], laplace[j][i], 1e-14);
          }
        EXPECT_NEAR(row, 0., 1e-14);
      }
    EXPECT_NEAR((gradient - measure * g).norm(), 0., 1e-14);
    EXPECT_NEAR(energy, measure * (g * h), 1e-14);
  });
}



TYPED_TEST(Q1IntegralsTest, GradientIsTheTransposeOfDivergence)
{
  constexpr int          dim = TypeParam::value;
  const Q1Integrals<dim> integrals;
  for_each_cell<dim>([&](const auto &cell, const double) {
    typename Q1Integrals<dim>::template PerVertex<double> p{}, divergence{};
    typename Q1Integrals<dim>::Velocity                   u{}, gradient{};
    for (unsigned int i = 0; i < p.size(); ++i)
      p[i] = std::sin(5. * i);
    for (unsigned int i = 0; i < u.size(); ++i)
      u[i] = std::cos(3. * i);
    integrals.add_divergence(cell, u, divergence);
    integrals.add_gradient(cell, p, gradient);
    double difference = 0;
    for (unsigned int i = 0; i < p.size(); ++i)
      difference += p[i] * divergence[i];
    for (unsigned int i = 0; i < u.size(); ++i)
      difference -= u[i] * gradient[i];
    EXPECT_NEAR(difference, 0., 1e-15);
  });
}



TYPED_TEST(Q1IntegralsTest, LinearPressuresHaveTheirGradientOnBentCells)
{
  constexpr int          dim = TypeParam::value;
  const Q1Integrals<dim> integrals;
  const auto             g = slope<dim>(0);
  for_each_cell<dim>([&](const auto &cell, const double) {
    typename Q1Integrals<dim>::Velocity gradient{};
    integrals.add_gradient(cell, nodal<dim>(cell, g), gradient);
    const auto measures = integrals.node_measures(cell);
    for (unsigned int i = 0; i < measures.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        EXPECT_NEAR(gradient[dim * i + d], measures[i] * g[d], 1e-15);
  });
}



TEST(Q1Integrals, StiffnessOfASquareAndOfACube)
{
  // [distance of the nodes in edges]
  const double square[3] = {2. / 3., -1. / 6., -1. / 3.};
  const double cube[4]   = {1. / 3., 0., -1. / 12., -1. / 12.};
  const auto   edges     = [](const unsigned int i, const unsigned int j) {
    return __builtin_popcount(i ^ j);
  };
  const Scene<2> plane(unit_box<2>(4));
  const Scene<3> space(unit_box<3>(4));
  if (plane.mesh.graph().n_owned_cells() > 0)
    {
      const auto matrix = Q1Integrals<2>().laplace(plane.mesh.graph().cell(0));
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          EXPECT_NEAR(matrix[i][j], square[edges(i, j)], 1e-15);
    }
  if (space.mesh.graph().n_owned_cells() > 0)
    {
      const auto matrix = Q1Integrals<3>().laplace(space.mesh.graph().cell(0));
      for (unsigned int i = 0; i < 8; ++i)
        for (unsigned int j = 0; j < 8; ++j)
          EXPECT_NEAR(matrix[i][j], .25 * cube[edges(i, j)], 1e-15);
    }
}
