#ifndef thalweg_simulation_progress_h
#define thalweg_simulation_progress_h

#include <thalweg/core/context.h>

#include <chrono>

namespace Thalweg
{
  /**
   * @brief The line that tells how far a run is, and the summary at its end.
   */
  class Progress
  {
  public:
    /// @param context where to write
    explicit Progress(Context &context);

    /// One line for a step, at most two a second on the terminal.
    void
    report(const unsigned int step,
           const double       time,
           const double       end_time,
           const double       dt,
           const double       courant_number,
           const double       n_particles,
           const bool         force);

    /// Timers by phase on the terminal and in `timers.csv`. Collective.
    void
    summarize(const unsigned int n_steps);

  private:
    using Clock = std::chrono::steady_clock;

    Context          &context;
    Clock::time_point start;
    Clock::time_point last_line;
  };
} // namespace Thalweg

#endif
