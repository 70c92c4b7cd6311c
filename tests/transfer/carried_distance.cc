// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/transfer/carried_distance.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"
#include "transfer/particle_scene.h"

using namespace Thalweg;
using namespace ParticleScenes;

namespace
{
  template <typename T>
  class CarriedDistanceMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(CarriedDistanceMpi, Dimensions);


  /// The distance from a plane that cuts the unit box at an angle.
  template <int dim>
  struct Plane
  {
    Plane()
    {
      normal[0]       = .3;
      normal[dim - 1] = 1.;
      normal /= normal.norm();
    }

    double
    operator()(const dealii::Point<dim> &x) const
    {
      return normal * x - .52;
    }

    dealii::Tensor<1, dim> normal;
  };


  template <int dim>
  std::unique_ptr<Scene<dim>>
  hanging()
  {
    return std::make_unique<Scene<dim>>(hanging_box<dim>(4));
  }


  /// Particles that carry @p distance, after the step @p dt in @p velocity;
  /// calls @p visit with the place and the value of each that stands within
  /// the shortest edge of the interface.
  template <int dim, typename Distance, typename Velocity, typename Visit>
  void
  carry(Scene<dim>     &scene,
        const Distance &distance,
        const Velocity &velocity,
        const double    dt,
        const Visit    &visit)
  {
    fill(scene, .6);
    for (auto &particle : scene.population->particles())
      particle.properties()[Population<dim>::level_set_offset] =
        distance(particle.position());
    CarriedDistance<dim> carried(*scene.space);
    carried.find_rates(scene.scalar(distance), scene.velocity(velocity));
    carried.apply(*scene.population, dt);
    const double band = scene.mesh.graph().minimal_extent();
    unsigned int n    = 0;
    for (const auto &particle : scene.population->particles())
      if (std::abs(distance(particle.position())) < band)
        {
          visit(particle.position(),
                particle.properties()[Population<dim>::level_set_offset]);
          ++n;
        }
    EXPECT_GT(sum_of_all(n), 10.);
  }
} // namespace



TYPED_TEST(CarriedDistanceMpi, ARigidMotionChangesNothing)
{
  constexpr int    dim = TypeParam::value;
  const Plane<dim> plane;
  for (auto &scene : {bent<dim>(), hanging<dim>()})
    carry(
      *scene,
      plane,
      [&](const dealii::Point<dim> &x) {
        dealii::Tensor<1, dim> u;
        u[0]       = 2. - 3. * x[dim - 1];
        u[dim - 1] = 1. + 3. * x[0];
        return u;
      },
      .1,
      [&](const auto &x, const double value) {
        EXPECT_NEAR(value, plane(x), 1e-13) << x;
      });
}



TYPED_TEST(CarriedDistanceMpi, WhereTheFluidStretchesDistancesGrow)
{
  constexpr int    dim = TypeParam::value;
  const Plane<dim> plane;
  for (auto &scene : {bent<dim>(), hanging<dim>()})
    carry(
      *scene,
      plane,
      [&](const dealii::Point<dim> &x) {
        return 2. * plane(x) * plane.normal + 5. * dealii::Tensor<1, dim>(x);
      },
      .01,
      [&](const auto &x, const double value) {
        EXPECT_NEAR(value, std::exp(.07) * plane(x), 1e-12) << x;
      });
}



TYPED_TEST(CarriedDistanceMpi, ItFollowsAVelocityWithAKinkOnBothSides)
{
  // Fluid comes to a level interface from both sides: V = -s |z| at the
  // nodes, and between the two rows of nodes beside it the same everywhere.
  constexpr int    dim = TypeParam::value;
  constexpr double h = .125, dt = .01, s = 3.;
  Scene<dim>       scene(unit_box<dim>(8));
  carry(
    scene,
    [](const dealii::Point<dim> &x) { return x[dim - 1] - .5 - .5 * h; },
    [&](const dealii::Point<dim> &x) {
      dealii::Tensor<1, dim> u;
      u[dim - 1] = -s * std::abs(x[dim - 1] - .5 - .5 * h);
      return u;
    },
    dt,
    [&](const auto &x, const double value) {
      const double z = x[dim - 1] - .5 - .5 * h;
      const double r = -s * std::max(0., std::abs(z) - .5 * h);
      EXPECT_NEAR(value, z * std::exp(dt * r / z), 1e-12) << x;
    });
}



TYPED_TEST(CarriedDistanceMpi, TheSideNeverChanges)
{
  constexpr int    dim = TypeParam::value;
  const Plane<dim> plane;
  Scene<dim>       scene(unit_box<dim>(8));
  carry(
    scene,
    plane,
    [&](const dealii::Point<dim> &x) {
      dealii::Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = 10. * std::sin(40. * x[d] + d);
      return u;
    },
    1.,
    [&](const auto &x, const double value) {
      EXPECT_EQ(value < 0, plane(x) < 0) << x;
      EXPECT_TRUE(std::isfinite(value)) << x;
    });
}
