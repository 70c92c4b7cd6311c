// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>

using namespace Thalweg;

TEST(Errors, MessagesAreBare)
{
  EXPECT_EQ(message_of(dealii::ExcMessage("Too\nbad.")), "Too\nbad.");
  EXPECT_EQ(message_of(std::runtime_error("plain")), "plain");
  try
    {
      AssertThrow(false, dealii::ExcNotImplemented());
    }
  catch (const std::exception &error)
    {
      EXPECT_NE(message_of(error).find("ExcNotImplemented"), std::string::npos);
      EXPECT_EQ(message_of(error).find("----"), std::string::npos);
    }
}


TEST(ErrorsMpi, RootsFailureReachesEveryProcess)
{
  try
    {
      on_root(MPI_COMM_WORLD,
              []() { AssertThrow(false, dealii::ExcMessage("disk full")); });
      FAIL();
    }
  catch (const std::exception &error)
    {
      EXPECT_EQ(message_of(error), "disk full");
    }
  int calls = 0;
  on_root(MPI_COMM_WORLD, [&calls]() { ++calls; });
  EXPECT_EQ(dealii::Utilities::MPI::sum(calls, MPI_COMM_WORLD), 1);
}


TEST(ErrorsMpi, GuardReturnsTheCode)
{
  EXPECT_EQ(run_guarded(MPI_COMM_WORLD, []() { return 3; }), 3);
  ::testing::internal::CaptureStderr();
  const int   code   = run_guarded(MPI_COMM_WORLD, []() -> int {
    AssertThrow(false, dealii::ExcMessage("all fail"));
  });
  std::string output = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, 1);
  const bool is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  EXPECT_EQ(output, is_root ? "Error: all fail\n" : "");
}


TEST(ErrorsMpi, AnyFailureReachesEveryProcess)
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int last =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  try
    {
      on_all(MPI_COMM_WORLD, [&]() {
        AssertThrow(rank != last, dealii::ExcMessage("disk of the last full"));
      });
      FAIL();
    }
  catch (const std::exception &error)
    {
      EXPECT_EQ(message_of(error), "disk of the last full");
    }
  int calls = 0;
  on_all(MPI_COMM_WORLD, [&calls]() { ++calls; });
  EXPECT_EQ(calls, 1);
}
