// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_mpi_session_h
#define thalweg_core_mpi_session_h

#include <deal.II/base/mpi.h>

#include <array>
#include <string>

namespace Thalweg
{
  /**
   * @brief MPI and the libraries below deal.II, from construction to
   * destruction: the first object of a program.
   *
   * Libraries see nothing of the command line. PETSc would take the options
   * of this program for its own and complain that it knows no use for them,
   * as it does about options for other programs in its environment variable
   * and its file.
   */
  class MpiSession
  {
  public:
    MpiSession();

  private:
    /// What Open MPI reads of its environment when it starts.
    struct Surroundings
    {
      Surroundings();
    };

    Surroundings                             surroundings;
    std::array<std::string, 4>               words;
    std::array<char *, 5>                    arguments;
    int                                      n_arguments;
    char                                   **first;
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };
} // namespace Thalweg

#endif
