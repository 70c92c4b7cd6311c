// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/convective_term.h>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class FlowOperatorsMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(FlowOperatorsMpi, Dimensions);

  template <typename T>
  class ConvectiveTermMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ConvectiveTermMpi, Dimensions);

  const std::string walls =
    section("Boundary conditions", {"Otherwise = no slip"});


  /// A bent mesh with hanging nodes in the unit box.
  template <int dim>
  FlowScene<dim>
  bent(const unsigned int velocity_degree,
       const unsigned int pressure_degree,
       const std::string &conditions = walls)
  {
    return FlowScene<dim>(unit_box<dim>(3) + conditions,
                          velocity_degree,
                          pressure_degree,
                          Meshes::distort_and_refine<dim>);
  }


  /// Sheared cells of two sizes.
  template <int dim>
  void
  shear_and_refine(Mesh<dim> &mesh)
  {
    Meshes::shear(mesh);
    Meshes::refine_around(mesh, dealii::Point<dim>(), .7);
  }


  double
  dot(const Vector &a, const Vector &b)
  {
    double sum = 0;
    for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
      sum += a.local_element(i) * b.local_element(i);
    return sum_of_all(sum);
  }


  template <int dim>
  dealii::Tensor<1, dim>
  linear(const dealii::Point<dim> &p)
  {
    dealii::Tensor<1, dim> u = some_matrix<dim>() * p;
    u[0] += 2.;
    return u;
  }


  template <int dim>
  dealii::Tensor<1, dim>
  slope()
  {
    dealii::Tensor<1, dim> g;
    for (unsigned int d = 0; d < dim; ++d)
      g[d] = 1. - 3. * d;
    return g;
  }


  template <int dim>
  double
  linear_pressure(const dealii::Point<dim> &p)
  {
    return slope<dim>() * p - 4.;
  }


  /// A pressure without any pattern.
  template <int dim>
  double
  wild_pressure(const dealii::Point<dim> &p)
  {
    return wild(p)[0];
  }
} // namespace



TYPED_TEST(FlowOperatorsMpi, LinearVelocitiesHaveViscousForcesAtWallsOnly)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const auto   scene = bent<dim>(k, l);
      const Vector u     = scene.flow_velocity(linear<dim>);
      Vector       force = scene.empty_velocity(), stiff = force;
      for (Vector *vector : {&force, &stiff})
        scene.operators.stiffness.add_product(u, *vector, dim, 1.);
      scene.V.fold(stiff, dim);
      // The energy of the gradient; the box has a volume of one.
      EXPECT_NEAR(dot(stiff, u), some_matrix<dim>().norm_square(), 1e-11);
      double inside = 0;
      scene.for_each_free_node(scene.V,
                               [&](const unsigned int n, const auto &p) {
                                 if (!on_side_of_unit_box(p))
                                   inside = std::max(inside,
                                                     scene.at(stiff, n).norm());
                               });
      EXPECT_LT(inside, 1e-13);
      EXPECT_GT(max_of_all(stiff.linfty_norm()), .01);
      // With the forces of the walls nothing is left.
      scene.operators.add_boundary_gradient(u, force, -1.);
      scene.V.fold(force, dim);
      EXPECT_LT(max_of_all(force.linfty_norm()), 1e-13);
    }
}



TYPED_TEST(FlowOperatorsMpi, BoundaryGradientsCountWhereTheVelocityIsFixed)
{
  constexpr int     dim = TypeParam::value;
  const std::string given(dim == 2 ? "1; 0" : "1; 0; 0");
  for (const auto &[k, l] : degree_pairs())
    {
      const auto scene = bent<dim>(k,
                                   l,
                                   section("Boundary conditions",
                                           {"No slip = top",
                                            "Velocity = left: " + given,
                                            "Open = right: 0"}));
      Vector     force = scene.empty_velocity();
      scene.operators.add_boundary_gradient(scene.flow_velocity(linear<dim>),
                                            force,
                                            2.);
      scene.V.fold(force, dim);
      const auto A = some_matrix<dim>();
      for (unsigned int d = 0; d < dim; ++d)
        EXPECT_NEAR(scene.sum_where(force,
                                    d,
                                    [](const auto &) { return true; }),
                    2. * (A[d][1] - A[d][0]),
                    1e-12);
    }
}



TYPED_TEST(FlowOperatorsMpi, LinearPressuresHaveTheirGradient)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const auto scene = bent<dim>(k, l);
      Vector     force = scene.empty_velocity();
      scene.operators.add_gradient(scene.flow_pressure(linear_pressure<dim>),
                                   force,
                                   1.);
      scene.operators.mass.add_product(scene.flow_velocity([](const auto &) {
        return slope<dim>();
      }),
                                       force,
                                       dim,
                                       -1.);
      EXPECT_LT(max_of_all(force.linfty_norm()), 1e-13);
    }
}



TYPED_TEST(FlowOperatorsMpi, LinearVelocitiesHaveTheirDivergence)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const auto scene  = bent<dim>(k, l);
      Vector     result = scene.empty_pressure();
      scene.operators.add_divergence(scene.flow_velocity(linear<dim>),
                                     result,
                                     1.);
      scene.operators.pressure_mass.add_product(
        scene.flow_pressure(
          [](const auto &) { return trace(some_matrix<dim>()); }),
        result,
        1,
        1.);
      EXPECT_LT(max_of_all(result.linfty_norm()), 1e-13);
    }
}



TYPED_TEST(FlowOperatorsMpi, OperatorsComeInPairs)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const auto   scene = bent<dim>(k, l);
      const auto  &op    = scene.operators;
      const Vector u     = scene.flow_velocity(wild<dim>);
      const Vector p     = scene.flow_pressure(wild_pressure<dim>);
      const auto   force = [&](const auto &add) {
        Vector f = scene.empty_velocity();
        add(f);
        scene.V.fold(f, dim);
        return dot(f, u);
      };
      const auto source = [&](const auto &add, const Vector &pressure) {
        Vector s = scene.empty_pressure();
        add(s);
        scene.P.fold(s, 1);
        return dot(s, pressure);
      };
      const double gradient =
        force([&](Vector &f) { op.add_gradient(p, f, 2.); });
      EXPECT_NEAR(source([&](Vector &s) { op.add_weak_gradient(u, s, 2.); }, p),
                  gradient,
                  1e-12);
      const double divergence =
        source([&](Vector &s) { op.add_divergence(u, s, 2.); }, p);
      EXPECT_NEAR(force([&](Vector &f) { op.add_pressure_force(p, f, 2.); }),
                  divergence,
                  1e-12);
      EXPECT_GT(std::abs(gradient), 1e-3);
      const std::vector<double> twice(op.cell_lengths().size(), 2.);
      EXPECT_NEAR(
        source([&](Vector &s) { op.add_weak_gradient(u, s, 1., twice.data()); },
               p),
        gradient,
        1e-12);

      // Without flow through the walls D is the transpose of G.
      Vector enclosed = u;
      enclosed.zero_out_ghost_values();
      scene.flow_boundary.project(enclosed);
      scene.V.interpolate(enclosed, dim);
      EXPECT_NEAR(
        source([&](Vector &s) { op.add_divergence(enclosed, s, 1.); }, p),
        source([&](Vector &s) { op.add_weak_gradient(enclosed, s, 1.); }, p),
        1e-12);
    }
}



TYPED_TEST(FlowOperatorsMpi, MassesSumUpToTheVolume)
{
  constexpr int dim = TypeParam::value;
  for (const bool lumped : {false, true})
    for (const auto &[k, l] : degree_pairs())
      {
        const FlowScene<dim> scene(
          hanging_box<dim>(3) + walls, k, l, {}, lumped);
        const auto &M    = scene.operators.mass;
        const auto  ones = [](const auto &) { return 1.; };
        Vector      mass;
        scene.V.initialize(mass, 1);
        M.add_product(nodal_scalar<dim>(scene.V, ones), mass, 1, 1.);
        scene.V.fold(mass, 1);
        EXPECT_NEAR(dot(mass, nodal_scalar<dim>(scene.V, ones)), 1., 1e-12);
        double largest = 0;
        for (unsigned int i = 0; i < M.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            largest =
              std::max(largest, std::abs(M.matrix(0)[i * M.size() + j]));
        if (lumped)
          EXPECT_LT(largest, 1e-16);
        else
          EXPECT_GT(largest, 1e-6);
      }
}



TYPED_TEST(FlowOperatorsMpi, CellsOfTheSameShapeShareMatrices)
{
  constexpr int        dim = TypeParam::value;
  const FlowScene<dim> boxes(unit_box<dim>(8, "if(x < 0.3, 1, 0)"), 2, 1);
  double               finest = 1.;
  for (const double length : boxes.operators.cell_lengths())
    finest = std::min(finest, length);
  EXPECT_NEAR(-max_of_all(-finest), 1. / 16., 1e-14);
  EXPECT_LE(boxes.operators.mass.n_shapes(), 2u);
  const auto others = bent<dim>(2, 1);
  EXPECT_GT(sum_of_all(others.operators.mass.n_shapes()), 5.);
}



TYPED_TEST(ConvectiveTermMpi, LinearVelocitiesHaveTheirAcceleration)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const FlowScene<dim>      scene(hanging_box<dim>(3) + walls,
                                 k,
                                 l,
                                 shear_and_refine<dim>);
      const ConvectiveTerm<dim> convection(scene.operators);
      Vector                    result = scene.empty_velocity();
      convection.add(scene.flow_velocity(linear<dim>), result, 1.);
      EXPECT_GT(max_of_all(result.linfty_norm()), 1e-3);
      scene.operators.mass.add_product(scene.flow_velocity([](const auto &p) {
        return some_matrix<dim>() * linear(p);
      }),
                                       result,
                                       dim,
                                       -1.);
      scene.V.fold(result, dim);
      EXPECT_LT(max_of_all(result.linfty_norm()), 1e-13);
    }
}



TYPED_TEST(ConvectiveTermMpi, AgreesWithAnIntegralByHand)
{
  static constexpr int      dim = TypeParam::value;
  const FlowScene<dim>      scene(hanging_box<dim>(3) + walls, 2, 1);
  const ConvectiveTerm<dim> convection(scene.operators);
  Vector                    result = scene.empty_velocity();
  convection.add(scene.flow_velocity([](const auto &p) {
    dealii::Tensor<1, dim> u;
    u[0] = p[1] * p[1];
    u[1] = p[0] * p[0];
    return u;
  }),
                 result,
                 3.);
  scene.V.fold(result, dim);
  // V . grad V = (2 y x^2, 2 x y^2)
  const auto in_direction = [&](const unsigned int d, const auto &weight) {
    return dot(result, scene.flow_velocity([&](const auto &p) {
      dealii::Tensor<1, dim> v;
      v[d] = weight(p);
      return v;
    }));
  };
  EXPECT_NEAR(in_direction(0, [](const auto &) { return 1.; }), 1., 1e-12);
  EXPECT_NEAR(in_direction(1, [](const auto &) { return 1.; }), 1., 1e-12);
  EXPECT_NEAR(in_direction(0, [](const auto &p) { return p[0]; }), .75, 1e-12);
  EXPECT_NEAR(in_direction(1, [](const auto &p) { return p[0]; }),
              2. / 3.,
              1e-12);
}
