// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/mpi_session.h>

#include <ctime>
#include <sched.h>

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
