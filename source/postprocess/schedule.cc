// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/schedule.h>

#include <cmath>

namespace Thalweg
{
  void
  Schedule::declare_parameters(const Section &section, const std::string &what)
  {
    section.add("Interval",
                interval,
                "s",
                "The time between two " + what + "; 0: after every step.",
                dealii::Patterns::Double(0.));
  }


  bool
  Schedule::is_due(const double time, const bool last_step)
  {
    due_for_the_end = false;
    if (interval <= 0.)
      return true;
    // Times that are sums of steps miss a multiple by round-off.
    const double tolerance = 1e-9 * interval;
    if (time < next - tolerance)
      {
        due_for_the_end = last_step;
        return last_step;
      }
    next = (std::floor((time + tolerance) / interval) + 1.) * interval;
    return true;
  }


  void
  Schedule::keep(const Archive &archive)
  {
    archive.value("next", next);
  }
} // namespace Thalweg
