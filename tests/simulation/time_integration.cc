// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  std::string
  integration(const std::string &name)
  {
    return section("Method",
                   {},
                   section("pfem2", {"Time integration = " + name}));
  }



  /// The relative error of the kinetic energy of Taylor-Green vortices at
  /// t = 0.5 s, when it has fallen to 0.45 of the initial one.
  double
  vortex_energy_error(const std::string &name, const std::string &dt)
  {
    const RunCase<2> run(
      unit_box<2>(32, "0", {"Periodic boundaries = left:right, bottom:top"}) +
      integration(name) +
      section("Time", {"Time step = " + dt, "End time = 0.5"}) +
      one_fluid(1., .01) +
      section("Initial conditions",
              {"Velocity = sin(2*pi*x)*cos(2*pi*y); "
               "-cos(2*pi*x)*sin(2*pi*y)"}));
    const double time = run.last("velocity time [s]");
    const double exact =
      .25 * std::exp(-16. * std::pow(dealii::numbers::PI, 2) * .01 * time);
    return run.last("kinetic energy [J]") / exact - 1.;
  }



  /// The kinetic energy of an inviscid standing wave after a number of
  /// periods of 40 steps.
  double
  wave_energy(const std::string &name, const double periods)
  {
    const double     k      = dealii::numbers::PI;
    const double     period = 2. * k / std::sqrt(9.81 * k * std::tanh(.5 * k));
    const RunCase<2> run(
      unit_box<2>(20) + integration(name) +
      section("Time",
              {"Time step = " + std::to_string(period / 40.),
               "End time = " + std::to_string(periods * period)}) +
      section("Fluids",
              {},
              section("First fluid", {"Viscosity = 0"}) +
                section("Second fluid", {"Density = 1", "Viscosity = 0"})) +
      section("Body forces", {"Gravity = 0, -9.81"}) +
      section("Initial conditions", {"Level set = y - 0.51 - 0.03*cos(pi*x)"}));
    return run.last("kinetic energy [J]");
  }
} // namespace



TEST(TimeIntegration, TheTrapezoidalRuleIsOfSecondOrder)
{
  const double coarse = vortex_energy_error("trapezoidal", "0.125");
  const double fine   = vortex_energy_error("trapezoidal", "0.0625");
  EXPECT_LT(std::abs(fine), .04);
  EXPECT_GT(std::abs(coarse), 3.5 * std::abs(fine));
}



TEST(TimeIntegration, TheOthersAreOfFirstOrderAlongCurvedStreamlines)
{
  for (const std::string name : {"frozen", "extrapolated"})
    EXPECT_GT(std::abs(vortex_energy_error(name, "0.0625")), .2) << name;
}



TEST(TimeIntegration, StaggeredVelocitiesAreConvectedByThoseOfTheirTime)
{
  // What is left is the energy of velocities that stand at the places of half a
  // step before.
  EXPECT_LT(std::abs(vortex_energy_error("staggered", "0.0625")), .08);
}



TEST(TimeIntegration, WavesKeepTheirEnergy)
{
  for (const std::string name : {"frozen", "staggered", "trapezoidal"})
    {
      const double ratio = wave_energy(name, 1.25) / wave_energy(name, .25);
      EXPECT_NEAR(ratio, 1., .1) << name;
    }
  EXPECT_LT(wave_energy("extrapolated", 1.25),
            .7 * wave_energy("extrapolated", .25));
}
