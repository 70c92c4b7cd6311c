// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/transfer/scalar_projection.h>

#include <cmath>

#include "support/dimensions.h"
#include "transfer/particle_scene.h"

using namespace Thalweg;
using namespace ParticleScenes;

namespace
{
  template <typename T>
  class ScalarProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ScalarProjectionMpi, Dimensions);

  constexpr unsigned int property = 0;


  /// Particles with what @p function says; the first velocity component
  /// stands for the scalar.
  template <int dim, typename Function>
  void
  set_scalars(Scene<dim> &scene, const Function &function)
  {
    for (auto &particle : scene.population->particles())
      particle.properties()[property] = function(particle.position());
  }


  template <int dim>
  Vector
  scalar_of(const Scene<dim> &scene, const double guess = 0.)
  {
    Vector scalar = scene.scalar([&](const auto &) { return guess; });
    ScalarProjection<dim>(*scene.space)
      .project(*scene.population, property, scalar);
    return scalar;
  }
} // namespace



TYPED_TEST(ScalarProjectionMpi, PlanesAreExact)
{
  constexpr int dim   = TypeParam::value;
  const auto    plane = [](const auto &x) { return 2. - x[0] + 3. * x[1]; };
  Scene<dim>    hanging(hanging_box<dim>(4));
  auto          moved = bent<dim>();
  for (Scene<dim> *scene : {&hanging, moved.get()})
    {
      fill(*scene, .5, 3);
      set_scalars(*scene, plane);
      const Vector scalar = scalar_of(*scene, 7.);
      scene->for_each_node([&](const unsigned int n, const auto &x) {
        EXPECT_NEAR(scalar.local_element(n), plane(x), 1e-11) << x;
      });
    }
}



TYPED_TEST(ScalarProjectionMpi, PolynomialsOfSecondDegreeAreExactInside)
{
  constexpr int dim       = TypeParam::value;
  const auto    quadratic = [](const auto &x) {
    return 2. - x[0] + x[0] * x[dim - 1] + 3. * x[1] * x[1];
  };
  Scene<dim> hanging(hanging_box<dim>(4));
  auto       moved = bent<dim>();
  for (Scene<dim> *scene : {&hanging, moved.get()})
    {
      fill(*scene, .8);
      set_scalars(*scene, quadratic);
      const Vector scalar = scalar_of(*scene, 7.);
      scene->for_each_node([&](const unsigned int n, const auto &x) {
        if (!on_side_of_unit_box(x))
          EXPECT_NEAR(scalar.local_element(n), quadratic(x), 1e-11) << x;
      });
    }
}



TYPED_TEST(ScalarProjectionMpi, WhatIsUniformStaysToTheLastBit)
{
  constexpr int dim   = TypeParam::value;
  auto          scene = periodic<dim>();
  fill(*scene, .8);
  set_scalars(*scene, [](const auto &) { return 293.15; });
  const Vector scalar = scalar_of(*scene, 293.15);
  scene->for_each_node([&](const unsigned int n, const auto &) {
    EXPECT_EQ(scalar.local_element(n), 293.15);
  });
}



TYPED_TEST(ScalarProjectionMpi, WhatIsSmoothIsOfThirdOrderInside)
{
  constexpr int dim     = TypeParam::value;
  const auto    f       = [](const auto &x) { return smooth<dim>(x)[0]; };
  const auto    largest = [&](const unsigned int n_cells) {
    Scene<dim> scene(unit_box<dim>(n_cells));
    fill(scene, .5);
    set_scalars(scene, f);
    const Vector scalar = scalar_of(scene);
    double       sum    = 0.;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      if (!on_side_of_unit_box(x))
        sum +=
          std::pow(scalar.local_element(n) - f(x), 2) / std::pow(n_cells, dim);
    });
    return std::sqrt(sum_of_all(sum));
  };
  EXPECT_GT(std::log2(largest(8) / largest(16)), 2.7);
}



TYPED_TEST(ScalarProjectionMpi, JumpsStayWithinTheirBounds)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(hanging_box<dim>(6));
  fill(scene, .8);
  set_scalars(scene,
              [](const auto &x) { return x[0] + .3 * x[1] < .47 ? -1. : 1.; });
  const Vector scalar = scalar_of(scene);
  scene.for_each_node([&](const unsigned int n, const auto &) {
    EXPECT_LE(std::abs(scalar.local_element(n)), 1. + 1e-12);
  });
}



TYPED_TEST(ScalarProjectionMpi, ThoseThatDoNotKnowItCountForNothing)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4));
  fill(scene, .5);
  unsigned int k = 0;
  for (auto &particle : scene.population->particles())
    particle.properties()[property] =
      particle.position()[0] > .5 || ++k % 4 == 0 ? Population<dim>::unknown
                                                  : 1. + particle.position()[1];
  const Vector scalar = scalar_of(scene, 5.);
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    EXPECT_NEAR(scalar.local_element(n), x[0] > .51 ? 5. : 1. + x[1], 1e-11)
      << x;
  });
}
