// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_resumed_case_h
#define tests_support_resumed_case_h

#include <filesystem>
#include <memory>
#include <string>

#include "support/files.h"
#include "support/input.h"
#include "support/run_case.h"

/// A run that stops after some steps, and goes on from its checkpoint. All
/// processes make it together.
template <int dim>
class ResumedCase
{
public:
  /// @param text of the input file
  /// @param n_steps before the checkpoint
  ResumedCase(const std::string &text, const unsigned int n_steps)
    : place(own_path("resumed_case"))
  {
    clear();
    if (is_root())
      std::filesystem::create_directories(place);
    MPI_Barrier(MPI_COMM_WORLD);
    RunCase<dim>(text + section("Time",
                                {"Maximal number of steps = " +
                                 std::to_string(n_steps)}),
                 MPI_COMM_WORLD,
                 place);
    run = std::make_unique<RunCase<dim>>(text, MPI_COMM_WORLD, place, true);
  }

  ~ResumedCase()
  {
    run.reset();
    clear();
  }

  /// The run that went on.
  const RunCase<dim> &
  operator*() const
  {
    return *run;
  }

  const RunCase<dim> *
  operator->() const
  {
    return run.get();
  }

private:
  static bool
  is_root()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  void
  clear() const
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (is_root())
      std::filesystem::remove_all(place);
  }

  const std::string             place;
  std::unique_ptr<RunCase<dim>> run;
};

#endif
