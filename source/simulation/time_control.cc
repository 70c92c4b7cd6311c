// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/simulation/time_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// What a quotient of times loses, as a part of it.
    constexpr double round_off = 1e-11;

    /// What the sum of some 10,000 steps loses, as a part of one of them.
    constexpr double round_off_of_sums = 1e-6;



    /// Whether two steps are equal but for round-off.
    bool
    is_same(const double a, const double b)
    {
      return std::abs(a - b) <= 1e-8 * b;
    }
  } // namespace



  void
  TimeControl::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Time");
    section.add("End time", end, "s", "The run ends here.");
    section.add("Time step",
                fixed_step,
                "s",
                "The size of all steps; zero: as the Courant number says. What "
                "is left to the next time to hit is divided into equal steps "
                "that are not longer, or longer by half a percent at most, so "
                "that 0.333 is a third.");
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
                "The step that the Courant number allows is at most so many "
                "times as long as the one before, of which a step may be a "
                "half where a time to hit is near.");
    section.add("Hit multiples of",
                hit_multiples,
                "s",
                "Steps end exactly at the multiples of this time, for output; "
                "zero: only at the end. They are made equal between two of "
                "these times.",
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
  TimeControl::warning(const StepNumbers &numbers) const
  {
    std::ostringstream text;
    for (const StepNumber &number : numbers)
      if (fixed_step * number.rate > number.stable)
        text << (text.tellp() > 0 ? " " : "")
             << "With 'Time/Time step' = " << fixed_step << " s the "
             << number.title() << " is " << fixed_step * number.rate << ", but "
             << number.where << " the method is stable only up to "
             << number.stable << ". The largest stable step is "
             << number.stable / number.rate << " s.";
    return text.str();
  }



  double
  TimeControl::largest(const StepNumber &number) const
  {
    const double wanted = number.name == StepNumber::courant   ? courant_number
                          : number.name == StepNumber::fourier ? fourier_number
                                                               : number.stable;
    return std::min(wanted, number.stable);
  }



  double
  TimeControl::wanted_step(const double       time,
                           const StepNumbers &numbers,
                           const double       old_wanted) const
  {
    double            dt       = std::numeric_limits<double>::infinity();
    const StepNumber *decisive = nullptr;
    for (const StepNumber &number : numbers)
      {
        if (!std::isfinite(number.rate))
          throw StepRefused("At t = " + std::to_string(time) + " s the " +
                            number.title() +
                            " is no finite number: the solution has blown up.");
        const double own = largest(number) / std::max(number.rate, 1e-300);
        if (own < dt)
          {
            dt       = own;
            decisive = &number;
          }
      }
    if (fixed_step > 0.)
      return fixed_step;
    dt = std::min({dt, maximum, old_wanted > 0 ? growth * old_wanted : first});
    if (dt >= minimum)
      return dt;
    std::ostringstream message;
    message << "At t = " << time << " s a step of " << dt
            << " s would be needed";
    if (decisive != nullptr)
      message << " for the " << decisive->name;
    message << ", which is less than 'Time/Minimum step'";
    if (decisive != nullptr)
      message << ": " << decisive->cause;
    throw StepRefused(message.str() + ".");
  }



  double
  TimeControl::stretch() const
  {
    // Who writes 0.333 means a third: a given step is what its first three
    // digits say, 1.005 being the farthest that they are from what is meant.
    // A step that was computed is a bound.
    return fixed_step > 0. ? 5e-3 : round_off_of_sums;
  }



  double
  TimeControl::n_steps(const double left, const double wanted) const
  {
    const double nearest = std::max(1., std::round(left / wanted));
    return left <= (1. + stretch()) * wanted * nearest
             ? nearest
             : std::ceil(left / wanted);
  }



  double
  TimeControl::target(const double time, const double wanted) const
  {
    if (hit_multiples == 0.)
      return end;
    // Multiples are counted, not summed: a time is one or lies between two,
    // up to the round-off of the quotient.
    const double passed = time / hit_multiples;
    const double next =
      hit_multiples *
      (std::floor(passed + round_off * std::max(1., passed)) + 1.);
    // An end that differs from a multiple by rounding only is meant to be it.
    return end < next + stretch() * wanted ? end : next;
  }



  TimeControl::Step
  TimeControl::next_step(const double       time,
                         const StepNumbers &numbers,
                         const double       old_wanted,
                         const double       old_size) const
  {
    const double wanted = wanted_step(time, numbers, old_wanted);
    const double goal   = target(time, wanted);
    const double left   = goal - time;
    const double n      = n_steps(left, wanted);
    if (n == 1.)
      return {is_same(left, old_size) ? old_size : left, goal, wanted};
    double size = left / n;
    for (const double candidate : {fixed_step, old_size})
      if (is_same(size, candidate))
        size = candidate;
    return {size, time + size, wanted};
  }
} // namespace Thalweg
