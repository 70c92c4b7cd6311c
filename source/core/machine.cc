// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/machine.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

namespace Thalweg
{
  namespace
  {
    constexpr double unlimited = std::numeric_limits<double>::max();


    /// The number in a file; unlimited if there is none.
    double
    limit_in(const char *path)
    {
      std::ifstream file(path);
      double        bytes = 0.;
      return file >> bytes && bytes > 0. ? bytes : unlimited;
    }


    /// What this process may use, bytes.
    double
    memory_here()
    {
      double bytes =
        double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE));
      for (const char *path : {"/sys/fs/cgroup/memory.max",
                               "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        bytes = std::min(bytes, limit_in(path));
      struct rlimit limit;
      if (::getrlimit(RLIMIT_AS, &limit) == 0 &&
          limit.rlim_cur != RLIM_INFINITY)
        bytes = std::min(bytes, double(limit.rlim_cur));
      return bytes;
    }
  } // namespace



  double
  memory_of_machines(const MPI_Comm communicator)
  {
    MPI_Comm machine;
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int n_here = 1;
    MPI_Comm_size(machine, &n_here);
    MPI_Comm_free(&machine);
    return dealii::Utilities::MPI::sum(memory_here() / n_here, communicator);
  }
} // namespace Thalweg
