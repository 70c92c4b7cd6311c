#include <thalweg/core/context.h>

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Thalweg::Context context(MPI_COMM_WORLD);
  context.log.line("Thalweg " THALWEG_VERSION);
}
