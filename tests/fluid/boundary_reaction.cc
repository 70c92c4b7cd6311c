// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/boundary_reaction.h>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class BoundaryReactionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(BoundaryReactionMpi, Dimensions);

  const double density = 3.;


  /// The reaction of a step of one second.
  template <int dim>
  Vector
  reaction(const FlowScene<dim>         &scene,
           const double                  nu,
           const Vector                 &begin,
           const Vector                 &end,
           const Vector                 &pressure,
           const dealii::Tensor<1, dim> &body_force)
  {
    BoundaryReaction<dim> reaction(scene.operators, scene.flow_boundary, nu);
    Vector                result = scene.empty_velocity();
    reaction.find(begin,
                  end,
                  pressure,
                  scene.flow_velocity([&](const auto &) { return body_force; }),
                  1.,
                  density,
                  result);
    return result;
  }


  template <int dim>
  dealii::Tensor<1, dim>
  nothing(const dealii::Point<dim> &)
  {
    return {};
  }
} // namespace



TYPED_TEST(BoundaryReactionMpi, FluidAtRestWeighsOnTheGround)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    for (const std::string condition : {"slip", "no slip"})
      {
        const FlowScene<dim>   scene(unit_box<dim>(3) +
                                     section("Boundary conditions",
                                             {"Otherwise = " + condition,
                                                "Open = top: 0"}),
                                   k,
                                   l,
                                   Meshes::distort_and_refine<dim>);
        dealii::Tensor<1, dim> gravity;
        gravity[1]             = -10.;
        const Vector u         = scene.flow_velocity(nothing<dim>);
        const Vector F         = reaction(scene,
                                  .1,
                                  u,
                                  u,
                                  scene.flow_pressure([](const auto &p) {
                                    return 10. * (1. - p[1]);
                                  }),
                                  gravity);
        const auto   at_ground = [](const auto &p) { return p[1] < 1e-9; };
        const auto   all       = [](const auto &) { return true; };
        EXPECT_NEAR(scene.sum_where(F, 1, at_ground), -30., 1e-10);
        EXPECT_NEAR(scene.sum_where(F, 0, all), 0., 1e-10);
        EXPECT_NEAR(
          scene.sum_where(F, 0, [](const auto &p) { return p[0] > 1. - 1e-9; }),
          15.,
          1e-10);
      }
}



TYPED_TEST(BoundaryReactionMpi, PoiseuillesFlowDragsTheWalls)
{
  static constexpr int dim = TypeParam::value;
  const double         nu  = .3;
  const FlowScene<dim> scene(
    hanging_box<dim>(3, {"Periodic boundaries = left:right"}) +
      section("Boundary conditions", {"No slip = bottom, top"}),
    2,
    1);
  dealii::Tensor<1, dim> force;
  force[0]       = 2. * nu;
  const Vector u = scene.flow_velocity([](const auto &p) {
    dealii::Tensor<1, dim> v;
    v[0] = p[1] * (1. - p[1]);
    return v;
  });
  const Vector F =
    reaction(scene,
             nu,
             u,
             u,
             scene.flow_pressure([](const auto &) { return 4.; }),
             force);
  for (const double y : {0., 1.})
    {
      const auto at_wall = [&](const auto &p) {
        return std::abs(p[1] - y) < 1e-9;
      };
      EXPECT_NEAR(scene.sum_where(F, 0, at_wall), density * nu, 1e-11);
      EXPECT_NEAR(scene.sum_where(F, 1, at_wall),
                  density * 4. * (y > .5 ? 1. : -1.),
                  1e-11);
    }
  // Nothing elsewhere.
  scene.for_each_free_node(scene.V, [&](const unsigned int n, const auto &p) {
    if (p[1] > 1e-9 && p[1] < 1. - 1e-9)
      {
        const double largest =
          dim == 3 ? std::abs(scene.at(F, n)[0]) : scene.at(F, n).norm();
        EXPECT_EQ(largest, 0.) << p;
      }
  });
}



namespace
{
  /// The largest error of the traction along the ground, but for its ends,
  /// in a steady flow u = cos(2 y + 0.3) beneath a pressure that is linear.
  template <int dim>
  double
  error_at_ground(const unsigned int n, const unsigned int degree)
  {
    const double         nu = .3;
    const FlowScene<dim> scene(hanging_box<dim>(n) +
                                 section("Boundary conditions",
                                         {"Otherwise = no slip"}),
                               degree,
                               1);
    const Vector         u = scene.flow_velocity([](const auto &p) {
      dealii::Tensor<1, dim> v;
      v[0] = std::cos(2. * p[1] + .3);
      return v;
    });
    const Vector         p =
      scene.flow_pressure([](const auto &x) { return 2. + 3. * x[0] - x[1]; });
    const Vector          force = scene.flow_velocity([&](const auto &x) {
      dealii::Tensor<1, dim> b;
      b[0] = 3. + 4. * nu * std::cos(2. * x[1] + .3);
      b[1] = -1.;
      return b;
    });
    BoundaryReaction<dim> of_fluid(scene.operators, scene.flow_boundary, nu);
    Vector                F = scene.empty_velocity();
    Vector                t = scene.empty_velocity();
    of_fluid.find(u, u, p, force, 1., density, F);
    of_fluid.find_traction(F, p, density, t);
    double error = 0.;
    scene.for_each_free_node(
      scene.V, [&](const unsigned int node, const auto &x) {
        bool inside = x[1] < 1e-9;
        for (unsigned int d = 0; d < dim; ++d)
          inside = inside && (d == 1 || std::abs(x[d] - .5) < .3);
        if (inside)
          error = std::max(error,
                           std::abs(scene.at(t, node)[0] +
                                    2. * density * nu * std::sin(.3)));
      });
    return max_of_all(error);
  }
} // namespace



TYPED_TEST(BoundaryReactionMpi, TractionIsOfSecondOrder)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int degree : {1u, 2u})
    {
      const double coarse = error_at_ground<dim>(4, degree);
      const double fine   = error_at_ground<dim>(8, degree);
      // A quarter of what the stress in the middle of the first cell misses.
      EXPECT_LT(coarse, .25 * density * .3 * 4. * std::cos(.3) * .25 / 2.);
      EXPECT_GT(std::log2(coarse / fine), 1.8);
    }
}



TYPED_TEST(BoundaryReactionMpi, AccelerationAndConvectionNeedForces)
{
  // All nodes of a single cell of degree 1 are at the boundary: their sum is
  // the balance of momentum of the whole box.
  static constexpr int dim = TypeParam::value;
  const FlowScene<dim> scene(unit_box<dim>(1) +
                               section("Boundary conditions",
                                       {"Otherwise = no slip"}),
                             1,
                             1);
  const auto           begin = [](const auto &p) {
    return dealii::Tensor<1, dim>(some_matrix<dim>() * p);
  };
  dealii::Tensor<1, dim> acceleration;
  for (unsigned int d = 0; d < dim; ++d)
    acceleration[d] = 2. + d;
  const Vector F =
    reaction(scene,
             .1,
             scene.flow_velocity(begin),
             scene.flow_velocity(
               [&](const auto &p) { return begin(p) + acceleration; }),
             scene.flow_pressure([](const auto &) { return 0.; }),
             dealii::Tensor<1, dim>());
  dealii::Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = .5;
  const dealii::Tensor<1, dim> wanted =
    -density *
    (acceleration + some_matrix<dim>() * (begin(centre) + .5 * acceleration));
  for (unsigned int d = 0; d < dim; ++d)
    EXPECT_NEAR(scene.sum_where(F, d, [](const auto &) { return true; }),
                wanted[d],
                1e-11);
}
