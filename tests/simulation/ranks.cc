// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  /// A column that collapses, solved tightly, in steps of 0.01 s.
  std::string
  collapse(const std::string &repetitions,
           const std::string &local_levels,
           const std::string &gravity,
           const std::string &level_set,
           const std::string &end_time = "0.2")
  {
    return box_of(repetitions, local_levels) +
           section("Time", {"Time step = 0.01", "End time = " + end_time}) +
           section("Body forces", {"Gravity = " + gravity}) +
           section("Initial conditions", {"Level set = " + level_set}) +
           section("Boundary conditions", {"Open = top: 0"}) +
           tight_solver("1e-11", "1e-12");
  }



  /// Every process also runs the case alone; both must agree.
  template <int dim>
  void
  compare_with_one_process(const std::string &text)
  {
    const RunCase<dim> together(text), alone(text, MPI_COMM_SELF);
    for (const std::string column : {"kinetic energy [J]",
                                     "potential energy [J]",
                                     "volume 1 before shift [m^d]",
                                     "volume 1 [m^d]",
                                     "max velocity 1 [m/s]",
                                     "max velocity 2 [m/s]"})
      EXPECT_NEAR(together.last(column),
                  alone.last(column),
                  1e-6 * std::abs(alone.last(column)))
        << column;
    EXPECT_EQ(together.last("cells"), alone.last("cells"));
    EXPECT_EQ(together.last("particles"), alone.last("particles"));
    EXPECT_EQ(together.last("particles lost"), 0.);
  }
} // namespace



TEST(RanksMpi, DamBreak2d)
{
  compare_with_one_process<2>(collapse(
    "12, 12", "if(y < 0.3, 1, 0)", "0, -9.81", "max(x - 0.31, y - 0.62)"));
}



TEST(RanksMpi, DamBreak3d)
{
  compare_with_one_process<3>(collapse("6, 6, 6",
                                       "if(x < 0.5, 1, 0)",
                                       "0, -9.81, 0",
                                       "max(x - 0.31, y - 0.62)",
                                       "0.08"));
}



TEST(RanksMpi, DamBreakOnAMeshThatAdapts2d)
{
  compare_with_one_process<2>(
    collapse("4, 4", "0", "0, -9.81", "max(x - 0.31, y - 0.62)") +
    adapting_every_step("1", "3", "interface distance") +
    section("Load balance", {"Interval = 3", "Threshold = 1"}));
}



TEST(RanksMpi, DamBreakOnAMeshThatAdapts3d)
{
  compare_with_one_process<3>(
    collapse("3, 3, 3", "0", "0, -9.81, 0", "max(x - 0.31, y - 0.62)") +
    adapting_every_step("0", "2", "interface distance") +
    section("Load balance", {"Interval = 3", "Threshold = 1"}) +
    section("Time", {"Maximal number of steps = 4"}));
}



TEST(RanksMpi, ACylinderFarFromSomeProcesses)
{
  // The cells of the process at the outlet alone are axis-parallel.
  compare_with_one_process<2>(
    section("Geometry",
            {"Model = cylinder in channel"},
            section("cylinder in channel", {"Length = 6"})) +
    section("Refinement", {"Global levels = 2"}) +
    section("Time", {"Time step = 0.01", "Maximal number of steps = 2"}) +
    section("Boundary conditions",
            {"Velocity = left: 1; 0",
             "Slip = bottom, top",
             "No slip = cylinder",
             "Open = right: 0"}) +
    one_fluid(1., .001) +
    section("Method",
            {"Model = single fluid pfem2"},
            section("single fluid pfem2",
                    {"Pressure tolerance = 1e-12",
                     "Velocity tolerance = 1e-13"},
                    section("Projection",
                            {},
                            section("l2", {"Tolerance = 1e-13"})))));
}



TEST(Ranks, TwoRunsAgreeToTheLastBit)
{
  const std::string text =
    collapse("12, 12", "0", "0, -9.81", "max(x - 0.31, y - 0.62)");
  const RunCase<2> first(text), second(text);
  for (const std::string column : {"kinetic energy [J]",
                                   "volume 1 before shift [m^d]",
                                   "max velocity 2 [m/s]",
                                   "particles"})
    EXPECT_EQ(first.last(column), second.last(column)) << column;
}
