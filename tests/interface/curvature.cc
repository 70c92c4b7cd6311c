// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/curvature.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class CurvatureMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(CurvatureMpi, Dimensions);

  using Angles = std::map<dealii::types::boundary_id, double>;

  template <int dim>
  dealii::Point<dim>
  somewhere()
  {
    return dim == 2 ? dealii::Point<dim>(.513, .479)
                    : dealii::Point<dim>(.513, .479, .507);
  }

  /// The largest error of a ball's curvature at nodes that an edge is away from
  /// it at most, in parts of it.
  /// @param distance what is known of the distance from it
  template <int dim>
  double
  error_of_ball(const Scene<dim> &scene,
                const Vector     &distance,
                const double      radius,
                const Angles     &angles = {})
  {
    Vector curvature, weight;
    Curvature<dim>(*scene.space, angles).find(distance, curvature, weight);
    const double edge    = scene.phase->shortest_edge();
    double       largest = 0.;
    scene.for_each_node([&](const unsigned int n, const auto &) {
      if (std::abs(distance.local_element(n)) < edge)
        {
          EXPECT_EQ(weight.local_element(n), 1.);
          largest =
            std::max(largest,
                     std::abs(curvature.local_element(n) * radius / (dim - 1) -
                              1.));
        }
    });
    return max_of_all(largest);
  }

  /// The exact distance.
  template <int dim>
  typename Scene<dim>::Scalar
  distance_from_ball(const dealii::Point<dim> &center, const double radius)
  {
    return [=](const auto &x) { return x.distance(center) - radius; };
  }

  constexpr double radius = .31;
} // namespace



TYPED_TEST(CurvatureMpi, ThatOfABallIsOfSecondOrder)
{
  constexpr int dim = TypeParam::value;
  double        exact[2], of_contour[2];
  for (const unsigned int i : {0, 1})
    {
      const Scene<dim> scene(unit_box<dim>((dim == 2 ? 20 : 12) << i));
      const auto distance = distance_from_ball<dim>(somewhere<dim>(), radius);
      exact[i] = error_of_ball<dim>(scene, scene.scalar(distance), radius);
      scene.set_phases(distance);
      of_contour[i] =
        error_of_ball<dim>(scene, scene.phase->level_set(), radius);
    }
  EXPECT_GT(std::log2(exact[0] / exact[1]), 1.6) << exact[0] << ' ' << exact[1];
  EXPECT_LT(exact[1], dim == 2 ? 4e-3 : 2e-2);
  EXPECT_LT(of_contour[1], .05) << of_contour[0];
}



// A ball that the bottom cuts at an angle: the error is that of a node at the
// contact line.
TYPED_TEST(CurvatureMpi, WallsHaveTheAngleThatIsGiven)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(dim == 2 ? 40 : 24));
  const auto       bottom = scene.mesh.boundary_id("bottom");
  for (const double degrees : {60., 90., 120.})
    {
      const double angle  = degrees * dealii::numbers::PI / 180.;
      auto         center = somewhere<dim>();
      center[1]           = -radius * std::cos(angle);
      const Vector distance =
        scene.scalar(distance_from_ball<dim>(center, radius));
      EXPECT_LT(error_of_ball<dim>(scene, distance, radius, {{bottom, angle}}),
                .2)
        << degrees;
      EXPECT_GT(
        error_of_ball<dim>(scene, distance, radius, {{bottom, angle - .5}}), .3)
        << degrees;
    }
}



TYPED_TEST(CurvatureMpi, MeshesMayBeTurnedAndHaveHangingNodes)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> turned(
    unit_box<dim>(dim == 2 ? 40 : 20), [](Mesh<dim> &mesh) {
      Meshes::transform<dim>(mesh, [](const dealii::Point<dim> &x) {
        auto         y = x;
        const double c = std::cos(.5), s = std::sin(.5);
        y[0] = .5 + c * (x[0] - .5) - s * (x[1] - .5);
        y[1] = .5 + s * (x[0] - .5) + c * (x[1] - .5);
        return y;
      });
    });
  const auto distance = distance_from_ball<dim>(somewhere<dim>(), radius);
  EXPECT_LT(error_of_ball<dim>(turned, turned.scalar(distance), radius), .02);
  const Scene<dim> hanging(hanging_box<dim>(dim == 2 ? 20 : 10));
  EXPECT_LT(error_of_ball<dim>(hanging, hanging.scalar(distance), radius), .3);
}
