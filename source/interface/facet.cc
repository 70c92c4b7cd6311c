// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/facet.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    double
    square_distance_from_segment(const dealii::Tensor<1, 3> &a,
                                 const dealii::Tensor<1, 3> &b,
                                 const dealii::Tensor<1, 3> &x)
    {
      const auto   edge          = b - a;
      const double length_square = edge.norm_square();
      const double t             = length_square > 0
                                     ? std::clamp((x - a) * edge / length_square, 0., 1.)
                                     : 0.;
      return (x - a - t * edge).norm_square();
    }



    /// For each side whether the foot of @p x in the facet's plane lies on
    /// its inner side, bit by bit; and the square of the height above it.
    struct Foot
    {
      unsigned int inside        = 0;
      double       square_height = 0;
    };



    Foot
    foot(const Facet<2> &facet, const dealii::Tensor<1, 2> &x)
    {
      const auto &[a, b]  = facet.corners;
      const auto   edge   = b - a;
      const double square = edge.norm_square();
      Foot         foot;
      if (square > 0)
        {
          const double t      = (x - a) * edge / square;
          const double height = cross_product_2d(edge) * (x - a);
          foot.inside         = (t <= 1. ? 1u : 0u) | (t >= 0. ? 2u : 0u);
          foot.square_height  = height * height / square;
        }
      return foot;
    }



    Foot
    foot(const Facet<3> &facet, const dealii::Tensor<1, 3> &x)
    {
      const auto &corners = facet.corners;
      const auto  normal =
        cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
      const double square = normal.norm_square();
      Foot         foot;
      if (square > 0)
        {
          for (unsigned int i = 0; i < 3; ++i)
            {
              const auto &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
              if (cross_product_3d(b - a, x - a) * normal >= 0)
                foot.inside |= 1u << i;
            }
          const double height = (x - corners[0]) * normal;
          foot.square_height  = height * height / square;
        }
      return foot;
    }



    double
    square_distance_from_sides(const Facet<2>             &facet,
                               const dealii::Tensor<1, 2> &x)
    {
      return std::min((x - facet.corners[0]).norm_square(),
                      (x - facet.corners[1]).norm_square());
    }



    double
    square_distance_from_sides(const Facet<3>             &facet,
                               const dealii::Tensor<1, 3> &x)
    {
      const auto &[a, b, c] = facet.corners;
      return std::min({square_distance_from_segment(a, b, x),
                       square_distance_from_segment(b, c, x),
                       square_distance_from_segment(c, a, x)});
    }



    double
    distance_from_side(const Facet<2>             &facet,
                       const unsigned int          i,
                       const dealii::Tensor<1, 2> &x)
    {
      return (x - facet.corners[1 - i]).norm();
    }



    double
    distance_from_side(const Facet<3>             &facet,
                       const unsigned int          i,
                       const dealii::Tensor<1, 3> &x)
    {
      return std::sqrt(square_distance_from_segment(facet.corners[(i + 1) % 3],
                                                    facet.corners[(i + 2) % 3],
                                                    x));
    }



    bool
    is_same_side(const Facet<2>    &a,
                 const unsigned int i,
                 const Facet<2>    &b,
                 const unsigned int j,
                 const double       tolerance)
    {
      return ((a.origin - b.origin) + (a.corners[1 - i] - b.corners[1 - j]))
               .norm() <= tolerance;
    }



    bool
    is_same_side(const Facet<3>    &a,
                 const unsigned int i,
                 const Facet<3>    &b,
                 const unsigned int j,
                 const double       tolerance)
    {
      const auto is_same = [&](const unsigned int k, const unsigned int l) {
        return ((a.origin - b.origin) +
                (a.corners[(i + k) % 3] - b.corners[(j + l) % 3]))
                 .norm() <= tolerance;
      };
      return (is_same(1, 1) && is_same(2, 2)) ||
             (is_same(1, 2) && is_same(2, 1));
    }
  } // namespace



  template <int dim>
  FacetDistance
  distance(const Facet<dim> &facet, const dealii::Point<dim> &x)
  {
    constexpr unsigned int       all_sides = (1u << dim) - 1;
    const dealii::Tensor<1, dim> way       = x - facet.origin;
    const Foot                   at        = foot(facet, way);
    const bool                   is_inside =
      at.inside != 0 && (at.inside | facet.open_sides) == all_sides;
    return {std::sqrt(is_inside ? at.square_height
                                : square_distance_from_sides(facet, way)),
            !is_inside};
  }



  template <int dim>
  double
  distance_from_plane(const Facet<dim> &facet, const dealii::Point<dim> &x)
  {
    const Foot at = foot(facet, dealii::Tensor<1, dim>(x - facet.origin));
    return at.inside != 0 ? std::sqrt(at.square_height)
                          : std::numeric_limits<double>::infinity();
  }



  template <int dim>
  double
  distance_beyond_end(const std::vector<Facet<dim>> &facets,
                      const dealii::Point<dim>      &x)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double           nearest  = infinity;
    for (const auto &facet : facets)
      for (unsigned int i = 0; i < dim; ++i)
        nearest =
          std::min(nearest, distance_from_side(facet, i, x - facet.origin));
    const double tolerance = same_distance * nearest;
    const auto   is_shared = [&](const unsigned int f, const unsigned int i) {
      for (unsigned int g = 0; g < facets.size(); ++g)
        for (unsigned int j = 0; j < dim && g != f; ++j)
          if (is_same_side(facets[f], i, facets[g], j, tolerance))
            return true;
      return false;
    };
    double distance = infinity;
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (unsigned int i = 0; i < dim; ++i)
        if (((facets[f].open_sides >> i) & 1u) == 0 &&
            distance_from_side(facets[f], i, x - facets[f].origin) <=
              nearest + tolerance &&
            !is_shared(f, i))
          distance = std::min(distance, distance_from_plane(facets[f], x));
    return distance;
  }



#define THALWEG_INSTANTIATE_FACET(dim)                                         \
  template FacetDistance distance<dim>(const Facet<dim> &,                     \
                                       const dealii::Point<dim> &);            \
  template double        distance_from_plane<dim>(const Facet<dim> &,          \
                                           const dealii::Point<dim> &); \
  template double distance_beyond_end<dim>(const std::vector<Facet<dim>> &,    \
                                           const dealii::Point<dim> &);
  THALWEG_INSTANTIATE_FACET(2)
  THALWEG_INSTANTIATE_FACET(3)
#undef THALWEG_INSTANTIATE_FACET
} // namespace Thalweg
