// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/mpi_session.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <sched.h>
#include <unistd.h>

/**
 * What Open MPI calls while it waits, where there are more processes than
 * cores or mpi_yield_when_idle is set. The system's own function leaves a
 * process among those that are ready to run: once its message is there it must
 * wait until all others have used up their time. Whoever sleeps comes first
 * when it wakes up, which makes runs beside other work up to thirty times
 * faster. (Open MPI 5 has this as threads_pthreads_yield_strategy.)
 */
extern "C" int
sched_yield() noexcept
{
  const timespec shortest{0, 1};
  return nanosleep(&shortest, nullptr);
}

namespace Thalweg
{
  namespace
  {
    /// Whether mpirun, srun or the like started this process.
    bool
    was_launched()
    {
      for (char **variable = environ; *variable != nullptr; ++variable)
        for (const char *launcher : {"OMPI_COMM_WORLD_", "PMIX_", "PMI"})
          if (std::strncmp(*variable, launcher, std::strlen(launcher)) == 0)
            return true;
      return false;
    }
  } // namespace

  MpiSession::Surroundings::Surroundings()
  {
    // A part of Open MPI that nobody uses here has room for file names of 255
    // letters, and writes beyond.
    setenv("OMPI_MCA_sharedfp", "^lockedfile", 0);
    if (was_launched())
      return;
    // A process by itself starts no others and sends nothing: without a daemon
    // beside it and a search for networks it begins half a second earlier.
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_pml", "ob1", 0);
  }

  MpiSession::MpiSession()
    : words{{"thalweg", "-skip_petscrc", "-options_left", "no"}}
    , arguments{{words[0].data(),
                 words[1].data(),
                 words[2].data(),
                 words[3].data(),
                 nullptr}}
    , n_arguments(words.size())
    , first(arguments.data())
    // One thread a process.
    , session(n_arguments, first, 1)
  {}
} // namespace Thalweg
