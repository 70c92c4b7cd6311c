// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/operator_solver.h>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class CellOperatorMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(CellOperatorMpi, Dimensions);

  const std::string open_side =
    section("Boundary conditions", {"No slip = left, bottom", "Open = top: 0"});


  template <int dim>
  FlowScene<dim>
  bent(const unsigned int degree)
  {
    return FlowScene<dim>(unit_box<dim>(3) + open_side,
                          degree,
                          1,
                          Meshes::distort_and_refine<dim>);
  }


  /// A source without any pattern and its product.
  template <int dim>
  Vector
  product(const FlowScene<dim>    &scene,
          const CellOperator<dim> &A,
          const Vector            &source)
  {
    Vector result = scene.empty_velocity();
    A.add_product(source, result, dim, 1.);
    scene.V.fold(result, dim);
    return result;
  }


  /// The greatest difference at nodes that depend on no others.
  template <int dim>
  double
  difference(const FlowScene<dim> &scene, const Vector &a, const Vector &b)
  {
    double largest = 0;
    scene.for_each_free_node(scene.V, [&](const unsigned int n, const auto &) {
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest,
                           std::abs(a.local_element(dim * n + d) -
                                    b.local_element(dim * n + d)));
    });
    return max_of_all(largest);
  }
} // namespace



TYPED_TEST(CellOperatorMpi, ActsOnEachComponentAlike)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int degree : {1u, 2u})
    {
      const auto          scene = bent<dim>(degree);
      const auto         &K     = scene.operators.stiffness;
      const Vector        u     = scene.flow_velocity(wild<dim>);
      const Vector        Ku    = product(scene, K, u);
      std::vector<double> factors(scene.mesh.graph().n_owned_cells(), 3.);
      for (unsigned int d = 0; d < dim; ++d)
        {
          Vector component = nodal_scalar<dim>(scene.V, [&](const auto &p) {
            return wild(p)[d];
          });
          Vector result;
          scene.V.initialize(result, 1);
          K.add_product(component, result, 1, .5, factors.data());
          scene.V.fold(result, 1);
          for (unsigned int n = 0; n < scene.V.n_owned_nodes(); ++n)
            EXPECT_NEAR(result.local_element(n),
                        1.5 * Ku.local_element(dim * n + d),
                        1e-12);
        }
    }
}



TYPED_TEST(CellOperatorMpi, CombinationsAndDiagonalsAreThoseOfTheMatrices)
{
  constexpr int     dim   = TypeParam::value;
  const auto        scene = bent<dim>(2);
  const auto       &M     = scene.operators.mass;
  const auto       &K     = scene.operators.stiffness;
  CellOperator<dim> A(scene.V);
  A.combine(2., M, .25, K);
  const Vector u      = scene.flow_velocity(wild<dim>);
  Vector       wanted = product(scene, M, u);
  wanted *= 2.;
  wanted.add(.25, product(scene, K, u));
  EXPECT_LT(difference(scene, product(scene, A, u), wanted), 1e-13);

  Vector diagonal = scene.empty_velocity();
  A.add_diagonal(diagonal, dim);
  double trace = 0;
  for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
    for (unsigned int i = 0; i < A.size(); ++i)
      trace += dim * A.matrix(A.shape(c))[i * A.size() + i];
  double sum = 0;
  for (unsigned int i = 0; i < dim * scene.V.dependences().n_nodes(); ++i)
    sum += diagonal.local_element(i);
  EXPECT_NEAR(sum, trace, 1e-10);
}



TYPED_TEST(CellOperatorMpi, TheSolverInvertsTheMatrix)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int degree : {1u, 2u})
    {
      const auto                scene = bent<dim>(degree);
      const OperatorSolver<dim> solver(scene.operators.mass, dim);
      const Vector              u = scene.flow_velocity(wild<dim>);
      Vector                    b = u;
      solver.multiply(b);
      EXPECT_LT(difference(scene, b, product(scene, scene.operators.mass, u)),
                1e-14);
      Vector x = scene.empty_velocity();
      solver.solve(x, b, 1e-13, 1000, "a test");
      EXPECT_LT(difference(scene, x, u), 1e-10);
      // Hanging nodes and ghosts as well.
      for (unsigned int i = 0; i < dim * scene.V.dependences().n_nodes(); ++i)
        EXPECT_NEAR(x.local_element(i), u.local_element(i), 1e-10);
      // A good guess costs nothing.
      Vector again = u;
      solver.multiply(again);
      EXPECT_EQ(solver.solve(x, again, 1e-8, 1000, "a test").iterations, 0u);
    }
}



TYPED_TEST(CellOperatorMpi, WhatIsFixedStaysZero)
{
  constexpr int             dim   = TypeParam::value;
  const auto                scene = bent<dim>(2);
  const auto               &A     = scene.operators.mass;
  const auto               &fixed = scene.flow_boundary;
  const OperatorSolver<dim> solver(A, dim, [&](Vector &vector) {
    fixed.project(vector);
  });
  Vector b = product(scene, A, scene.flow_velocity(wild<dim>)), x = b;
  Vector wanted = b;
  x.update_ghost_values();
  solver.solve(x, b, 1e-12, 1000, "a test");
  Vector projected = x;
  fixed.project(projected);
  EXPECT_EQ(difference(scene, x, projected), 0.);
  EXPECT_GT(x.linfty_norm(), .1);
  // The equation holds for all else.
  Vector residual = product(scene, A, x);
  residual.add(-1., wanted);
  fixed.project(residual);
  EXPECT_LT(difference(scene, residual, scene.empty_velocity()), 1e-12);
}



TEST(OperatorSolver, SaysWhatItDidNotFind)
{
  const auto              scene = bent<2>(2);
  const OperatorSolver<2> solver(scene.operators.mass, 2);
  Vector b = product(scene, scene.operators.mass, scene.flow_velocity(wild<2>));
  Vector x = scene.empty_velocity();
  EXPECT_THROW(solver.solve(x, b, 1e-12, 2, "a test"), StepFailure);
  // Nothing to solve for; or nothing that counts.
  Vector tiny = b;
  tiny *= 1e-12;
  x = 0.;
  EXPECT_EQ(solver.solve(x, tiny, 1e-8, 2, "a test", b.l2_norm()).iterations,
            0u);
  b = 0.;
  x = scene.flow_velocity(wild<2>);
  EXPECT_EQ(solver.solve(x, b, 1e-8, 2, "a test").iterations, 0u);
  EXPECT_EQ(x.linfty_norm(), 0.);
}
