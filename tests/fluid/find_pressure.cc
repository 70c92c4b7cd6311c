// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>

#include "step_scene.h"
#include "support/dimensions.h"
#include "support/meshes.h"

using namespace Steps;

namespace
{
  template <typename T>
  class FindPressureMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(FindPressureMpi, Dimensions);
} // namespace



TYPED_TEST(FindPressureMpi, RestUnderGravityIsHydrostatic)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    for (const bool open : {false, true})
      {
        const StepScene<dim> scene(
          unit_box<dim>(3) +
            section("Boundary conditions",
                    open ? std::vector<std::string>{"Open = top: 7 + 2*x"}
                         : std::vector<std::string>{}),
          k,
          l,
          1.,
          Meshes::distort_and_refine<dim>);
        dealii::Tensor<1, dim> gravity;
        gravity[0] = 2.;
        gravity[1] = -9.81;
        const Vector pressure =
          scene.pressure_of(scene.no_velocity(),
                            scene.flow_velocity(
                              [&](const auto &) { return gravity; }));
        EXPECT_LT(scene.pressure_error(pressure,
                                       [&](const auto &p) {
                                         return 7. + 2. * p[0] +
                                                9.81 * (1. - p[1]);
                                       }),
                  1e-10);
      }
}



TYPED_TEST(FindPressureMpi, PoiseuillesFlowHasItsPressure)
{
  constexpr int dim = TypeParam::value;
  const double  nu  = .3;
  for (const std::string &conditions :
       {given_ends<dim>(), channel<dim>("Open = left: 0.6 | right: 0")})
    for (const unsigned int degree : {1u, 2u})
      {
        const StepScene<dim> scene(hanging_box<dim>(3) + conditions,
                                   2,
                                   degree,
                                   nu);
        const Vector         u = scene.flow_velocity(poiseuille<dim>);
        EXPECT_LT(scene.pressure_error(
                    scene.pressure_of(u, scene.no_velocity()),
                    [&](const auto &p) { return 2. * nu * (1. - p[0]); }),
                  1e-9);
      }
}



TYPED_TEST(FindPressureMpi, PoiseuillesFlowHasItsPressureWithLinearElements)
{
  constexpr int dim = TypeParam::value;
  const double  nu  = .3;
  for (const std::string &conditions :
       {given_ends<dim>(), channel<dim>("Open = left: 0.6 | right: 0")})
    {
      // Friction at the walls is that of the nodes beside them.
      const StepScene<dim> scene(unit_box<dim>(4) + conditions, 1, 1, nu);
      const Vector         u = scene.flow_velocity(poiseuille<dim>);
      EXPECT_LT(scene.velocity_error(scene.friction_of(u),
                                     [&](const auto &) {
                                       dealii::Tensor<1, dim> friction;
                                       friction[0] = -2. * nu;
                                       return friction;
                                     }),
                1e-9);
      EXPECT_LT(scene.pressure_error(scene.pressure_of(u, scene.no_velocity()),
                                     [&](const auto &p) {
                                       return 2. * nu * (1. - p[0]);
                                     }),
                1e-9);
    }
}



TEST(FindPressureMpi2d, VorticesHaveTheirPressureUpToTheSquareOfTheCells)
{
  for (const auto &[k, l] : degree_pairs())
    for (const bool is_periodic : {true, false})
      {
        const auto error = [&, k = k, l = l](const unsigned int n) {
          const StepScene<2> scene(unit_box<2>(n,
                                               "0",
                                               is_periodic
                                                 ? all_periodic
                                                 : std::vector<std::string>{}),
                                   k,
                                   l,
                                   .05);
          const Vector       u = scene.flow_velocity(vortices);
          const Vector       p = scene.pressure_of(u, scene.no_velocity());
          // The mean difference m does not count: a = e^2 + m^2, and with 1
          // more b = e^2 + (m - 1)^2.
          const auto square = [&](const double constant) {
            return std::pow(mean_square_error(scene.P.scalar(),
                                              scene.mapping,
                                              p,
                                              [&](const auto &x) {
                                                return vortex_pressure(x) +
                                                       constant;
                                              }),
                            2);
          };
          const double a = square(0.), m = .5 * (a - square(1.) + 1.);
          return std::sqrt(a - m * m);
        };
        const double coarse = error(12), fine = error(24);
        EXPECT_LT(fine, .02) << k << ' ' << l;
        EXPECT_GT(std::log2(coarse / fine), 1.9)
          << k << ' ' << l << ' ' << is_periodic;
      }
}



TEST(FindPressureMpi2d, LinearElementsAreOfFourthOrderInsideUniformMeshes)
{
  const auto errors = [](const unsigned int n) {
    const StepScene<2> scene(unit_box<2>(n, "0", all_periodic), 1, 1, 0.);
    const Vector       p =
      scene.pressure_of(scene.flow_velocity(vortices), scene.no_velocity());
    Vector gradient = scene.no_velocity();
    scene.step->pressure_acceleration(p, gradient);
    return std::array<double, 2>{
      {scene.pressure_error(p, vortex_pressure),
       scene.velocity_error(gradient, [](const auto &x) {
         dealii::Tensor<1, 2> slope;
         for (unsigned int d = 0; d < 2; ++d)
           slope[d] = -pi * std::sin(4. * pi * x[d]);
         return slope;
       })}};
  };
  const auto coarse = errors(16), fine = errors(32);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_GT(std::log2(coarse[i] / fine[i]), 3.8) << i;
  // The difference is 1 % without the correction.
  EXPECT_LT(fine[1], 1e-3 * pi);
}



TEST(FindPressureMpi2d, AcceleratedBoundariesPush)
{
  // A piston: all fluid follows the acceleration of both ends.
  for (const auto &[k, l] : degree_pairs())
    {
      const StepScene<2> scene(unit_box<2>(4) +
                                 section("Boundary conditions",
                                         {"Velocity = left: 3*t; 0 | right: "
                                          "3*t; 0"}),
                               k,
                               l,
                               0.);
      Vector             pressure = scene.empty_pressure();
      pressure.update_ghost_values();
      scene.step->find_pressure(scene.no_velocity(),
                                scene.no_velocity(),
                                scene.no_velocity(),
                                scene.flow_velocity([](const auto &p) {
                                  dealii::Tensor<1, 2> a;
                                  a[0] =
                                    p[0] < 1e-9 || p[0] > 1. - 1e-9 ? 3. : 0.;
                                  return a;
                                }),
                                pressure);
      EXPECT_LT(scene.pressure_error(pressure,
                                     [](const auto &p) { return -3. * p[0]; }),
                1e-10);
    }
}
