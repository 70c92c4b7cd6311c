// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_lagrange_shape_h
#define thalweg_fields_lagrange_shape_h

#include <deal.II/base/point.h>

#include <array>

namespace Thalweg
{
  /// Shape functions of FE_Q of degree 1 and 2 in lexicographic order, for
  /// loops over particles.
  namespace LagrangeShape
  {
    /// (degree + 1)^dim
    constexpr unsigned int
    n_nodes(const unsigned int dim, const unsigned int degree)
    {
      return dim == 0 ? 1 : (degree + 1) * n_nodes(dim - 1, degree);
    }

    /// The values of the shape functions on the unit interval.
    template <unsigned int degree>
    inline std::array<double, degree + 1>
    line(const double x)
    {
      static_assert(degree == 1 || degree == 2, "only degrees 1 and 2");
      if constexpr (degree == 1)
        return {{1. - x, x}};
      else
        return {
          {(1. - x) * (1. - 2. * x), 4. * x * (1. - x), x * (2. * x - 1.)}};
    }

    /// The values of all shape functions at @p xi.
    template <int dim, unsigned int degree>
    inline std::array<double, n_nodes(dim, degree)>
    values(const dealii::Point<dim> &xi)
    {
      std::array<double, n_nodes(dim, degree)> shape;
      shape[0]       = 1.;
      unsigned int n = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto factors = line<degree>(xi[d]);
          for (unsigned int k = degree + 1; k-- > 0;)
            for (unsigned int i = 0; i < n; ++i)
              shape[k * n + i] = shape[i] * factors[k];
          n *= degree + 1;
        }
      return shape;
    }
  } // namespace LagrangeShape
} // namespace Thalweg

#endif
