// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"



TEST(SimulationStatistics, HaveTheSameOrderInEachRun)
{
  const RunCase<2> run(
    unit_box<2>(4) + section("Time", {"Time step = 0.01", "End time = 0.02"}) +
    section("Initial conditions", {"Level set = y - 0.4"}));
  const std::vector<std::string> expected{"step",
                                          "time [s]",
                                          "dt [s]",
                                          "Courant number",
                                          "Fourier number",
                                          "cells",
                                          "dofs",
                                          "particles",
                                          "particles added",
                                          "particles removed",
                                          "particles left",
                                          "particles lost",
                                          "particles lost in all",
                                          "volume 1 before shift [m^d]",
                                          "volume 1 [m^d]",
                                          "volume 2 [m^d]",
                                          "target volume 1 [m^d]",
                                          "correction of volume 1 [m^d]",
                                          "debt of volume 1 [m^d]",
                                          "drops of volume 1 [m^d]",
                                          "bubbles of volume 2 [m^d]",
                                          "carried volume 1 [m^d]",
                                          "carried volume 2 [m^d]",
                                          "volume 1 in [m^d]",
                                          "volume 1 out [m^d]",
                                          "volume 2 in [m^d]",
                                          "volume 2 out [m^d]",
                                          "volume 1 lost [m^d]",
                                          "volume 2 lost [m^d]",
                                          "volume 1 owed [m^d]",
                                          "volume 2 owed [m^d]",
                                          "level set shift",
                                          "velocity time [s]",
                                          "kinetic energy [J]",
                                          "potential energy [J]",
                                          "momentum x [kg m/s]",
                                          "momentum y [kg m/s]",
                                          "max velocity 1 [m/s]",
                                          "max velocity 2 [m/s]"};
  const auto &columns = run.context.statistics.column_names();
  ASSERT_GT(columns.size(), expected.size());
  EXPECT_EQ(std::vector<std::string>(columns.begin(),
                                     columns.begin() + expected.size()),
            expected);

  // Then the solver's, and at the end the wall times.
  bool wall = false;
  for (std::size_t c = expected.size(); c < columns.size(); ++c)
    {
      const bool is_wall = columns[c].substr(0, 5) == "wall ";
      EXPECT_TRUE(is_wall || !wall) << columns[c];
      wall = is_wall;
    }
  EXPECT_TRUE(wall);
}
