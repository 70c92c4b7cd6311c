// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/seeding.h>
#include <thalweg/transfer/projection.h>

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
  class MomentumProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(MomentumProjectionMpi, Dimensions);


  template <int dim>
  Vector
  velocity_of(const Scene<dim> &scene)
  {
    Vector velocity;
    scene.space->initialize_velocity(velocity);
    project_momentum(*scene.population, *scene.space, scene.fluids, velocity);
    return velocity;
  }
} // namespace



TYPED_TEST(MomentumProjectionMpi, UniformVelocitiesAreExact)
{
  constexpr int dim = TypeParam::value;
  for (auto &scene : {bent<dim>(), periodic<dim>()})
    {
      fill(*scene, .8);
      dealii::Tensor<1, dim> u;
      u[0]       = 3.;
      u[dim - 1] = -1.;
      set_particles(*scene, [&](const auto &) { return u; });
      const Vector velocity = velocity_of(*scene);
      scene->for_each_node([&](const unsigned int n, const auto &x) {
        EXPECT_LT((scene->at(velocity, n) - u).norm(), 1e-13) << x;
      });
    }
}



TYPED_TEST(MomentumProjectionMpi, AtWallsItHasAThirdOfTheErrorOfAMean)
{
  // The mean of x over the half of a hat is h/3; what it leaves in the cell
  // beside the wall is -h/3 (1 - x/h), of which the mean is -2 h/9.
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4));
  fill(scene, 0., 8);
  set_particles(scene, [&](const auto &x) {
    dealii::Tensor<1, dim> u;
    u[1] = x[0];
    return u;
  });
  const Vector velocity = velocity_of(scene);
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    const double error = scene.at(velocity, n)[1] - x[0];
    if (x[0] < 1e-9)
      EXPECT_NEAR(error, .25 / 9., .001) << x;
    else if (x[0] < .3)
      EXPECT_NEAR(error, -.25 / 18., .001) << x;
    else if (x[0] < .6)
      EXPECT_NEAR(error, 0., 1e-12) << x;
  });
}



TYPED_TEST(MomentumProjectionMpi, NodesWithoutParticlesKeepTheirVelocity)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4));
  Vector        velocity = scene.velocity(smooth<dim>);
  project_momentum(*scene.population, *scene.space, scene.fluids, velocity);
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    EXPECT_EQ((scene.at(velocity, n) - smooth<dim>(x)).norm(), 0.) << x;
  });
}
