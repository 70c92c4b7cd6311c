// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_time_control_h
#define thalweg_simulation_time_control_h

#include <thalweg/core/section.h>
#include <thalweg/core/step_number.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief The parameters of the section "Time", and the size of steps.
   */
  class TimeControl
  {
  public:
    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// @throws dealii::ExcMessage for impossible values
    void
    check() const;

    double
    end_time() const
    {
      return end;
    }

    /// Whether the run is over after @p step steps at @p time.
    bool
    is_over(const double time, const unsigned int step) const;

    /**
     * @brief A step as it is planned.
     */
    struct Step
    {
      double size; ///< s
      /// When it ends, s: a target exactly, with the bits of its multiple,
      /// whatever the sum of the steps before.
      double end;
      /// The longest step that was allowed, s.
      double wanted;
    };

    /**
     * @brief Plans the next step.
     * @param time now, s
     * @param numbers that bound the steps, but not those of a given size
     * @param old_wanted Step::wanted of the last step, or its size if it had
     *   to be made shorter than planned; 0 at the start
     * @param old_size of the last step; a new one that differs by round-off
     *   only has the same bits, so that nothing has to be set up for it
     *
     * What is left to the next target, the end or a multiple that the
     * parameter asks for, is divided into the smallest number of equal steps
     * that are not longer than what is allowed. So no step is shorter than
     * half of the shorter one of these two.
     */
    Step
    next_step(const double       time,
              const StepNumbers &numbers,
              const double       old_wanted,
              const double       old_size = 0.) const;

    /// What is to be said at the start about a given step that is too long
    /// for the method; empty: nothing.
    std::string
    warning(const StepNumbers &numbers) const;

  private:
    /// The step that is allowed, before what is left is divided. Arguments as
    /// of next_step().
    double
    wanted_step(const double       time,
                const StepNumbers &numbers,
                const double       old_wanted) const;

    /// The largest value of @p number that a step may have.
    double
    largest(const StepNumber &number) const;

    /// How much longer than allowed a step may become, as a part of it.
    double
    stretch() const;

    /// The next time that a step must hit, for steps of @p wanted.
    double
    target(const double time, const double wanted) const;

    /// The smallest number of steps of @p wanted, or a little more, in @p left.
    double
    n_steps(const double left, const double wanted) const;

    double       end            = 1.;
    double       fixed_step     = 0.;
    double       courant_number = 2.;
    double       fourier_number = 1e30;
    double       minimum        = 1e-9;
    double       maximum        = 1e-2;
    double       growth         = 1.5;
    double       first          = 1e-3;
    double       hit_multiples  = 0.;
    unsigned int maximal_steps  = 1000000000;
  };
} // namespace Thalweg

#endif
