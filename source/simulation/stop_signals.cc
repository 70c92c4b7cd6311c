#include <thalweg/simulation/stop_signals.h>

#include <deal.II/base/mpi.h>

#include <csignal>

namespace Thalweg
{
  namespace
  {
    volatile std::sig_atomic_t is_told_to_stop = 0;
    volatile std::sig_atomic_t is_told_to_save = 0;

    using Handler = void (*)(int);
    Handler old_term, old_user;

    extern "C" void
    note_signal(int signal)
    {
      (signal == SIGTERM ? is_told_to_stop : is_told_to_save) = 1;
    }
  } // namespace



  StopSignals::StopSignals()
  {
    is_told_to_stop = is_told_to_save = 0;
    old_term                          = std::signal(SIGTERM, note_signal);
    old_user                          = std::signal(SIGUSR1, note_signal);
  }



  StopSignals::~StopSignals()
  {
    std::signal(SIGTERM, old_term);
    std::signal(SIGUSR1, old_user);
  }



  StopSignals::Wish
  StopSignals::wish(const MPI_Comm communicator)
  {
    const unsigned int own = is_told_to_stop ? 2 : is_told_to_save ? 1 : 0;
    is_told_to_save        = 0;
    return static_cast<Wish>(dealii::Utilities::MPI::max(own, communicator));
  }
} // namespace Thalweg
