// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_progress_h
#define thalweg_simulation_progress_h

#include <thalweg/core/context.h>

#include <chrono>

namespace Thalweg
{
  /**
   * @brief The line that tells how far a run is, and the summary at its end.
   *
   * Speed and wall times are those of this process: what a resumed run did
   * before, perhaps on another machine, does not count.
   */
  class Progress
  {
  public:
    /// @param context where to write
    explicit Progress(Context &context);

    /// One line for a step, at most two a second on the terminal; to be
    /// called after every step.
    /// @param headline what the method says
    void
    report(const unsigned int step,
           const double       time,
           const double       end_time,
           const double       dt,
           const double       courant_number,
           const std::string &headline,
           const bool         force);

    /// Timers by phase on the terminal and in `timers.csv`. Collective.
    /// @param n_steps since the run's start
    void
    summarize(const unsigned int n_steps);

  private:
    using Clock = std::chrono::steady_clock;

    Context          &context;
    Clock::time_point start;
    Clock::time_point last_line;
    /// Where this process began: with the first step it reports.
    bool         has_begun  = false;
    unsigned int first_step = 1;
    double       first_time = 0.; ///< s
  };
} // namespace Thalweg

#endif
