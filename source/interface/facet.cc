#include <thalweg/interface/facet.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    double
    square_distance_from_segment(const dealii::Point<3> &a,
                                 const dealii::Point<3> &b,
                                 const dealii::Point<3> &x)
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
    foot(const Facet<2> &facet, const dealii::Point<2> &x)
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
    foot(const Facet<3> &facet, const dealii::Point<3> &x)
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
    square_distance_from_sides(const Facet<2> &facet, const dealii::Point<2> &x)
    {
      return std::min(facet.corners[0].distance_square(x),
                      facet.corners[1].distance_square(x));
    }



    double
    square_distance_from_sides(const Facet<3> &facet, const dealii::Point<3> &x)
    {
      const auto &[a, b, c] = facet.corners;
      return std::min({square_distance_from_segment(a, b, x),
                       square_distance_from_segment(b, c, x),
                       square_distance_from_segment(c, a, x)});
    }
  } // namespace



  template <int dim>
  double
  distance(const Facet<dim> &facet, const dealii::Point<dim> &x)
  {
    constexpr unsigned int all_sides = (1u << dim) - 1;
    const Foot             at        = foot(facet, x);
    const bool             is_inside =
      at.inside != 0 && (at.inside | facet.open_sides) == all_sides;
    return std::sqrt(is_inside ? at.square_height
                               : square_distance_from_sides(facet, x));
  }



  template double
  distance<2>(const Facet<2> &, const dealii::Point<2> &);
  template double
  distance<3>(const Facet<3> &, const dealii::Point<3> &);
} // namespace Thalweg
