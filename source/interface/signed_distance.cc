// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/interface/signed_distance.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// How far from one the slope of a distance may be, by differences.
    constexpr double like_a_distance = 1e-6;

    /// Where the slope changes by this part of itself the function has an
    /// edge.
    constexpr double edge = .1;
  } // namespace



  template <int dim>
  SignedDistance<dim>::SignedDistance(const dealii::Function<dim> &function,
                                      const double                 length)
    : function(function)
    , step(1e-4 * length)
  {}



  template <int dim>
  typename SignedDistance<dim>::Slope
  SignedDistance<dim>::slope(const dealii::Point<dim> &x,
                             const double              value) const
  {
    Slope result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        dealii::Point<dim> before = x, behind = x;
        before[d] -= step;
        behind[d] += step;
        const double left =
          (value - function.value(before)) / (x[d] - before[d]);
        const double right =
          (function.value(behind) - value) / (behind[d] - x[d]);
        result.gradient[d] = .5 * (left + right);
        result.steepest =
          std::max({result.steepest, std::abs(left), std::abs(right)});
        result.roughest = std::max(result.roughest, std::abs(right - left));
      }
    return result;
  }



  template <int dim>
  bool
  SignedDistance<dim>::is_function(const dealii::Point<dim> &x) const
  {
    const Slope at = slope(x, function.value(x));
    return std::abs(at.gradient.norm() - 1.) < like_a_distance ||
           (at.roughest > edge * at.steepest &&
            at.steepest < 1. + like_a_distance);
  }



  template <int dim>
  double
  SignedDistance<dim>::value(const dealii::Point<dim> &x,
                             const unsigned int) const
  {
    constexpr unsigned int most_steps = 50;
    const double           phi        = function.value(x);
    const Slope            first      = slope(x, phi);
    const double           norm       = first.gradient.norm();
    if (phi == 0. || !std::isfinite(norm) || first.steepest == 0.)
      return phi;
    // A slope of one at one place alone may be by chance.
    if (std::abs(norm - 1.) < like_a_distance &&
        is_function(x - .5 * phi * first.gradient))
      return phi;
    if (first.roughest > edge * first.steepest)
      return phi / std::max(1., first.steepest);

    dealii::Point<dim> zero  = x;
    double             value = phi;
    for (unsigned int i = 0; i < most_steps; ++i)
      {
        const auto gradient =
          i == 0 ? first.gradient : slope(zero, value).gradient;
        const double square = gradient.norm_square();
        if (!(square > 0.))
          break;
        const auto change = value / square * gradient;
        zero -= change;
        value = function.value(zero);
        if (!std::isfinite(value))
          break;
        if (change.norm() <= 1e-10 * step + 1e-15 * x.norm())
          return std::copysign(x.distance(zero), phi);
      }
    return phi / norm;
  }



  THALWEG_INSTANTIATE(SignedDistance)
} // namespace Thalweg
