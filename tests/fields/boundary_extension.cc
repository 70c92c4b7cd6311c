// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/boundary_extension.h>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class BoundaryExtensionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(BoundaryExtensionMpi, Dimensions);


  /// A wall at the bottom, given velocities at the left.
  template <int dim>
  std::string
  conditions()
  {
    return section("Boundary conditions",
                   {"No slip = bottom",
                    std::string("Velocity = left: y; 0") +
                      (dim == 3 ? "; 0" : ""),
                    "Slip = top",
                    "Open = right: 0"});
  }


  /// The extension of a field that is @p function in the interior, and
  /// a large number at the boundary.
  template <int dim>
  Vector
  extend(const FlowScene<dim>             &scene,
         const typename Scene<dim>::Field &function)
  {
    const BoundaryExtension<dim> extension(scene.V, scene.flow_boundary);
    Vector                       field = scene.flow_velocity(function);
    for (const auto &entry : scene.flow_boundary.fixed().all())
      if (entry.kind != BoundaryKind::slip)
        for (unsigned int d = 0; d < dim; ++d)
          field.local_element(dim * entry.node + d) = 1e9;
    Vector result = scene.empty_velocity();
    extension.extend(field, result);
    return result;
  }
} // namespace



TYPED_TEST(BoundaryExtensionMpi, ConstantsReachBoundaryNodesAndNoOthers)
{
  static constexpr int dim = TypeParam::value;
  for (const unsigned int degree : {1u, 2u})
    {
      const FlowScene<dim> scene(hanging_box<dim>(3) + conditions<dim>(),
                                 degree,
                                 1);
      const Vector         extension = extend<dim>(scene, [](const auto &) {
        dealii::Tensor<1, dim> value;
        value[0] = 2.;
        value[1] = -3.;
        return value;
      });
      for_each_owned_node<dim>(
        scene.V, [&](const unsigned int n, const dealii::Point<dim> &p) {
          if (scene.V.is_dependent(n))
            return;
          const double at_boundary = p[0] < 1e-9 || p[1] < 1e-9 ? 1. : 0.;
          EXPECT_NEAR(extension.local_element(dim * n), 2. * at_boundary, 1e-12)
            << p;
          EXPECT_NEAR(extension.local_element(dim * n + 1),
                      -3. * at_boundary,
                      1e-12)
            << p;
        });
    }
}



TEST(BoundaryExtensionMpi2d, NodesGetTheMeanOfTheFreeOnesBesideThem)
{
  const FlowScene<2> scene(unit_box<2>(4) + conditions<2>(), 1, 1);
  const Vector       extension = extend<2>(scene, [](const auto &p) {
    dealii::Tensor<1, 2> value;
    value[0] = p[0];
    value[1] = p[1] * p[1];
    return value;
  });
  for_each_owned_node<2>(
    scene.V, [&](const unsigned int n, const dealii::Point<2> &p) {
      if (p[1] > 1e-9)
        return;
      // The corner has one free neighbour; its cell is that of the next node,
      // which has two cells.
      const double x = p[0] < 1e-9                   ? .25
                       : std::abs(p[0] - .25) < 1e-9 ? (.25 + .25 + .5) / 3.
                       : p[0] > 1. - 1e-9            ? .875
                                                     : p[0];
      EXPECT_NEAR(extension.local_element(2 * n), x, 1e-12) << p;
      EXPECT_NEAR(extension.local_element(2 * n + 1), .0625, 1e-12) << p;
    });
}
