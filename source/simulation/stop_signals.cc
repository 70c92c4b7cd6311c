// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/ignored_signals.h>
#include <thalweg/simulation/stop_signals.h>

#include <deal.II/base/mpi.h>

#include <cstring>
#include <unistd.h>

namespace Thalweg
{
  namespace
  {
    volatile std::sig_atomic_t told_to_stop    = 0; ///< number of the signal
    volatile std::sig_atomic_t is_told_to_save = 0;
    volatile std::sig_atomic_t has_steps       = 0;
    volatile std::sig_atomic_t may_speak       = 0;

    /// Ends the process; calls only what a handler of signals may call.
    [[noreturn]] void
    end_at_once(const int number, const char *text)
    {
      if (may_speak)
        {
          const ssize_t written =
            ::write(STDERR_FILENO, text, std::strlen(text));
          static_cast<void>(written); // there is nobody else to tell
        }
      ::_exit(128 + number);
    }

    extern "C" void
    note_signal(int number)
    {
      if (number == SIGUSR1)
        is_told_to_save = 1;
      else if (!has_steps)
        end_at_once(number,
                    "Warning: Stopped by a signal before the first step: there "
                    "is nothing new to save.\n");
      else if (number == SIGINT && told_to_stop == SIGINT)
        end_at_once(number,
                    "Warning: Stopped at once by a second SIGINT: the step is "
                    "not saved.\n");
      else
        told_to_stop = number;
    }
  } // namespace



  StopSignals::StopSignals(const MPI_Comm communicator)
  {
    told_to_stop = is_told_to_save = has_steps = 0;

    may_speak = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2})
      handle(number, note_signal);
    // For good: MPI writes files, too, when it ends.
    for (const int number : {SIGPIPE, SIGXFSZ})
      std::signal(number, SIG_IGN);
  }



  StopSignals::~StopSignals()
  {
    for (const auto &[number, action] : old)
      ::sigaction(number, &action, nullptr);
  }



  void
  StopSignals::handle(const int number, void (*handler)(int))
  {
    struct sigaction action, &before = old[number];
    ::sigaction(number, nullptr, &before);
    std::memset(&action, 0, sizeof(action));
    action.sa_handler = was_ignored(number) ? SIG_IGN : handler;
    action.sa_flags   = SA_RESTART;
    ::sigaction(number, &action, nullptr);
  }



  void
  StopSignals::begin_steps()
  {
    has_steps = 1;
  }



  StopSignals::Wish
  StopSignals::wish(const MPI_Comm communicator)
  {
    // Stopping comes before saving: numbers of signals are above 1.
    const unsigned int own = told_to_stop ? 1 + told_to_stop : is_told_to_save;
    is_told_to_save        = 0;
    const unsigned int all = dealii::Utilities::MPI::max(own, communicator);
    signal                 = all > 1 ? all - 1 : 0;
    return all > 1 ? Wish::stop : all == 1 ? Wish::checkpoint : Wish::nothing;
  }



  const char *
  StopSignals::name() const
  {
    switch (signal)
      {
        case SIGINT:
          return "SIGINT";
        case SIGHUP:
          return "SIGHUP";
        case SIGUSR2:
          return "SIGUSR2";
        default:
          return "SIGTERM";
      }
  }
} // namespace Thalweg
