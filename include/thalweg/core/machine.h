// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_machine_h
#define thalweg_core_machine_h

#include <deal.II/base/mpi.h>

namespace Thalweg
{
  /**
   * @brief How much memory the machines of @p communicator 's processes have
   * together, as far as the processes may use it: of the whole machine, and of
   * the group that a container or a batch system puts them in. Collective.
   * @return bytes
   */
  double
  memory_of_machines(const MPI_Comm communicator);
} // namespace Thalweg

#endif
