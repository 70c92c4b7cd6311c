#include <thalweg/core/errors.h>
#include <thalweg/simulation/program.h>

#include <cstdlib>

int
main(int argc, char **argv)
{
  // A part of Open MPI that nobody uses here has room for file names of 255
  // letters, and writes beyond.
  setenv("OMPI_MCA_sharedfp", "^lockedfile", 0);
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return Thalweg::run_guarded(MPI_COMM_WORLD, [argc, argv]() {
    return Thalweg::run_program(MPI_COMM_WORLD,
                                Thalweg::read_options(argc, argv));
  });
}
