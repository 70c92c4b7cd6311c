// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  const std::string metis = section("Partition", {"Model = metis"});

  /// A column that collapses, from which hanging nodes are not far.
  template <int dim>
  std::string
  hanging_collapse()
  {
    return (dim == 2 ? box_of("12, 12", "if(y < 0.3, 1, 0)")
                     : box_of("6, 6, 6", "if(x < 0.5, 1, 0)")) +
           section("Time",
                   {"Time step = 0.01",
                    std::string("End time = ") +
                      (dim == 2 ? "0.12" : "0.05")}) +
           section("Body forces",
                   {std::string("Gravity = 0, -9.81") +
                    (dim == 2 ? "" : ", 0")}) +
           section("Initial conditions",
                   {"Level set = max(x - 0.31, y - 0.62)"}) +
           section("Boundary conditions", {"Open = top: 0"}) +
           tight_solver("1e-11", "1e-12");
  }

  /// A single fluid around a cylinder, on curved cells.
  std::string
  cylinder()
  {
    return section("Geometry", {"Model = cylinder in channel"}) +
           section("Refinement", {"Local levels = if(x < 0.5, 1, 0)"}) +
           section("Time", {"Time step = 0.02", "End time = 0.12"}) +
           section("Boundary conditions",
                   {"Velocity = left: 6*y*(0.41-y)/0.41^2; 0",
                    "No slip = bottom, top, cylinder",
                    "Open = right: 0"}) +
           one_fluid(1., .001) +
           section("Method",
                   {"Model = single fluid pfem2"},
                   section("single fluid pfem2",
                           {"Pressure tolerance = 1e-12",
                            "Velocity tolerance = 1e-13"},
                           section("Projection",
                                   {},
                                   section("l2", {"Tolerance = 1e-13"}))));
  }


  /// Runs on parts of METIS and of p4est; both must agree.
  template <int dim>
  void
  compare(const std::string &text, const std::vector<std::string> &columns)
  {
    const RunCase<dim> one(text + metis), other(text);
    for (const std::string &column : columns)
      EXPECT_NEAR(one.last(column),
                  other.last(column),
                  1e-6 * std::abs(other.last(column)))
        << column;
    for (const std::string column : {"step", "cells", "dofs", "particles"})
      EXPECT_EQ(one.last(column), other.last(column)) << column;
    EXPECT_EQ(one.last("particles lost in all"), 0.);
    EXPECT_EQ(one.last("repartitionings"), 0.);
  }

  const std::vector<std::string> two_fluid_columns{
    "kinetic energy [J]",
    "potential energy [J]",
    "volume 1 before shift [m^d]",
    "volume 1 [m^d]",
    "max velocity 1 [m/s]",
    "max velocity 2 [m/s]"};
} // namespace



TEST(PartitionMpi, DamBreak2d)
{
  // Out of balance at once, if the partition could change.
  compare<2>(hanging_collapse<2>() +
               section("Load balance", {"Interval = 1", "Threshold = 1"}),
             two_fluid_columns);
}



TEST(PartitionMpi, DamBreak3d)
{
  compare<3>(hanging_collapse<3>(), two_fluid_columns);
}



TEST(PartitionMpi, DamBreakInAPeriodicBox)
{
  compare<2>(section("Geometry", {"Periodic boundaries = left:right"}) +
               hanging_collapse<2>(),
             two_fluid_columns);
}



TEST(PartitionMpi, SingleFluidAroundACylinder)
{
  compare<2>(cylinder(), {"kinetic energy [J]", "max velocity 1 [m/s]"});
}



TEST(Partition, DoesNotMatterOnOneProcess)
{
  const RunCase<2> one(hanging_collapse<2>() + metis, MPI_COMM_SELF);
  const RunCase<2> other(hanging_collapse<2>(), MPI_COMM_SELF);
  for (const std::string &column : two_fluid_columns)
    EXPECT_EQ(one.last(column), other.last(column)) << column;
}
