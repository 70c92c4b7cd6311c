#ifndef thalweg_interface_facet_h
#define thalweg_interface_facet_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Thalweg
{
  /**
   * @brief A plane piece of the interface: a segment in 2D, a triangle in
   * 3D.
   */
  template <int dim>
  struct Facet
  {
    std::array<dealii::Point<dim>, dim> corners;
    /// Bit i is set if the side opposite to corner i (in 2D the other
    /// corner) lies on the boundary of the domain: there the facet goes on
    /// to infinity, between the lines of its other sides.
    unsigned int open_sides = 0;
  };

  /// The distance of @p x from a facet, continued beyond its open sides.
  template <int dim>
  double
  distance(const Facet<dim> &facet, const dealii::Point<dim> &x);

  /**
   * @brief A lower bound of distance() for facets without open sides, 0 for
   * others; costs much less.
   */
  template <int dim>
  inline double
  distance_bound(const Facet<dim> &facet, const dealii::Point<dim> &x)
  {
    if (facet.open_sides != 0)
      return 0.;
    double longest = 0.;
    for (unsigned int i = 1; i < dim; ++i)
      longest =
        std::max(longest, facet.corners[0].distance_square(facet.corners[i]));
    return facet.corners[0].distance(x) - std::sqrt(longest);
  }
} // namespace Thalweg

#endif
