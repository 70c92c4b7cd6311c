// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/ignored_signals.h>
#include <thalweg/simulation/program.h>

// Runs before the constructors of all libraries.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*before_libraries)() = Thalweg::note_ignored_signals;

int
main(int argc, char **argv)
{
  return Thalweg::run_program(argc, argv);
}
