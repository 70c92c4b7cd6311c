// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  /// A column of water that breaks in a closed tank, until it has hit a wall.
  std::string
  column(const double end_time, const std::string &integration)
  {
    return section("Method",
                   {},
                   section("pfem2", {"Time integration = " + integration})) +
           section("Geometry", {}, section("box", {"Repetitions = 8, 8"})) +
           section("Time",
                   {"End time = " + std::to_string(end_time),
                    "Time step = 0.02"}) +
           section("Body forces", {"Gravity = 0, -9.81"}) +
           section("Initial conditions",
                   {"Level set = max(x - 0.4, y - 0.7)"}) +
           section("Statistics", {"Energy budget = true"});
  }

  /// Of both fluids, J: the kinetic and the potential energy in the columns of
  /// a part of the step.
  double
  of_particles(const RunCase<2> &run, const std::string &part)
  {
    double sum = 0;
    for (const char *kind : {" kinetic ", " potential "})
      for (const char *fluid : {"1", "2"})
        sum += run.last("budget: " + part + kind + fluid + " [J]");
    return sum;
  }
} // namespace



TEST(EnergyBudgetMpi, Closes)
{
  for (const std::string integration : {"staggered", "trapezoidal"})
    {
      const RunCase<2> before(column(.38, integration));
      const RunCase<2> after(column(.4, integration));
      double           changes = 0;
      for (const char *part :
           {"motion", "boundaries", "dispersal", "increment", "limit"})
        changes += of_particles(after, part);
      const double energy = of_particles(after, "particles");
      EXPECT_GT(std::abs(changes), 1e-4 * energy) << integration;
      EXPECT_NEAR(energy - of_particles(before, "particles"),
                  changes,
                  1e-9 * energy)
        << integration;

      double kinetic = after.last("budget: projected [J]");
      for (const char *part : {"forces and pressure",
                               "viscosity",
                               "pressure of friction",
                               "divergence"})
        kinetic += after.last("budget: " + std::string(part) + " [J]");
      EXPECT_NEAR(kinetic, after.last("kinetic energy [J]"), 1e-9 * kinetic)
        << integration;
    }
}



// Half of a box is water; both fluids go along the surface between them.
TEST(EnergyBudgetMpi, KnowsBothFluids)
{
  const RunCase<2> run(
    section("Geometry",
            {"Periodic boundaries = left:right"},
            section("box", {"Repetitions = 8, 8"})) +
    section("Time", {"End time = 0.1", "Time step = 0.05"}) +
    section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Initial conditions", {"Level set = y - 0.5", "Velocity = 3; 0"}) +
    section("Statistics", {"Energy budget = true"}));
  const auto energy = [&](const std::string &which) {
    return run.last("budget: particles " + which + " [J]");
  };
  EXPECT_NEAR(energy("kinetic 1"), .5 * 1000. * 9. * .5, 1e-6);
  EXPECT_NEAR(energy("kinetic 2"), .5 * 1.2 * 9. * .5, 1e-6);
  // Their places are random within cells.
  EXPECT_NEAR(energy("potential 1"), 1000. * 9.81 * .25 * .5, 10.);
  EXPECT_NEAR(energy("potential 2"), 1.2 * 9.81 * .75 * .5, .05);
}
