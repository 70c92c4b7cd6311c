// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/shear_viscosities.h>
#include <thalweg/fluid/viscous_operator.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class ShearViscositiesMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ShearViscositiesMpi, Dimensions);

  /// A power law with n = 1/2 in the first fluid.
  std::string
  thinning(const std::string &number)
  {
    return section("Fluids",
                   {"Number = " + number},
                   section("First fluid",
                           {"Viscosity = 2"},
                           section("Rheology",
                                   {"Model = power law"},
                                   section("power law",
                                           {"Exponent = 0.5",
                                            "Least shear rate = 1e-9"}))) +
                     section("Second fluid", {"Viscosity = 0.5"}));
  }

  template <int dim>
  Vector
  some_flow(const Scene<dim> &scene, const double seed)
  {
    return scene.velocity([&](const auto &x) {
      dealii::Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = std::sin(2. * x[(d + 1) % dim] + seed + d) + .3 * x[d] * x[0];
      return u;
    });
  }
} // namespace



TYPED_TEST(ShearViscositiesMpi, AreThoseOfTheShearRate)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + thinning("1"));
  scene.set_phases([](const auto &) { return -1.; });
  FluidViscosities<dim> given;
  given.attach(*scene.space, scene.fluids);
  ShearViscosities<dim> shear(*scene.space,
                              *scene.boundary,
                              *scene.phase,
                              given);
  ASSERT_TRUE(shear.depend_on_shear());
  shear.update(scene.velocity([](const auto &x) {
    dealii::Tensor<1, dim> u;
    u[0] = 4. * x[1];
    return u;
  }));
  for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
    EXPECT_NEAR(shear.viscosities()(0, c), 2. / std::sqrt(4.), 1e-8);
}



// A sheared laminate: the stress is the same in both fluids.
TEST(ShearViscosities, InCutCellsAreThoseOfALaminate)
{
  const Scene<2> scene(unit_box<2>(5) + thinning("2"));
  scene.set_phases([](const auto &x) { return x[1] - .5; });
  FluidViscosities<2> given;
  given.attach(*scene.space, scene.fluids);
  ShearViscosities<2> shear(*scene.space, *scene.boundary, *scene.phase, given);
  const Vector        u = scene.velocity([](const auto &x) {
    dealii::Tensor<1, 2> u;
    u[0] = 4. * x[1];
    return u;
  });
  for (unsigned int i = 0; i < 60; ++i)
    shear.update(u);
  const auto &cut = scene.phase->cut_cells().front();
  const auto &mu  = shear.viscosities();
  EXPECT_EQ(mu(1, cut.cell), .5);
  // tau = 0.5 r_2 = 2 sqrt(r_1), (r_1 + r_2) / 2 = 4
  const double tau  = mu(0, cut.cell) * std::pow(2. / mu(0, cut.cell), 2);
  const double mean = .5 * (std::pow(tau / 2., 2) + tau / .5);
  EXPECT_NEAR(mean, 4., 1e-3);
}



TYPED_TEST(ShearViscositiesMpi, KnowTheirDerivative)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(3) + thinning("1"),
                         Meshes::distort_and_refine<dim>);
  scene.set_phases([](const auto &) { return -1.; });
  FluidViscosities<dim> given;
  given.attach(*scene.space, scene.fluids);
  ShearViscosities<dim>      shear(*scene.space,
                              *scene.boundary,
                              *scene.phase,
                              given);
  const ViscousOperator<dim> viscous(*scene.space,
                                     *scene.boundary,
                                     *scene.phase,
                                     &shear.viscosities());
  const Vector               u = some_flow(scene, 0.), w = some_flow(scene, 1.);
  const auto                 force = [&](const double step) {
    Vector moved(u), result;
    moved.add(step, w);
    scene.space->interpolate(moved, dim);
    shear.update(moved);
    scene.space->initialize_velocity(result);
    viscous.subtract_viscous_force(moved, result);
    scene.space->fold(result, dim);
    return result;
  };
  constexpr double step       = 1e-5;
  Vector           difference = force(step);
  difference.add(-1., force(-step));
  difference *= .5 / step;
  force(0.);
  Vector tangent;
  scene.space->initialize_velocity(tangent);
  viscous.subtract_viscous_force(w, tangent);
  shear.subtract_tangent(w, 1., tangent);
  scene.space->fold(tangent, dim);
  const double size = tangent.l2_norm();
  difference.add(-1., tangent);
  EXPECT_LT(difference.l2_norm(), 1e-8 * size);
}
