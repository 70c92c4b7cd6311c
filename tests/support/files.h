// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_files_h
#define tests_support_files_h

#include <deal.II/base/mpi.h>

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>

/// All that stands in the file at @p path; nothing if there is none.
inline std::string
content(const std::string &path)
{
  const std::ifstream file(path);
  std::ostringstream  text;
  text << file.rdbuf();
  return text.str();
}

/// A path that no other run of the tests uses, the same on all processes.
inline std::string
own_path(const std::string &name)
{
  const int number =
    dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, int(getpid()), 0);
  return ::testing::TempDir() + "thalweg_" + std::to_string(number) + "_" +
         name;
}

#endif
