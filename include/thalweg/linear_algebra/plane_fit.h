// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_plane_fit_h
#define thalweg_linear_algebra_plane_fit_h

#include <deal.II/base/tensor.h>

#include <cmath>
#include <optional>

namespace Thalweg
{
  /// Below this part of its diagonal entry a pivot says that the particles
  /// around a node determine no plane.
  constexpr double smallest_pivot = 1e-3;

  /**
   * @brief Cholesky's factorization of the symmetric system of n unknowns
   * that a least squares fit leads to; backwards, so that the first unknown
   * comes out first.
   */
  template <int n>
  class PlaneFit
  {
  public:
    explicit PlaneFit(const dealii::Tensor<2, n> &matrix)
    {
      for (int i = n - 1; i >= 0 && determined; --i)
        {
          double pivot = matrix[i][i];
          for (int k = n - 1; k > i; --k)
            pivot -= factor[i][k] * factor[i][k];
          determined = pivot > smallest_pivot * matrix[i][i];
          if (!determined)
            return;
          factor[i][i] = std::sqrt(pivot);
          for (int j = i - 1; j >= 0; --j)
            {
              double entry = matrix[i][j];
              for (int k = n - 1; k > i; --k)
                entry -= factor[i][k] * factor[j][k];
              factor[j][i] = entry / factor[i][i];
            }
        }
    }

    /// Whether no pivot is too small.
    bool
    is_determined() const
    {
      return determined;
    }

    /// The variance of the first unknown if the values have unit variance in
    /// proportion to the inverse of their weights.
    double
    variance_of_first() const
    {
      return 1. / (factor[0][0] * factor[0][0]);
    }

    /// What a fit gives.
    struct Result
    {
      dealii::Tensor<1, n> unknowns;
      /// The part of the sum of squares that is fitted.
      double explained;
    };

    Result
    solve(const dealii::Tensor<1, n> &load) const
    {
      dealii::Tensor<1, n> y;
      for (int i = n - 1; i >= 0; --i)
        {
          double value = load[i];
          for (int k = n - 1; k > i; --k)
            value -= factor[i][k] * y[k];
          y[i] = value / factor[i][i];
        }
      dealii::Tensor<1, n> unknowns;
      for (int i = 0; i < n; ++i)
        {
          double value = y[i];
          for (int k = 0; k < i; ++k)
            value -= factor[k][i] * unknowns[k];
          unknowns[i] = value / factor[i][i];
        }
      return {unknowns, y * y};
    }

  private:
    dealii::Tensor<2, n> factor;
    bool                 determined = true;
  };

  /// The first unknown of a symmetric system, or nothing if a pivot is too
  /// small.
  template <int n>
  inline std::optional<double>
  solve_for_first(const dealii::Tensor<2, n> &matrix,
                  const dealii::Tensor<1, n> &load)
  {
    const PlaneFit<n> fit(matrix);
    if (!fit.is_determined())
      return {};
    return fit.solve(load).unknowns[0];
  }
} // namespace Thalweg

#endif
