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
    if (interval <= 0.)
      return true;
    // Times that are sums of steps miss a multiple by round-off.
    const double tolerance = 1e-9 * interval;
    if (time < next - tolerance)
      return last_step;
    next = (std::floor((time + tolerance) / interval) + 1.) * interval;
    return true;
  }
} // namespace Thalweg
