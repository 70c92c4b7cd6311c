#include <thalweg/simulation/time_control.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  void
  TimeControl::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Time");
    section.add("End time", end, "s", "The run ends here.");
    section.add("Time step",
                fixed_step,
                "s",
                "The size of all steps; zero: as the Courant number says.");
    section.add("Courant number",
                courant_number,
                "",
                "How many cells the fastest point moves in a step, where no "
                "time step is given.");
    section.add("Fourier number",
                fourier_number,
                "",
                "The largest kinematic viscosity times the step over the "
                "square of the shortest cell edge, where no time step is "
                "given; by default as large as the method allows.");
    section.add("First step",
                first,
                "s",
                "The first step with a Courant number is no longer than this.");
    section.add("Minimum step",
                minimum,
                "s",
                "The run stops with an error rather than take shorter steps.");
    section.add("Maximum step",
                maximum,
                "s",
                "Steps with a Courant number are no longer than this.");
    section.add("Growth",
                growth,
                "",
                "A step with a Courant number is at most so many times as "
                "long as the one before.");
    section.add("Hit multiples of",
                hit_multiples,
                "s",
                "Steps end exactly at the multiples of this time, for output; "
                "zero: only at the end.",
                dealii::Patterns::Double(0));
    section.add("Maximal number of steps",
                maximal_steps,
                "",
                "The run ends after so many steps at the latest.",
                dealii::Patterns::Integer(0));
  }



  void
  TimeControl::check() const
  {
    const auto positive = [](const double value, const std::string &name) {
      AssertThrow(value > 0,
                  dealii::ExcMessage("'Time/" + name + "' is " +
                                     std::to_string(value) +
                                     "; it must be positive."));
    };
    AssertThrow(end >= 0,
                dealii::ExcMessage("'Time/End time' is " + std::to_string(end) +
                                   "; time runs from zero to later."));
    AssertThrow(fixed_step >= 0,
                dealii::ExcMessage(
                  "'Time/Time step' is " + std::to_string(fixed_step) +
                  "; write a positive step, or zero to use the Courant "
                  "number."));
    if (fixed_step > 0)
      return;
    positive(courant_number, "Courant number");
    positive(fourier_number, "Fourier number");
    positive(first, "First step");
    positive(minimum, "Minimum step");
    positive(maximum, "Maximum step");
    AssertThrow(growth > 1.,
                dealii::ExcMessage("'Time/Growth' is " +
                                   std::to_string(growth) +
                                   "; steps must be allowed to grow, write "
                                   "more than one."));
    AssertThrow(minimum <= maximum,
                dealii::ExcMessage(
                  "'Time/Minimum step' is larger than 'Time/Maximum step'."));
  }



  bool
  TimeControl::is_over(const double time, const unsigned int step) const
  {
    return time >= end * (1. - 1e-12) || step >= maximal_steps;
  }



  std::string
  TimeControl::warning(const Viscous &viscous) const
  {
    if (fixed_step * viscous.rate <= viscous.limit)
      return "";
    std::ostringstream text;
    text << "With 'Time/Time step' = " << fixed_step
         << " s the Fourier number is " << fixed_step * viscous.rate
         << ", but with explicit viscosity the method is stable only up to "
         << viscous.limit << ". The largest stable step is "
         << viscous.limit / viscous.rate << " s.";
    return text.str();
  }



  double
  TimeControl::next_step(const double   time,
                         const double   rate,
                         const double   old_dt,
                         const Viscous &viscous) const
  {
    double dt = fixed_step;
    if (fixed_step == 0.)
      {
        const double by_courant = courant_number / std::max(rate, 1e-300);
        const double by_fourier = std::min(fourier_number, viscous.limit) /
                                  std::max(viscous.rate, 1e-300);
        dt = std::min({maximum, by_courant, by_fourier});
        dt = std::min(dt, old_dt > 0 ? growth * old_dt : first);
        std::ostringstream message;
        message << "At t = " << time << " s a step of " << dt
                << " s would be needed for the "
                << (by_fourier < by_courant ? "Fourier" : "Courant")
                << " number, which is less than 'Time/Minimum step': "
                << (by_fourier < by_courant
                      ? "the cells are too small for this viscosity where it "
                        "is explicit."
                      : "the solution is probably blowing up.");
        AssertThrow(dt >= minimum, dealii::ExcMessage(message.str()));
      }
    // Hit the target in equal steps rather than with a tiny last one.
    double target = end;
    if (hit_multiples > 0)
      target = std::min(end,
                        hit_multiples *
                          (std::floor(time / hit_multiples + 1e-6) + 1.));
    const double left = target - time;
    if (left < (1. + 1e-9) * dt)
      return left;
    return left < 2. * dt && fixed_step == 0. ? .5 * left : dt;
  }
} // namespace Thalweg
