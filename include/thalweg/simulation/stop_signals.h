#ifndef thalweg_simulation_stop_signals_h
#define thalweg_simulation_stop_signals_h

#include <mpi.h>

namespace Thalweg
{
  /**
   * @brief Catches SIGTERM, after which a run ends with a checkpoint, and
   * SIGUSR1, after which it writes one and goes on.
   *
   * Batch systems send one of them before the time of a job is over. Before
   * and after the life of the object they do what they did before.
   */
  class StopSignals
  {
  public:
    StopSignals();

    ~StopSignals();

    StopSignals(const StopSignals &) = delete;

    /// What any process was told since the last call.
    enum class Wish
    {
      nothing,
      checkpoint,
      stop
    };

    /// Collective; the same on all processes.
    Wish
    wish(const MPI_Comm communicator);
  };
} // namespace Thalweg

#endif
