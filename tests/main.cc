// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/mpi_session.h>

#include <gtest/gtest.h>
#include <iostream>

/**
 * Runs the tests on any number of processes. The root process reports its
 * successes and failures, the others only their failures.
 */
int
main(int argc, char **argv)
{
  const Thalweg::MpiSession mpi;
  ::testing::InitGoogleTest(&argc, argv);

  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    {
      class Failures : public ::testing::EmptyTestEventListener
      {
        void
        OnTestPartResult(const ::testing::TestPartResult &result) override
        {
          if (result.failed())
            std::cerr << "Process "
                      << dealii::Utilities::MPI::this_mpi_process(
                           MPI_COMM_WORLD)
                      << ": " << result.file_name() << ':'
                      << result.line_number() << ": " << result.summary()
                      << std::endl;
        }
      };
      auto &listeners = ::testing::UnitTest::GetInstance()->listeners();
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new Failures);
    }

  // One process that fails makes all of them return a failure.
  return dealii::Utilities::MPI::max(RUN_ALL_TESTS(), MPI_COMM_WORLD);
}
