// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_program_h
#define thalweg_simulation_program_h

#include <thalweg/core/options.h>

#include <deal.II/base/mpi.h>

namespace Thalweg
{
  /**
   * @brief Does what the command line asks for: informs, validates or runs.
   * @param communicator the processes of the run
   * @param options from read_options()
   * @return the exit code
   * @throws dealii::ExcMessage with all faults of the input, or with what
   *   stopped the run
   */
  int
  run_program(const MPI_Comm communicator, const Options &options);

  /// All of main(): with MPI, and with faults as messages.
  /// @return the exit code
  int
  run_program(int argc, char **argv);
} // namespace Thalweg

#endif
