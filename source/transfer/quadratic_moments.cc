// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/linear_algebra/plane_fit.h>
#include <thalweg/transfer/quadratic_moments.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Thalweg
{
  namespace
  {
    /// A variance below this part of the values' squares is round-off.
    constexpr double smallest_variance = 1e-24;

    /// How much of the variance of single points the value at the node may
    /// have. Among three points in each direction a polynomial of second
    /// degree gets 0.12, at a plane wall 1.5; a plane 0.3 there and 1 or 2 in a
    /// corner.
    constexpr double gain_of_second_degree = .5, gain_of_first_degree = 2.;
  } // namespace



  template <int dim>
  Monomials<dim>::Monomials()
  {
    const auto degree = [](const Exponents &e) {
      return std::accumulate(e.begin(), e.end(), 0u);
    };
    // One more in some direction than a lower one; of those that yield the
    // same the first.
    exponents_of[0] = {};
    lower[0] = direction[0] = 0;
    unsigned int k          = 1;
    for (unsigned int from = 0; k < n; ++from)
      for (unsigned int d = 0; d < dim; ++d)
        {
          Exponents next = exponents_of[from];
          ++next[d];
          const auto end = exponents_of.begin() + k;
          if (k == n || degree(next) > 4 ||
              std::find(exponents_of.begin(), end, next) != end)
            continue;
          exponents_of[k] = next;
          lower[k]        = from;
          direction[k++]  = d;
        }
    for (unsigned int i = 0; i < n_quadratic; ++i)
      for (unsigned int j = 0; j < n_quadratic; ++j)
        {
          Exponents sum = exponents_of[i];
          for (unsigned int d = 0; d < dim; ++d)
            sum[d] += exponents_of[j][d];
          products[i][j] = find(sum);
        }
  }



  template <int dim>
  unsigned int
  Monomials<dim>::find(const Exponents &exponents) const
  {
    return std::distance(exponents_of.begin(),
                         std::find(exponents_of.begin(),
                                   exponents_of.end(),
                                   exponents));
  }



  template <int dim>
  template <unsigned int n>
  bool
  QuadraticMoments<dim>::try_fit(const double largest_gain,
                                 double      &value,
                                 double      &misfit) const
  {
    const auto          &monomials = Monomials<dim>::instance();
    dealii::Tensor<2, n> matrix;
    dealii::Tensor<1, n> load;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          matrix[i][j] = sums[monomials.product(i, j)];
        load[i] = sums[n_monomials + i];
      }
    const PlaneFit<n> polynomial(matrix);
    if (!polynomial.is_determined() ||
        polynomial.variance_of_first() * sums[size - 1] >
          largest_gain * sums[0])
      return false;
    const auto   result   = polynomial.solve(load);
    const double square   = sums[size - 2];
    const double variance = square - load[0] * load[0] / matrix[0][0];
    value                 = result.unknowns[0];
    misfit                = 0.;
    if (variance > smallest_variance * square)
      {
        // As many points of one weight would say as much.
        const double n_points = sums[0] * sums[0] / sums[size - 1];
        misfit = n_points > n + .5 ? std::max(0., square - result.explained) /
                                       variance * n_points / (n_points - n)
                                   : 1.;
      }
    return true;
  }



  template <int dim>
  double
  QuadraticMoments<dim>::one_sidedness() const
  {
    const auto &monomials = Monomials<dim>::instance();
    double      center = 0., spread = 0.;
    for (unsigned int d = 1; d <= dim; ++d)
      {
        center += sums[d] * sums[d];
        spread += sums[monomials.product(d, d)];
      }
    return spread > 0. ? std::sqrt(center / (sums[0] * spread)) : 0.;
  }



  template <int dim>
  double
  QuadraticMoments<dim>::fit(double &misfit) const
  {
    double value;
    if (try_fit<n_quadratic>(gain_of_second_degree, value, misfit) ||
        try_fit<Monomials<dim>::n_linear>(gain_of_first_degree, value, misfit))
      return value;
    misfit = 1.;
    return sums[n_monomials] / sums[0];
  }



  template class Monomials<2>;
  template class Monomials<3>;
  THALWEG_INSTANTIATE(QuadraticMoments)
} // namespace Thalweg
