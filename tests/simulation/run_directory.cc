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



TEST(RunDirectory, FilesAreReplacedAsAWhole)
{
  const fs::path path = own_path("whole.txt");
  write_file(path.string(), "first, and longer");
  write_file(path.string(), "second");
  EXPECT_EQ(content(path), "second");
  fs::remove(path);
  EXPECT_ANY_THROW(write_file("/nonexistent/file", "x"));
}
