// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"

TEST(OpenSide, WaterThatComesInAboveTheLevelFalls)
{
  // A wave runs out at a side with the pressure of level water, and water
  // instead of air comes in above it, a curtain as thick as a cell.
  RunCase<2> run(
    section("Geometry",
            {},
            section("box",
                    {"Lower corner = 0, 0",
                     "Upper corner = 2, 0.5",
                     "Repetitions  = 40, 10"})) +
    section("Time", {"End time = 2", "Courant number = 1"}) +
    section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Initial conditions",
            {"Level set = y - 0.22 - 0.05*exp(-20*(x - 0.7)^2)"}) +
    section("Boundary conditions",
            {"Open = right: if(y < 0.22, 9810*(0.22 - y) + 1.2*9.81*0.28, "
             "1.2*9.81*(0.5 - y)) | top: 0",
             "Inflow fluids = right: water, top: air"}));
  // By 0.5 m, or the pressure of as much water.
  EXPECT_LT(run.last("max velocity 1 [m/s]"), std::sqrt(2 * 9.81 * .5));
  EXPECT_GT(run.last("volume 1 in [m^d]"), .01);
}
