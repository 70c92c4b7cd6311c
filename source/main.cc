#include <thalweg/core/errors.h>
#include <thalweg/core/mpi_session.h>
#include <thalweg/simulation/program.h>

int
main(int argc, char **argv)
{
  const Thalweg::MpiSession mpi;
  return Thalweg::run_guarded(MPI_COMM_WORLD, [argc, argv]() {
    return Thalweg::run_program(MPI_COMM_WORLD,
                                Thalweg::read_options(argc, argv));
  });
}
