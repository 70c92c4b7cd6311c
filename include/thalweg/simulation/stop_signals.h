// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_stop_signals_h
#define thalweg_simulation_stop_signals_h

#include <csignal>
#include <map>
#include <mpi.h>

namespace Thalweg
{
  /**
   * @brief Catches SIGTERM, SIGINT, SIGHUP and SIGUSR2, after which a run ends
   * with a checkpoint, and SIGUSR1, after which it writes one and goes on.
   *
   * Batch systems send one of them before the time of a job is over. A second
   * SIGINT ends the process at once. Signals that are ignored when the object
   * is made, as nohup does with SIGHUP, stay so.
   *
   * Before steps begin there is nothing to save, and what is told to stop stops
   * at once. A terminal or a pipe that nobody reads any more, and a limit of
   * the size of files, do not end the process: writing fails instead.
   *
   * There can be one object at a time; after its life signals do what they did
   * before, but for those two of pipes and limits.
   */
  class StopSignals
  {
  public:
    /// @param communicator all processes of the run. Collective
    explicit StopSignals(const MPI_Comm communicator);

    ~StopSignals();

    StopSignals(const StopSignals &) = delete;

    /// From now on there is something to save.
    void
    begin_steps();

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

    /// The number of the signal that said stop, after wish() did; 0 before.
    int
    stopped_by() const
    {
      return signal;
    }

    /// Its name.
    const char *
    name() const;

  private:
    void
    handle(const int number, void (*handler)(int));

    std::map<int, struct sigaction> old;
    int                             signal = 0;
  };
} // namespace Thalweg

#endif
