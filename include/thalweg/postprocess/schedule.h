// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_schedule_h
#define thalweg_postprocess_schedule_h

#include <thalweg/core/archive.h>
#include <thalweg/core/section.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief When something is written: at the start, then at the first step
   * that ends at or after each multiple of an interval, and at the end.
   */
  class Schedule
  {
  public:
    /// @param interval in s; 0: after every step
    explicit Schedule(const double interval = 0.)
      : interval(interval)
    {}

    /// Declares "Interval". @param what completes "The time between two ..."
    void
    declare_parameters(const Section &section, const std::string &what);

    /**
     * @brief Whether it is due now; asked once a step.
     * @param time of the end of the step, in s
     * @param last_step whether no other will follow
     */
    bool
    is_due(const double time, const bool last_step);

    /// Whether it was due last only since no other step was to follow. What
    /// was written then is dropped when the run goes on after all.
    bool
    was_due_for_the_end() const
    {
      return due_for_the_end;
    }

    void
    keep(const Archive &archive);

  private:
    double interval;
    double next            = -1e300;
    bool   due_for_the_end = false;
  };
} // namespace Thalweg

#endif
