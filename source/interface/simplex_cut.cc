#include <thalweg/interface/simplex_cut.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace SimplexCut
  {
    namespace
    {
      template <int dim>
      dealii::Point<dim>
      vertex(const unsigned int v)
      {
        dealii::Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = (v >> d) & 1u;
        return point;
      }



      template <int dim>
      double
      average(const std::array<double, (1 << dim)> &phi)
      {
        double sum = 0;
        for (const double value : phi)
          sum += value;
        return sum / phi.size();
      }



      /// Corners of the quadrilateral's boundary in circular order.
      constexpr unsigned int circle[4] = {0, 1, 3, 2};
    } // namespace



    template <>
    std::array<Simplex<2>, 4>
    divide<2>(const std::array<double, 4> &phi)
    {
      std::array<Simplex<2>, 4> simplices;
      const double              center = average<2>(phi);
      for (unsigned int e = 0; e < 4; ++e)
        {
          const unsigned int a = circle[e], b = circle[(e + 1) % 4];
          simplices[e] = {{{vertex<2>(a), vertex<2>(b), {.5, .5}}},
                          {{phi[a], phi[b], center}}};
        }
      return simplices;
    }



    template <>
    std::array<Simplex<3>, 24>
    divide<3>(const std::array<double, 8> &phi)
    {
      std::array<Simplex<3>, 24> simplices;
      const double               center = average<3>(phi);
      unsigned int               s      = 0;
      for (unsigned int normal = 0; normal < 3; ++normal)
        for (unsigned int side = 0; side < 2; ++side)
          {
            std::array<unsigned int, 4> corners;
            for (unsigned int c = 0; c < 4; ++c)
              {
                const unsigned int u = circle[c] & 1u, v = circle[c] >> 1;
                corners[c] = (side << normal) + (u << ((normal + 1) % 3)) +
                             (v << ((normal + 2) % 3));
              }
            dealii::Point<3> middle(.5, .5, .5);
            middle[normal]       = side;
            const double on_face = (phi[corners[0]] + phi[corners[1]] +
                                    phi[corners[2]] + phi[corners[3]]) /
                                   4.;
            for (unsigned int e = 0; e < 4; ++e)
              {
                const unsigned int a = corners[e], b = corners[(e + 1) % 4];
                simplices[s++] = {
                  {{vertex<3>(a), vertex<3>(b), middle, {.5, .5, .5}}},
                  {{phi[a], phi[b], on_face, center}}};
              }
          }
      return simplices;
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
