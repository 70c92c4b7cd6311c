// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_facet_h
#define thalweg_interface_facet_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A plane piece of the interface: a segment in 2D, a triangle in
   * 3D.
   */
  template <int dim>
  struct Facet
  {
    dealii::Point<dim> origin; ///< any point nearby
    /// The ways from there, m: their digits do not depend on where the domain
    /// is.
    std::array<dealii::Tensor<1, dim>, dim> corners;
    /// Bit i is set if the side opposite to corner i (in 2D the other
    /// corner) lies on the boundary of the domain: there the facet goes on
    /// to infinity, between the lines of its other sides.
    unsigned int open_sides = 0;
  };

  /// Distances whose relative difference is less than this are the same: where
  /// a plane is meant round-off must not decide what is nearest, also far from
  /// the origin.
  constexpr double same_distance = 1e-6;

  /// The distance of a point from a facet, continued beyond its open sides.
  struct FacetDistance
  {
    double distance;
    /// Whether the nearest point of the facet lies on one of its sides.
    bool on_side;
  };

  template <int dim>
  FacetDistance
  distance(const Facet<dim> &facet, const dealii::Point<dim> &x);

  /// The distance of @p x from the plane (in 2D: the line) of a facet;
  /// infinite if it has no extent.
  template <int dim>
  double
  distance_from_plane(const Facet<dim> &facet, const dealii::Point<dim> &x);

  /**
   * @brief The distance of @p x from the planes of those facets at whose sides
   * a surface ends within the domain; infinite if it does not.
   * @param facets those that are nearest to @p x, all as far away, at their
   *   sides; it ends at a side that is not that of two facets
   */
  template <int dim>
  double
  distance_beyond_end(const std::vector<Facet<dim>> &facets,
                      const dealii::Point<dim>      &x);

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
        std::max(longest, (facet.corners[i] - facet.corners[0]).norm_square());
    return ((x - facet.origin) - facet.corners[0]).norm() - std::sqrt(longest);
  }
} // namespace Thalweg

#endif
