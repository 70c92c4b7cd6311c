// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  template <int dim>
  double
  largest_velocity(const RunCase<dim> &run)
  {
    return std::max(run.last("max velocity 1 [m/s]"),
                    run.last("max velocity 2 [m/s]"));
  }


  std::string
  tank(const std::string &level_set, const std::string &forces)
  {
    return unit_box<2>(10) +
           section("Time", {"Time step = 0.01", "End time = 0.1"}) +
           section("Initial conditions", {"Level set = " + level_set}) +
           tight_solver("1e-13", "1e-13") +
           section("Particles", {"Distance band = 100"}) +
           section("Projection", {"Model = least squares"}) + forces;
  }

  std::string
  body_forces(const std::vector<std::string> &settings)
  {
    return section("Body forces", settings);
  }
} // namespace



TEST(MovingTank, UniformAccelerationsAreBalancedAsGravityIs)
{
  const std::string plane = "0.3*(x - 0.5) + 0.95*(y - 0.47)";
  // The acceleration a user gives, one of the tank, and both with gravity.
  for (const std::string &forces :
       {body_forces({"Acceleration = -3; -9.5"}),
        body_forces({"Gravity = 0, -9.5", "Acceleration = -3; 0"}),
        section("Moving frame", {"Acceleration = 3; 9.5"}),
        body_forces({"Gravity = 0, -9.5"}) +
          section("Moving frame", {"Displacement = 1.5*t^2; 0"}),
        body_forces({"Gravity = -3, -9.5"}) +
          section("Moving frame", {"Velocity = 7; 2"})})
    EXPECT_LT(largest_velocity(RunCase<2>(tank(plane, forces))), 1e-7);
}



TEST(MovingTank, ShakingWithForcesOrMovingTheFrameIsTheSame)
{
  const std::string gravity = "Gravity = 0, -9.81";
  const RunCase<2>  forced(
    tank("y - 0.47", body_forces({gravity, "Acceleration = -sin(6*t); 0"})));
  const RunCase<2> moved(
    tank("y - 0.47",
         body_forces({gravity}) +
           section("Moving frame", {"Velocity = -cos(6*t)/6; 0"})));
  EXPECT_GT(largest_velocity(forced), 1e-3);
  for (const std::string quantity :
       {"max velocity 1 [m/s]", "kinetic energy [J]", "momentum x [kg m/s]"})
    EXPECT_NEAR(moved.last(quantity),
                forced.last(quantity),
                1e-6 * std::abs(forced.last(quantity)))
      << quantity;
}



TEST(MovingTank, ATankThatStaysAtAnAngleHasTiltedGravity)
{
  const RunCase<2> run(tank("sin(0.3)*(x - 0.5) + cos(0.3)*(y - 0.47)",
                            body_forces({"Gravity = 0, -9.81"}) +
                              section("Moving frame", {"Angle = 0.3"})));
  EXPECT_LT(largest_velocity(run), 1e-7);
  EXPECT_EQ(run.last("angle of the tank [rad]"), .3);
}



TEST(MovingTank, FluidsThatTurnWithItStayWhereTheyAre)
{
  // Gravity turns with the tank's frame in the plane, so there is none.
  // The heavy fluid is outside: in balance.
  const RunCase<2> one(
    unit_box<2>(8) + section("Time", {"Time step = 0.01", "End time = 0.1"}) +
    section("Moving frame", {"Angular velocity = 3", "Center = 0.5, 0.5"}) +
    section("Method", {"Model = single fluid pfem2"}) + one_fluid(1000., 0.) +
    section("Boundary conditions", {"Otherwise = slip"}));
  EXPECT_LT(one.last("max velocity 1 [m/s]"), 1e-3);
}



TEST(MovingTank, OneFluidAtRestInSpaceIsDeflectedOnItsCircles)
{
  // Seen from the tank the fluid turns backwards. A flow that turns as a
  // whole within walls that let it through must stay what it is.
  const std::string backwards = "3*(y - 0.5); -3*(x - 0.5)";
  const RunCase<2>  run(
    unit_box<2>(8) + section("Time", {"Time step = 0.02", "End time = 0.4"}) +
    section("Moving frame", {"Angular velocity = 3", "Center = 0.5, 0.5"}) +
    section("Method", {"Model = single fluid pfem2"}) + one_fluid(2., 0.) +
    section("Initial conditions", {"Velocity = " + backwards}) +
    section("Boundary conditions",
            {"Velocity = left: " + backwards + " | right: " + backwards +
              " | bottom: " + backwards + " | top: " + backwards}));
  // The speed in the corners is 3 sqrt(1/2).
  EXPECT_NEAR(run.last("max velocity 1 [m/s]"), 3. * std::sqrt(.5), 1e-2);
  EXPECT_NEAR(run.last("kinetic energy [J]"), 1.5, 2e-2);
}



TEST(MovingTank, TwoFluidsAtRestInSpaceAreDeflectedOnTheirCircles)
{
  // The same, with the other method: no work is done. In a tank that does not
  // turn the same flow needs another pressure, and no deflection.
  const std::string backwards = "3*(y - 0.5); -3*(x - 0.5)";
  for (const std::string integration : {"staggered", "trapezoidal", "frozen"})
    {
      const std::string text =
        unit_box<2>(12) +
        section("Time", {"Time step = 0.01", "End time = 0.2"}) +
        section("Method",
                {},
                section("pfem2", {"Time integration = " + integration})) +
        two_fluids(2., 2.) +
        section("Initial conditions",
                {"Velocity = " + backwards, "Level set = y - 0.5"}) +
        section("Boundary conditions",
                {"Velocity = left: " + backwards + " | right: " + backwards +
                 " | bottom: " + backwards + " | top: " + backwards});
      const RunCase<2> still(text);
      for (const std::string spin : {"3", "-3"})
        {
          const RunCase<2> turning(text + section("Moving frame",
                                                  {"Angular velocity = " + spin,
                                                   "Center = 0.5, 0.5"}));
          EXPECT_NEAR(turning.last("kinetic energy [J]"),
                      still.last("kinetic energy [J]"),
                      .006)
            << integration << ' ' << spin;
        }
    }
}
