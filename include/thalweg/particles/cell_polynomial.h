// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_cell_polynomial_h
#define thalweg_particles_cell_polynomial_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <limits>

namespace Thalweg
{
  /**
   * @brief Multilinear vector-valued polynomials on the unit cell by their
   * monomials: coefficient `a[dim * m + component]` belongs to the product of
   * those coordinates whose bit is set in m.
   */
  namespace CellPolynomial
  {
    /// From nodal values to the coefficients of 1, x, y, xy, ...
    template <int dim>
    inline void
    to_polynomial(std::array<double, dim *(1 << dim)> &values)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int v = 0; v < (1 << dim); ++v)
          if (v & (1 << d))
            for (unsigned int c = 0; c < dim; ++c)
              values[v * dim + c] -= values[(v ^ (1 << d)) * dim + c];
    }

    /// The vector-valued polynomial with the coefficients a at x.
    inline std::array<double, 2>
    evaluate(const std::array<double, 8> &a, const std::array<double, 2> &x)
    {
      std::array<double, 2> value;
      for (unsigned int c = 0; c < 2; ++c)
        value[c] =
          (a[c] + x[0] * a[2 + c]) + x[1] * (a[4 + c] + x[0] * a[6 + c]);
      return value;
    }

    /// The vector-valued polynomial with the coefficients a at x.
    inline std::array<double, 3>
    evaluate(const std::array<double, 24> &a, const std::array<double, 3> &x)
    {
      std::array<double, 3> value;
      for (unsigned int c = 0; c < 3; ++c)
        value[c] = (a[c] + x[0] * a[3 + c]) +
                   x[1] * (a[6 + c] + x[0] * a[9 + c]) +
                   x[2] * ((a[12 + c] + x[0] * a[15 + c]) +
                           x[1] * (a[18 + c] + x[0] * a[21 + c]));
      return value;
    }

    /// The derivative of the polynomial in direction d: column d.
    template <int dim>
    inline dealii::Tensor<2, dim>
    gradient(const std::array<double, dim *(1 << dim)> &a,
             const std::array<double, dim>             &x)
    {
      dealii::Tensor<2, dim> jacobian;
      for (unsigned int v = 1; v < (1 << dim); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          if (v & (1 << d))
            {
              double monomial = 1;
              for (unsigned int e = 0; e < dim; ++e)
                if (e != d && (v & (1 << e)))
                  monomial *= x[e];
              for (unsigned int c = 0; c < dim; ++c)
                jacobian[c][d] += a[v * dim + c] * monomial;
            }
      return jacobian;
    }

    /// J^{-1} b, or not-a-number where the map is folded.
    template <int dim>
    inline std::array<double, dim>
    solve(const dealii::Tensor<2, dim>  &jacobian,
          const std::array<double, dim> &b)
    {
      std::array<double, dim> result;
      if (!(determinant(jacobian) > 0))
        {
          result.fill(std::numeric_limits<double>::quiet_NaN());
          return result;
        }
      const dealii::Tensor<2, dim> inverse = invert(jacobian);
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[d] = 0;
          for (unsigned int c = 0; c < dim; ++c)
            result[d] += inverse[d][c] * b[c];
        }
      return result;
    }

    /// Whether all coordinates are finite numbers.
    template <int dim>
    inline bool
    is_finite(const std::array<double, dim> &x)
    {
      bool finite = true;
      for (unsigned int d = 0; d < dim; ++d)
        finite &= std::isfinite(x[d]);
      return finite;
    }
  } // namespace CellPolynomial
} // namespace Thalweg

#endif
