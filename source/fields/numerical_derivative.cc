// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/numerical_derivative.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Thalweg
{
  namespace
  {
    /// No round number: a sine whose period divides the distance would look
    /// constant.
    constexpr double       first_distance = .0937;
    constexpr double       ratio          = 1.4142135623730951;
    constexpr unsigned int n_distances    = 30;


    double
    difference(const FunctionOfTime &f,
               const double          t,
               const double          wanted,
               const unsigned int    order)
    {
      // A distance without round-off in t + h.
      volatile const double there = t + wanted;
      const double          h     = there - t;
      return order == 1 ? (f(t + h) - f(t - h)) / (2. * h)
                        : (f(t + h) - 2. * f(t) + f(t - h)) / (h * h);
    }
  } // namespace



  double
  derivative(const FunctionOfTime &function,
             const double          t,
             const unsigned int    order)
  {
    double              best  = std::numeric_limits<double>::quiet_NaN();
    double              error = std::numeric_limits<double>::infinity();
    std::vector<double> before;
    double              distance = first_distance;
    for (unsigned int k = 0; k < n_distances; ++k, distance /= ratio)
      {
        std::vector<double> row{difference(function, t, distance, order)};
        if (!std::isfinite(row[0]))
          {
            before.clear();
            continue;
          }
        if (before.empty() && !std::isfinite(best))
          best = row[0];
        // Neville's scheme in the square of the distance.
        double factor = 1.;
        for (unsigned int j = 0; j < before.size(); ++j)
          {
            factor *= ratio * ratio;
            row.push_back((factor * row[j] - before[j]) / (factor - 1.));
            const double estimate = std::max(std::abs(row[j + 1] - row[j]),
                                             std::abs(row[j + 1] - before[j]));
            if (j > 0 && estimate < error)
              {
                error = estimate;
                best  = row[j + 1];
              }
          }
        before = row;
      }
    return best;
  }



  double
  integral(const FunctionOfTime &function, const double begin, const double end)
  {
    // Gauss points and weights for polynomials of degree 7.
    const std::array<double, 2> place{{.3399810435848563, .8611363115940526}};
    const std::array<double, 2> weight{{.6521451548625461, .3478548451374538}};
    double                      last = std::numeric_limits<double>::infinity();
    for (unsigned int n = 16; n <= (1u << 14); n *= 2)
      {
        double       sum = 0., size = 0.;
        const double half = .5 * (end - begin) / n;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int q = 0; q < 2; ++q)
            for (const double side : {-1., 1.})
              {
                const double value =
                  half * weight[q] *
                  function(begin + half * (2. * i + 1. + side * place[q]));
                sum += value;
                size += std::abs(value);
              }
        if (std::abs(sum - last) <= 1e-12 * size)
          return sum;
        last = sum;
      }
    return last;
  }
} // namespace Thalweg
