// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_geometry_h
#define thalweg_dem_wall_geometry_h

#include <thalweg/dem/grain_arrays.h>

#include <cstdint>
#include <limits>

namespace Thalweg
{
  constexpr std::uint32_t no_wall = std::numeric_limits<std::uint32_t>::max();
  /// A grain touches no more facets at the same time.
  constexpr unsigned int most_touches = 16;

  /// A part of a wall: a convex polygon in a plane, the whole plane, a cylinder
  /// of endless length, or the side of a truncated cone.
  struct Facet
  {
    enum class Kind : std::uint8_t
    {
      plane,
      polygon,
      cylinder,
      cone
    };

    Kind          kind;
    bool          is_solid;  ///< behind it is no grain: it pushes to the front
    std::uint8_t  n_corners; ///< of a polygon, 3 or 4
    std::uint32_t wall;
    /// Of a plane and a cylinder the first is a point, of a cone the middle of
    /// its beginning.
    Vec3   corner[4];
    Vec3   normal; ///< to the front; of a cylinder and a cone the axis
    double radius; ///< of a cylinder, m; negative: grains are outside
    /// Of a cone, m: at the ends not negative.
    double end_radius, length;
    /// Of a cone: on which side grains are, if it is solid.
    bool has_grains_outside;
    /// Of a cone: the line opposite to the grain instead of the nearest one. In
    /// a narrow cone a grain touches both.
    bool is_opposite;
  };

  /// How a wall moves now, and what it is made of.
  struct Wall
  {
    Vec3         v;      ///< of its center, m/s
    Vec3         w;      ///< rad/s
    Vec3         center; ///< m
    unsigned int material;
    bool         is_there; ///< grains feel it
    /// By which the surface slides in itself, as that of a belt does, m/s.
    Vec3 slide{0., 0., 0.};

    /// The velocity of its surface, m/s.
    THALWEG_INLINE Vec3
    velocity_at(const Vec3 &x, const Vec3 &normal) const
    {
      return v + cross(w, x - center) + slide - dot(slide, normal) * normal;
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
    std::uint32_t wall;
    bool          is_on_edge; ///< of the facet
  };



  /**
   * @brief How the side of a truncated cone is seen from a place: the nearest
   * point of one of its lines, in the plane of that and the axis.
   */
  struct ConeView
  {
    Vec3   outwards;              ///< from the axis, in that plane
    double from_axis, along_axis; ///< of the place in that plane, m
    double radius, height;        ///< of the nearest point, m
    double slope_out, slope_up;   ///< the direction of the line
    bool   is_inside;             ///< whether it is no end of the line
  };

  THALWEG_INLINE ConeView
  view_cone(const Facet &facet, const Vec3 &x)
  {
    ConeView   view;
    const Vec3 from_begin = x - facet.corner[0];
    view.along_axis       = dot(from_begin, facet.normal);
    const Vec3 arm        = from_begin - view.along_axis * facet.normal;
    view.from_axis        = norm(arm);
    // On the axis any direction will do.
    const Vec3 other =
      std::abs(facet.normal.x) < .8 ? Vec3{1., 0., 0.} : Vec3{0., 1., 0.};
    const Vec3   across = cross(facet.normal, other);
    const double tiny   = 1e-14 * (facet.radius + facet.end_radius);
    view.outwards       = view.from_axis > tiny ? (1. / view.from_axis) * arm
                                                : (1. / norm(across)) * across;
    if (facet.is_opposite)
      {
        view.outwards  = -view.outwards;
        view.from_axis = -view.from_axis;
      }
    const double widening = facet.end_radius - facet.radius;
    const double inverse =
      1. / std::sqrt(widening * widening + facet.length * facet.length);
    view.slope_out = inverse * widening;
    view.slope_up  = inverse * facet.length;
    double part = inverse * ((view.from_axis - facet.radius) * view.slope_out +
                             view.along_axis * view.slope_up);
    view.is_inside = part >= 0. && part <= 1.;
    part           = part < 0. ? 0. : part > 1. ? 1. : part;
    view.radius    = facet.radius + part * widening;
    view.height    = part * facet.length;
    return view;
  }



  /// Whether a grain touches a truncated cone. @param distance of the surface
  THALWEG_INLINE bool
  touches_cone(const Facet      &facet,
               const GrainPlace &grain,
               FacetTouch       &touch,
               double           &distance)
  {
    const ConeView view = view_cone(facet, grain.x);
    const double   out  = view.from_axis - view.radius;
    const double   up   = view.along_axis - view.height;
    // Towards the axis, at right angles to the line.
    const double inwards = up * view.slope_out - out * view.slope_up;
    const bool   is_out =
      facet.is_solid ? facet.has_grains_outside : inwards < 0.;
    const double side = is_out ? -1. : 1.;
    touch.is_on_edge  = !view.is_inside;
    if (view.is_inside)
      {
        distance = side * inwards;
        if (distance < -2. * grain.r)
          return false;
        touch.normal = (-side * view.slope_up) * view.outwards +
                       (side * view.slope_out) * facet.normal;
        return true;
      }
    if (facet.is_solid && side * inwards < 0.)
      return false;
    distance = std::sqrt(out * out + up * up);
    touch.normal =
      (1. / (distance + 1e-300)) * (out * view.outwards + up * facet.normal);
    return true;
  }



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
    touch.is_on_edge = false;
    if (facet.kind == Facet::Kind::cone)
      {
        if (!touches_cone(facet, grain, touch, distance))
          return false;
      }
    else if (facet.kind == Facet::Kind::cylinder)
      {
        const Vec3 from_point = grain.x - facet.corner[0];
        const Vec3 arm =
          from_point - dot(from_point, facet.normal) * facet.normal;
        const double length  = norm(arm);
        const double inverse = 1. / (length + 1e-300);
        const double side    = facet.radius > 0. ? 1. : -1.;
        distance             = side * (std::abs(facet.radius) - length);
        if (distance < -2. * grain.r)
          return false;
        touch.normal = (-side * inverse) * arm;
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
        touch.is_on_edge = !is_inside;
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



  /// Whether of two contacts the first one counts first: the deeper one. A
  /// point on the edge of two facets is inside of either but for round-off, and
  /// only the normal of that one is exact.
  THALWEG_INLINE bool
  counts_before(const FacetTouch &a, const FacetTouch &b, const double radius)
  {
    if (a.is_on_edge == b.is_on_edge)
      return a.overlap > b.overlap;
    const double equal = 1e-10 * radius;
    return a.is_on_edge ? a.overlap > b.overlap + equal
                        : a.overlap + equal > b.overlap;
  }



  /// Whether a point of contact is behind the planes through those of @p n
  /// others, m.
  THALWEG_INLINE bool
  is_hidden_by(const Vec3        &point,
               const FacetTouch  *touches,
               const Vec3        *points,
               const unsigned int n,
               const double       radius)
  {
    const double in_the_plane = 1e-9 * radius;
    bool         is_hidden    = false;
    for (unsigned int s = 0; s < n; ++s)
      is_hidden =
        is_hidden || dot(point - points[s], touches[s].normal) <= in_the_plane;
    return is_hidden;
  }



  /// visible_touches() where more facets are touched than there is room for:
  /// for each contact it looks at all of them.
  inline unsigned int
  visible_of_many(const Facet         *facets,
                  const Wall          *walls,
                  const std::uint32_t *list,
                  const unsigned int   n,
                  const GrainPlace    &grain,
                  FacetTouch          *touches)
  {
    Vec3 points[most_touches];
    for (unsigned int n_visible = 0; n_visible < most_touches; ++n_visible)
      {
        bool is_found = false;
        for (unsigned int f = 0; f < n; ++f)
          {
            const Facet &facet = facets[list[f]];
            FacetTouch   touch;
            Vec3         point;
            if (!walls[facet.wall].is_there ||
                !touches_facet(facet, grain, touch, point) ||
                is_hidden_by(point, touches, points, n_visible, grain.r) ||
                (is_found &&
                 !counts_before(touch, touches[n_visible], grain.r)))
              continue;
            touch.wall         = facet.wall;
            touches[n_visible] = touch;
            points[n_visible]  = point;
            is_found           = true;
          }
        if (!is_found)
          return n_visible;
      }
    return most_touches;
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
    for (unsigned int f = 0; f < n; ++f)
      {
        const Facet &facet = facets[list[f]];
        FacetTouch   found;
        Vec3         nearest;
        if (!walls[facet.wall].is_there ||
            !touches_facet(facet, grain, found, nearest))
          continue;
        if (n_touches == most_touches)
          return visible_of_many(facets, walls, list, n, grain, touches);
        found.wall         = facet.wall;
        touches[n_touches] = found;
        points[n_touches]  = nearest;
        // Equal ones stay in the order of the list.
        for (unsigned int t = n_touches;
             t > 0 && counts_before(touches[t], touches[t - 1], grain.r);
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
    unsigned int n_visible = 0;
    for (unsigned int t = 0; t < n_touches; ++t)
      {
        if (is_hidden_by(points[t], touches, points, n_visible, grain.r))
          continue;
        touches[n_visible]  = touches[t];
        points[n_visible++] = points[t];
      }
    return n_visible;
  }
} // namespace Thalweg

#endif
