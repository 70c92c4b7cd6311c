// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <string>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  /// One vortex in a box with slip walls, a steady flow without viscosity.
  std::string
  vortex(const std::string &dt)
  {
    return box_of("16, 16", "0") +
           section("Time", {"Time step = " + dt, "End time = 1"}) +
           section("Fluids",
                   {"Number = 1"},
                   section("First fluid", {"Density = 1", "Viscosity = 0"})) +
           section("Initial conditions",
                   {"Velocity = sin(pi*x)*cos(pi*y); -cos(pi*x)*sin(pi*y)"});
  }
} // namespace



/// Particles near the wall that fly towards it were stopped by it, the more
/// often the shorter the steps: 5.6 % were lost with these.
TEST(SlipWalls, AVortexKeepsItsEnergy)
{
  const RunCase<2> run(vortex("0.005"));
  EXPECT_GT(run.last("kinetic energy [J]"), .25 * .955);
  EXPECT_LT(run.last("kinetic energy [J]"), .25);
}
