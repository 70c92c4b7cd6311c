// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_numerical_derivative_h
#define thalweg_fields_numerical_derivative_h

#include <functional>

namespace Thalweg
{
  /// A function of time, s.
  using FunctionOfTime = std::function<double(const double)>;

  /**
   * @brief The first (@p order 1) or second (2) derivative of a smooth
   * function, by central differences of falling distance, extrapolated to
   * zero; of all extrapolated values the one that differs least from its
   * predecessors (C. Ridders, Adv. Eng. Software 4, 1982).
   *
   * Distances are from 0.1 s to 3e-6 s; those at which the function is not
   * finite do not count. For a sine of period T the relative error of the
   * second derivative is below 1e-8 for T from 1e-3 to 1e2 s.
   * @return not a number if the function is not finite around @p t
   */
  double
  derivative(const FunctionOfTime &function,
             const double          t,
             const unsigned int    order);

  /**
   * @brief The integral of @p function from @p begin to @p end, by Gauss
   * quadrature on so many equal parts that twice as many change it by less
   * than 1e-12 of the integral of its absolute value, or on 2^14.
   */
  double
  integral(const FunctionOfTime &function,
           const double          begin,
           const double          end);
} // namespace Thalweg

#endif
