// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/run_directory.h>

#include <filesystem>
#include <gtest/gtest.h>

#include "support/files.h"

using namespace Thalweg;
namespace fs = std::filesystem;



TEST(RunDirectoryMpi, HoldsWhatWasAskedFor)
{
  const fs::path           top = own_path("run");
  Context                  context(MPI_COMM_WORLD);
  dealii::ParameterHandler prm;
  double                   end_time = 1.;
  prm.add_parameter("End time", end_time);
  prm.set("End time", 2.5);
  if (context.is_root)
    {
      fs::remove_all(top);
      fs::create_directories(top);
      std::ofstream(top / "case.prm") << "set End time = 2.5 # so\n";
    }
  MPI_Barrier(MPI_COMM_WORLD);

  const fs::path directory = top / "a" / "b";
  prepare_run_directory(context,
                        directory.string(),
                        (top / "case.prm").string(),
                        prm);
  EXPECT_EQ(context.output_directory, directory.string());
  if (context.is_root)
    {
      EXPECT_EQ(content(directory / "original.prm"),
                "set End time = 2.5 # so\n");
      EXPECT_NE(content(directory / "parameters.prm").find("End time = 2.5"),
                std::string::npos);
      EXPECT_TRUE(fs::exists(directory / "log.txt"));
      EXPECT_FALSE(fs::exists(directory / "parameters.prm.part"));
    }

  // A file where the directory should be: all processes are told.
  EXPECT_ANY_THROW(
    prepare_run_directory(context, (top / "case.prm" / "c").string(), "", prm));
  MPI_Barrier(MPI_COMM_WORLD);
  if (context.is_root)
    fs::remove_all(top);
}



TEST(RunDirectoryMpi, IsContinuedByAResumedRun)
{
  const fs::path                 directory = own_path("resumed_run");
  const dealii::ParameterHandler prm;
  const auto                     prepare = [&](const bool resumed) {
    Context context(MPI_COMM_WORLD);
    context.resumed = resumed;
    prepare_run_directory(context,
                          directory.string(),
                          (directory / "given.prm").string(),
                          prm);
    context.log.line(resumed ? "second" : "first");
    MPI_Barrier(MPI_COMM_WORLD);
    const std::string log = content(directory / "log.txt");
    // Nobody may go on before all have read it.
    MPI_Barrier(MPI_COMM_WORLD);
    return log;
  };
  const bool is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_root)
    {
      fs::create_directories(directory);
      std::ofstream(directory / "given.prm") << "# once\n";
    }
  EXPECT_EQ(prepare(false), "first\n");
  if (is_root)
    std::ofstream(directory / "given.prm") << "# changed\n";
  EXPECT_EQ(prepare(true), "first\nsecond\n");
  if (is_root)
    {
      EXPECT_EQ(content(directory / "original.prm"), "# once\n");
    }
  EXPECT_EQ(prepare(false), "first\n");
  if (is_root)
    {
      EXPECT_EQ(content(directory / "original.prm"), "# changed\n");
    }
  MPI_Barrier(MPI_COMM_WORLD);
  if (is_root)
    fs::remove_all(directory);
}



TEST(RunDirectory, FilesAreReplacedAsAWhole)
{
  const fs::path path = own_path("whole.txt");
  write_file(path.string(), "first, and longer");
  write_file(path.string(), "second");
  EXPECT_EQ(content(path), "second");
  fs::remove(path);
  EXPECT_ANY_THROW(write_file("/dev/null/file", "x"));
}
