// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_scene.h"
#include "support/dimensions.h"
#include "support/meshes.h"

using namespace Steps;

namespace
{
  template <typename T>
  class IncrementalStepMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(IncrementalStepMpi, Dimensions);
} // namespace



TYPED_TEST(IncrementalStepMpi, QuadraticVelocitiesHaveTheirViscousAcceleration)
{
  static constexpr int dim = TypeParam::value;
  const StepScene<dim> scene(hanging_box<dim>(3) + given_ends<dim>(), 2, 1, .3);
  Vector               g = scene.no_velocity();
  scene.step->viscous_acceleration(scene.flow_velocity(poiseuille<dim>), g);
  EXPECT_LT(scene.velocity_error(g,
                                 [](const auto &) {
                                   dealii::Tensor<1, dim> a;
                                   a[0] = -.6;
                                   return a;
                                 }),
            1e-9);
}



TYPED_TEST(IncrementalStepMpi, LinearPressuresHaveTheirAcceleration)
{
  static constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const StepScene<dim> scene(
        unit_box<dim>(3), k, l, 0., Meshes::distort_and_refine<dim>);
      Vector a = scene.no_velocity();
      scene.step->pressure_acceleration(
        scene.flow_pressure([](const auto &p) { return 3. * p[0] - p[1]; }), a);
      EXPECT_LT(scene.velocity_error(a,
                                     [](const auto &) {
                                       dealii::Tensor<1, dim> slope;
                                       slope[0] = 3.;
                                       slope[1] = -1.;
                                       return slope;
                                     }),
                1e-10);
    }
}



TEST(IncrementalStepMpi2d, SmoothLeavesOutTheSquareOfTheStep)
{
  StepScene<2> scene(unit_box<2>(16, "0", all_periodic), 2, 1, .1);
  const Vector g = scene.flow_velocity(vortices);
  Vector       s = scene.no_velocity();
  for (const double theta : {.5, 1.})
    for (const double dt : {.01, 100.})
      {
        scene.parameters.viscous_theta = theta;
        // Another step in between, since it keeps its matrix.
        scene.step->smooth(g, 2. * dt, s);
        scene.step->smooth(g, dt, s);
        const double z      = theta * .1 * dt * 8. * pi * pi;
        const double factor = 1. - std::pow(z / (1. + z), 2);
        EXPECT_LT(scene.velocity_error(
                    s, [&](const auto &p) { return factor * vortices(p); }),
                  1e-3 * factor)
          << theta << ' ' << dt;
      }
}



TYPED_TEST(IncrementalStepMpi, ASteadyFlowIsLeftAsItIs)
{
  constexpr int dim = TypeParam::value;
  const double  nu  = .3;
  for (const double theta : {.5, 1.})
    {
      StepScene<dim> scene(hanging_box<dim>(3) + given_ends<dim>(), 2, 1, nu);
      scene.parameters.viscous_theta = theta;
      const Vector u                 = scene.flow_velocity(poiseuille<dim>);
      const Vector p                 = scene.flow_pressure(
        [&](const auto &x) { return 2. * nu * (.5 - x[0]); });
      Vector g = scene.no_velocity(), a = g, velocity = g;
      scene.step->viscous_acceleration(u, g);
      scene.step->pressure_acceleration(p, a);
      Vector pressure = scene.empty_pressure();
      scene.step->solve(u, {p, a, g, g}, false, 10., velocity, pressure);
      EXPECT_LT(scene.velocity_error(velocity, poiseuille<dim>), 1e-9);
      EXPECT_LT(scene.pressure_error(pressure,
                                     [&](const auto &x) {
                                       return 2. * nu * (.5 - x[0]);
                                     }),
                1e-9);
    }
}



TEST(IncrementalStepMpi2d, IterationsRemoveTheDivergence)
{
  const auto divergence = [](const unsigned int iterations) {
    StepScene<2> scene(hanging_box<2>(6), 2, 1, .01);
    scene.parameters.iterations = iterations;
    const Vector zero           = scene.no_velocity();
    Vector       p = scene.empty_pressure(), pressure = p, velocity = zero;
    p.update_ghost_values();
    // Vortices with a gradient on top, which is no flow in a box.
    const Vector star = scene.flow_velocity([](const auto &x) {
      auto u = vortices(x);
      u[0] += x[0];
      return u;
    });
    scene.step->solve(
      star, {p, zero, zero, zero}, false, .1, velocity, pressure);
    Vector result = scene.empty_pressure();
    scene.operators.add_divergence(velocity, result, 1.);
    scene.P.fold(result, 1);
    return result.l2_norm();
  };
  const double once = divergence(1), often = divergence(30);
  EXPECT_LT(often, .1 * once);
}



TEST(IncrementalStepMpi2d, GradientsAreRemovedAndVorticesStay)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const auto difference = [&](const unsigned int n) {
        const StepScene<2> scene(hanging_box<2>(n), 2, degree, .01);
        // With the gradient of cos(pi x) cos(pi y), which leaves no wall.
        Vector velocity = scene.flow_velocity([](const auto &x) {
          auto u = vortices(x);
          u[0] -= pi * std::sin(pi * x[0]) * std::cos(pi * x[1]);
          u[1] -= pi * std::cos(pi * x[0]) * std::sin(pi * x[1]);
          return u;
        });
        scene.step->remove_divergence(velocity);
        return mean_square_error(scene.V.velocity(),
                                 scene.mapping,
                                 velocity,
                                 vortices);
      };
      const double coarse = difference(8), fine = difference(16);
      EXPECT_LT(fine, .02 * pi) << degree;
      // The gradients of linear pressures are of first order at walls, that is
      // in a layer of the cells' size.
      EXPECT_GT(std::log2(coarse / fine), degree == 1 ? 1.5 : 1.9) << degree;
    }
}



TEST(PressureStabilization, ParametersHaveTheirLimits)
{
  const auto none = stabilization<2>("none"), oss = stabilization<2>("oss"),
             fic = stabilization<2>("fic");
  EXPECT_FALSE(none->is_active());
  EXPECT_EQ(none->parameter(.1, 1., 1., 1.), 0.);
  EXPECT_TRUE(oss->is_active());
  EXPECT_TRUE(fic->is_active());
  EXPECT_NEAR(oss->parameter(.1, 2., 0., 1e20), .01 / 8., 1e-14);
  EXPECT_NEAR(oss->parameter(.1, 0., 5., 1e20), .1 / 10., 1e-14);
  EXPECT_NEAR(oss->parameter(.1, 0., 0., .3), .3, 1e-14);
  EXPECT_NEAR(1. / oss->parameter(.1, 2., 5., .3), 800. + 100. + 1. / .3, 1e-9);
  EXPECT_NEAR(1. / fic->parameter(.1, 2., 5., .5), 1600. + 4., 1e-9);
  const Vector gradient, forces;
  EXPECT_EQ(&oss->balance(gradient, forces), &gradient);
  EXPECT_EQ(&fic->balance(gradient, forces), &forces);
}



TEST(PressureStabilizationMpi, DampsOscillations)
{
  // A checkerboard, which equal degrees do not see.
  const double nu = .01, dt = .1;
  for (const std::string name : {"none", "oss", "fic"})
    {
      StepScene<2> scene(unit_box<2>(8, "0", all_periodic), 1, 1, nu);
      const auto   model          = stabilization<2>(name);
      scene.parameters.iterations = 1; // each damps by the same factor
      IncrementalStep<2> step(scene.context,
                              scene.operators,
                              scene.flow_boundary,
                              *model,
                              scene.parameters,
                              nu);
      const Vector       p    = scene.flow_pressure([](const auto &x) {
        return std::cos(8. * pi * x[0]) * std::cos(8. * pi * x[1]);
      });
      const Vector       zero = scene.no_velocity();
      Vector a = zero, velocity = zero, pressure = scene.empty_pressure();
      step.pressure_acceleration(p, a);
      EXPECT_LT(max_of_all(a.linfty_norm()), 1e-10);
      const double tau = model->parameter(1. / 8., nu, 0., dt);
      for (const bool stabilized : {false, true})
        {
          step.solve(
            zero, {p, a, zero, zero}, stabilized, dt, velocity, pressure);
          EXPECT_NEAR(max_of_all(pressure.linfty_norm()),
                      stabilized ? 1. / (1. + tau / dt) : 1.,
                      1e-9)
            << name;
        }
    }
}
