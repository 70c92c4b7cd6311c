// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_simplices.h>
#include <thalweg/interface/simplex_cut.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace SimplexCut
  {
    template <int dim>
    std::array<Simplex<dim>, n_simplices<dim>>
    divide(const std::array<dealii::Point<dim>, (1 << dim)> &vertices,
           const std::array<double, (1 << dim)>             &phi)
    {
      const auto &division = Q1::Division<dim>::instance();
      std::array<dealii::Tensor<1, dim>, (1 << dim)> positions;
      for (unsigned int v = 0; v < positions.size(); ++v)
        positions[v] = vertices[v];
      const auto points = division.extend(positions);
      const auto values = division.extend(phi);
      std::array<Simplex<dim>, n_simplices<dim>> simplices;
      for (unsigned int s = 0; s < n_simplices<dim>; ++s)
        for (unsigned int c = 0; c < dim + 1; ++c)
          {
            const unsigned int point = division.corners[s][c];
            simplices[s].corners[c]  = dealii::Point<dim>(points[point]);
            simplices[s].phi[c]      = values[point];
          }
      return simplices;
    }



    template <int dim>
    std::array<Simplex<dim>, n_simplices<dim>>
    divide(const std::array<double, (1 << dim)> &phi)
    {
      std::array<dealii::Point<dim>, (1 << dim)> vertices;
      for (unsigned int v = 0; v < vertices.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          vertices[v][d] = (v >> d) & 1u;
      return divide<dim>(vertices, phi);
    }



    template <int dim>
    double
    measure(const Simplex<dim> &simplex)
    {
      dealii::Tensor<2, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
        edges[d] = simplex.corners[d + 1] - simplex.corners[0];
      return std::abs(determinant(edges)) / (dim == 2 ? 2. : 6.);
    }



    template <int dim>
    dealii::Tensor<1, dim>
    gradient(const Simplex<dim> &simplex)
    {
      dealii::Tensor<2, dim> edges;
      dealii::Tensor<1, dim> differences;
      for (unsigned int d = 0; d < dim; ++d)
        {
          edges[d]       = simplex.corners[d + 1] - simplex.corners[0];
          differences[d] = simplex.phi[d + 1] - simplex.phi[0];
        }
      return invert(edges) * differences;
    }



    template <int dim>
    double
    negative_fraction(const std::array<double, (1 << dim)> &phi)
    {
      const auto [smallest, largest] =
        std::minmax_element(phi.begin(), phi.end());
      if (*smallest >= 0)
        return 0.;
      if (*largest <= 0)
        return 1.;
      double fraction = 0;
      for (const Simplex<dim> &simplex : divide<dim>(phi))
        cut(simplex, [&fraction](const Simplex<dim> &piece) {
          if (is_negative(piece))
            fraction += measure(piece);
        });
      return fraction;
    }



    template <>
    std::array<QuadraturePoint<2>, 3>
    quadrature<2>(const Simplex<2> &piece)
    {
      std::array<QuadraturePoint<2>, 3> points;
      const double                      weight = measure(piece) / 3.;
      for (unsigned int q = 0; q < 3; ++q)
        {
          points[q].weight = weight;
          for (unsigned int c = 0; c < 3; ++c)
            points[q].xi += (c == q ? 2. / 3. : 1. / 6.) *
                            dealii::Tensor<1, 2>(piece.corners[c]);
        }
      return points;
    }



    template <>
    std::array<QuadraturePoint<3>, 5>
    quadrature<3>(const Simplex<3> &piece)
    {
      // Keast's rule of degree 3: the centroid with a negative weight, and
      // four points on the medians.
      std::array<QuadraturePoint<3>, 5> points;
      const double                      volume = measure(piece);
      points[4].weight                         = -4. / 5. * volume;
      for (unsigned int c = 0; c < 4; ++c)
        points[4].xi += .25 * dealii::Tensor<1, 3>(piece.corners[c]);
      for (unsigned int q = 0; q < 4; ++q)
        {
          points[q].weight = 9. / 20. * volume;
          for (unsigned int c = 0; c < 4; ++c)
            points[q].xi += (c == q ? 1. / 2. : 1. / 6.) *
                            dealii::Tensor<1, 3>(piece.corners[c]);
        }
      return points;
    }



    template std::array<Simplex<2>, 4>
    divide<2>(const std::array<dealii::Point<2>, 4> &,
              const std::array<double, 4> &);
    template std::array<Simplex<3>, 24>
    divide<3>(const std::array<dealii::Point<3>, 8> &,
              const std::array<double, 8> &);
    template std::array<Simplex<2>, 4>
    divide<2>(const std::array<double, 4> &);
    template std::array<Simplex<3>, 24>
    divide<3>(const std::array<double, 8> &);
    template double
    measure<2>(const Simplex<2> &);
    template double
    measure<3>(const Simplex<3> &);
    template dealii::Tensor<1, 2>
    gradient<2>(const Simplex<2> &);
    template dealii::Tensor<1, 3>
    gradient<3>(const Simplex<3> &);
    template double
    negative_fraction<2>(const std::array<double, 4> &);
    template double
    negative_fraction<3>(const std::array<double, 8> &);
  } // namespace SimplexCut
} // namespace Thalweg
