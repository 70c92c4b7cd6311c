// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/ignored_signals.h>
#include <thalweg/core/mpi_session.h>
#include <thalweg/simulation/program.h>

// Runs before the constructors of all libraries.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*before_libraries)() = Thalweg::note_ignored_signals;

int
main(int argc, char **argv)
{
  const Thalweg::MpiSession mpi;
  return Thalweg::run_guarded(MPI_COMM_WORLD, [argc, argv]() {
    return Thalweg::run_program(MPI_COMM_WORLD,
                                Thalweg::read_options(argc, argv));
  });
}
