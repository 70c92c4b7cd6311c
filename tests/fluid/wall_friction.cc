// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/wall_friction.h>

#include "step_scene.h"
#include "support/dimensions.h"

using namespace Steps;

namespace
{
  template <typename T>
  class WallFrictionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(WallFrictionMpi, Dimensions);


  constexpr double wall_nu = .3;


  /// The greatest difference of wall_nu du/dn from a function at the nodes of
  /// faces whose outward normal is -y or x.
  template <int dim>
  double
  friction_error(const StepScene<dim>              &scene,
                 const typename Scene<dim>::Field  &flow,
                 const typename Scene<dim>::Scalar &at_bottom,
                 const typename Scene<dim>::Scalar &at_right)
  {
    WallFriction<dim> friction(scene.operators, scene.flow_boundary, wall_nu);
    const Vector      u       = scene.flow_velocity(flow);
    const auto       &found   = friction.find(u, scene.friction_of(u));
    double            largest = 0;
    const double     *value   = found.data();
    for (const auto &face : friction.faces())
      {
        const auto &cell =
          scene.V.mesh().graph().iterator(face.cell)->face(face.face_no);
        for (unsigned int k = 0; k < face.nodes.size(); ++k, value += dim)
          {
            const auto compare = [&](const bool is_at, const auto &exact) {
              if (is_at && k < cell->n_vertices())
                largest = std::max(largest,
                                   std::abs(value[0] - exact(cell->vertex(k))));
            };
            compare(cell->center()[1] < 1e-9, at_bottom);
            compare(cell->center()[0] > 1. - 1e-9, at_right);
          }
      }
    return max_of_all(largest);
  }
} // namespace



TYPED_TEST(WallFrictionMpi, QuadraticVelocitiesHaveTheirs)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int degree : {1u, 2u})
    {
      const StepScene<dim> scene(unit_box<dim>(4) + given_ends<dim>(),
                                 degree,
                                 degree,
                                 wall_nu);
      EXPECT_LT(friction_error<dim>(
                  scene,
                  poiseuille<dim>,
                  [](const auto &) { return -wall_nu; },
                  [](const auto &) { return 0.; }),
                1e-9)
        << degree;
    }
}



TYPED_TEST(WallFrictionMpi, SecondOrder)
{
  static constexpr int dim     = TypeParam::value;
  const auto           largest = [](const unsigned int n) {
    const StepScene<dim> scene(unit_box<dim>(n) +
                                 section("Boundary conditions",
                                         {"No slip = bottom, right, top"}),
                               1,
                               1,
                               wall_nu);
    return friction_error<dim>(
      scene,
      [](const auto &p) {
        dealii::Tensor<1, dim> u;
        u[0] = std::exp(p[1]) * std::cos(p[0]);
        return u;
      },
      [](const auto &p) { return -wall_nu * std::cos(p[0]); },
      [](const auto &p) { return -wall_nu * std::exp(p[1]) * std::sin(1.); });
  };
  const unsigned int n      = dim == 2 ? 16 : 6;
  const double       coarse = largest(n), fine = largest(2 * n);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}
