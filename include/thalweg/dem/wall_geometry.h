// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_geometry_h
#define thalweg_dem_wall_geometry_h

#include <thalweg/dem/grain_arrays.h>

#include <cstdint>
#include <limits>

namespace Thalweg
{
  constexpr std::uint32_t no_facet = std::numeric_limits<std::uint32_t>::max();
  /// A grain touches no more facets at the same time.
  constexpr unsigned int most_touches = 16;

  /// A part of a wall: a convex polygon in a plane, the whole plane, or a
  /// cylinder of endless length.
  struct Facet
  {
    enum class Kind : std::uint8_t
    {
      plane,
      polygon,
      cylinder
    };

    Kind          kind;
    bool          is_solid;  ///< behind it is no grain: it pushes to the front
    std::uint8_t  n_corners; ///< of a polygon, 3 or 4
    std::uint32_t wall;
    Vec3          corner[4]; ///< of a plane and a cylinder the first is a point
    Vec3          normal;    ///< to the front; of a cylinder its axis
    double        radius;    ///< of a cylinder, m; negative: grains are outside
  };

  /// How a wall moves now, and what it is made of.
  struct Wall
  {
    Vec3         v;      ///< of its center, m/s
    Vec3         w;      ///< rad/s
    Vec3         center; ///< m
    unsigned int material;
    bool         is_there; ///< grains feel it

    /// The velocity of its surface, m/s.
    THALWEG_INLINE Vec3
    velocity_at(const Vec3 &x) const
    {
      return v + cross(w, x - center);
    }
  };

  /// What acts on a wall.
  struct WallForce
  {
    Vec3 force;  ///< N
    Vec3 torque; ///< about its center, N m
  };

  /// Where a grain touches a facet.
  struct FacetTouch
  {
    double        overlap; ///< m
    Vec3          normal;  ///< towards the grain
    std::uint32_t facet;
    std::uint32_t wall;
  };



  /// The point of a polygon that is nearest to @p x, and whether it is inside.
  THALWEG_INLINE Vec3
  nearest_in_polygon(const Facet &facet, const Vec3 &x, bool &is_inside)
  {
    const double height   = dot(x - facet.corner[0], facet.normal);
    const Vec3   foot     = x - height * facet.normal;
    Vec3         nearest  = foot;
    double       shortest = std::numeric_limits<double>::max();
    is_inside             = true;
    for (unsigned int c = 0; c < facet.n_corners; ++c)
      {
        const Vec3  &a    = facet.corner[c];
        const Vec3  &b    = facet.corner[c + 1 == facet.n_corners ? 0 : c + 1];
        const Vec3   edge = b - a;
        const double side = dot(cross(edge, foot - a), facet.normal);
        if (side >= 0.)
          continue;
        is_inside             = false;
        const double length   = norm_square(edge);
        double       part     = dot(x - a, edge) / length;
        part                  = part < 0. ? 0. : part > 1. ? 1. : part;
        const Vec3   on_edge  = a + part * edge;
        const double distance = norm_square(x - on_edge);
        if (distance < shortest)
          {
            shortest = distance;
            nearest  = on_edge;
          }
      }
    return nearest;
  }



  /// Whether a grain touches a facet, and where.
  /// @param nearest the point of the facet
  THALWEG_INLINE bool
  touches_facet(const Facet      &facet,
                const GrainPlace &grain,
                FacetTouch       &touch,
                Vec3             &nearest)
  {
    double distance;
    if (facet.kind == Facet::Kind::cylinder)
      {
        const Vec3 from_point = grain.x - facet.corner[0];
        const Vec3 arm =
          from_point - dot(from_point, facet.normal) * facet.normal;
        const double length  = norm(arm);
        const double inverse = 1. / (length + 1e-300);
        const double side    = facet.radius > 0. ? 1. : -1.;
        distance             = side * (std::abs(facet.radius) - length);
        touch.normal         = (-side * inverse) * arm;
      }
    else
      {
        bool is_inside = true;
        distance       = dot(grain.x - facet.corner[0], facet.normal);
        if (std::abs(distance) >= grain.r &&
            (!facet.is_solid || distance > 0. || distance < -2. * grain.r))
          return false;
        if (facet.kind == Facet::Kind::polygon)
          nearest = nearest_in_polygon(facet, grain.x, is_inside);
        if (is_inside)
          {
            // A wall has grains on both sides unless it is solid.
            const bool is_behind = distance < 0. && !facet.is_solid;
            touch.normal         = is_behind ? -facet.normal : facet.normal;
            distance             = is_behind ? -distance : distance;
          }
        else
          {
            const Vec3 way = grain.x - nearest;
            if (facet.is_solid && distance < 0.)
              return false;
            distance     = norm(way);
            touch.normal = (1. / (distance + 1e-300)) * way;
          }
      }
    nearest       = grain.x - distance * touch.normal;
    touch.overlap = grain.r - distance;
    return touch.overlap > 0.;
  }



  /**
   * @brief The contacts of a grain with facets that are near.
   *
   * The deepest counts first. Another one does where its point is in front of
   * the planes through those before it: so neighbours in a plane, a shared edge
   * or vertex and convex edges give one contact, corners two or three.
   * @param list the facets near the grain, n of them
   * @param touches room for most_touches of them
   * @return how many there are
   */
  THALWEG_INLINE unsigned int
  visible_touches(const Facet         *facets,
                  const Wall          *walls,
                  const std::uint32_t *list,
                  const unsigned int   n,
                  const GrainPlace    &grain,
                  FacetTouch          *touches)
  {
    unsigned int n_touches = 0;
    Vec3         points[most_touches];
    for (unsigned int f = 0; f < n && n_touches < most_touches; ++f)
      {
        const Facet &facet = facets[list[f]];
        if (!walls[facet.wall].is_there ||
            !touches_facet(facet, grain, touches[n_touches], points[n_touches]))
          continue;
        touches[n_touches].facet = list[f];
        touches[n_touches].wall  = facet.wall;
        // The deepest first; equal ones stay in the order of the list.
        for (unsigned int t = n_touches;
             t > 0 && touches[t].overlap > touches[t - 1].overlap;
             --t)
          {
            const FacetTouch touch = touches[t];
            const Vec3       point = points[t];
            touches[t]             = touches[t - 1];
            points[t]              = points[t - 1];
            touches[t - 1]         = touch;
            points[t - 1]          = point;
          }
        ++n_touches;
      }
    if (n_touches < 2)
      return n_touches;
    unsigned int n_visible    = 0;
    const double in_the_plane = 1e-9 * grain.r;
    for (unsigned int t = 0; t < n_touches; ++t)
      {
        bool is_hidden = false;
        for (unsigned int s = 0; s < n_visible; ++s)
          is_hidden = is_hidden || dot(points[t] - points[s],
                                       touches[s].normal) <= in_the_plane;
        if (is_hidden)
          continue;
        touches[n_visible]  = touches[t];
        points[n_visible++] = points[t];
      }
    return n_visible;
  }
} // namespace Thalweg

#endif
