// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/machine.h>
#include <thalweg/simulation/memory_estimate.h>

#include <gtest/gtest.h>

#include "support/complaint.h"

using namespace Thalweg;


TEST(MemoryEstimate, RefusesWithBothNumbers)
{
  const MemoryEstimate memory(MPI_COMM_SELF, 2, 10., 1.);
  // 3 kB and ten times 200 bytes.
  EXPECT_DOUBLE_EQ(memory.most_cells(), 1e9 / 5000.);
  EXPECT_EQ(complaint_of([&]() { memory.check(2e5); }), "");
  EXPECT_EQ(complaint_of([&]() { memory.check(4e5); })
              .find("The mesh would have 4e+05 cells or more, with 10 "
                    "particles each. They need at least 2 GB of memory, but "
                    "'Refinement/Memory limit' is 1 GB."),
            0u);
}


TEST(MemoryEstimate, KnowsTheMachine)
{
  const double bytes = memory_of_machines(MPI_COMM_SELF);
  EXPECT_GT(bytes, 1e8);
  EXPECT_LT(bytes, 1e15);
  EXPECT_DOUBLE_EQ(MemoryEstimate(MPI_COMM_SELF, 3, 0., 0.).most_cells(),
                   bytes / 10000.);
}


TEST(MemoryEstimateMpi, ProcessesOfOneMachineShareItsMemory)
{
  const double alone = memory_of_machines(MPI_COMM_SELF);
  const double all   = memory_of_machines(MPI_COMM_WORLD);
  EXPECT_NEAR(all / alone, 1., 1e-9);
}
