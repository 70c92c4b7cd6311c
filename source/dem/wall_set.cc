// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/wall_set.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Turns a vector about an axis (formula of Rodrigues).
    Vec3
    turned(const Vec3 &a, const Vec3 &axis, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return c * a + s * cross(axis, a) + ((1. - c) * dot(axis, a)) * axis;
    }



    Facet
    moved(const Facet &facet, const MovingWall &wall, const WallPose &pose)
    {
      Facet      result = facet;
      const bool turns  = wall.reach > 0. && pose.angle != 0.;
      const auto place  = [&](const Vec3 &x) {
        const Vec3 &center = wall.course.center;
        return turns ? center + pose.shift +
                         turned(x - center, wall.course.axis, pose.angle)
                      : x + pose.shift;
      };
      const unsigned int n = std::max<unsigned int>(1, facet.n_corners);
      for (unsigned int c = 0; c < n; ++c)
        result.corner[c] = place(facet.corner[c]);
      if (turns)
        result.normal = turned(facet.normal, wall.course.axis, pose.angle);
      return result;
    }



    /// Whether a rotation takes a facet onto itself.
    bool
    slides_in_itself(const Facet &facet, const WallCourse &course)
    {
      constexpr double negligible = 1e-12;
      const Vec3       way        = facet.corner[0] - course.center;
      const Vec3       off        = way - dot(way, course.axis) * course.axis;
      const bool is_along = norm(cross(facet.normal, course.axis)) < negligible;
      return facet.kind != Facet::Kind::polygon && is_along &&
             (facet.kind == Facet::Kind::plane ||
              norm(off) <= negligible * (1. + norm(way)));
    }



    /// The distance of a facet's farthest point from the axis, m.
    double
    reach_of(const Facet &facet, const WallCourse &course, const double extent)
    {
      if (slides_in_itself(facet, course))
        return 0.;
      double     reach = 0.;
      const auto take  = [&](const Vec3 &x, const double radius) {
        reach =
          std::max(reach, norm(cross(x - course.center, course.axis)) + radius);
      };
      const double widest = std::max(std::abs(facet.radius), facet.end_radius);
      if (facet.kind == Facet::Kind::polygon)
        for (unsigned int c = 0; c < facet.n_corners; ++c)
          take(facet.corner[c], 0.);
      else if (facet.kind == Facet::Kind::cone)
        for (const double along : {0., facet.length})
          take(facet.corner[0] + along * facet.normal, widest);
      else
        take(facet.corner[0], extent + widest);
      return reach;
    }



    double
    distance_between(const MovingWall &wall,
                     const WallPose   &a,
                     const WallPose   &b)
    {
      return norm(a.shift - b.shift) + std::abs(a.angle - b.angle) * wall.reach;
    }
  } // namespace



  void
  WallSet::add_moving(const std::vector<Facet> &of_wall,
                      const WallCourse         &course,
                      const unsigned int        material,
                      const double              extent)
  {
    const Vec3 nothing{0., 0., 0.};
    MovingWall one{static_cast<std::uint32_t>(walls.size()),
                   static_cast<std::uint32_t>(facets.size()),
                   of_wall,
                   course,
                   0.,
                   {}};
    for (Facet &facet : one.at_start)
      {
        facet.wall = one.wall;
        facets.push_back(facet);
        if (course.angular_velocity)
          one.reach = std::max(one.reach, reach_of(facet, course, extent));
      }
    walls.push_back({nothing, nothing, course.center, material, true});
    forces.push_back({nothing, nothing});
    moving.push_back(one);
    moving_of_wall.resize(walls.size(), -1);
    moving_of_wall[one.wall] = moving.size() - 1;
  }



  double
  WallSet::move(const double start, const double dt)
  {
    double way = 0.;
    for (MovingWall &wall : moving)
      {
        // The velocity in the middle of the step, as that of grains.
        const WallPose before = wall.now;
        const double   middle = start + .5 * dt;
        if (wall.course.velocity)
          wall.now.shift += dt * wall.course.velocity(middle);
        if (wall.course.angular_velocity)
          wall.now.angle += dt * wall.course.angular_velocity(middle);
        way = std::max(way, distance_between(wall, before, wall.now));
      }
    set_velocities(start + dt);
    return way;
  }



  void
  WallSet::set_velocities(const double now)
  {
    time = now;
    for (const MovingWall &moving_wall : moving)
      {
        const WallCourse &course = moving_wall.course;
        Wall             &wall   = walls[moving_wall.wall];
        wall.center              = course.center + moving_wall.now.shift;
        wall.is_there = course.first_time <= now && now < course.last_time;
        if (course.velocity)
          wall.v = course.velocity(now);
        if (course.angular_velocity)
          wall.w = course.angular_velocity(now) * course.axis;
        if (course.slide)
          wall.slide = course.slide(now);
      }
  }



  void
  WallSet::place_facets(const WallPose MovingWall::*pose)
  {
    for (const MovingWall &wall : moving)
      for (std::size_t f = 0; f < wall.at_start.size() && wall.changes_place();
           ++f)
        facets[wall.first_facet + f] =
          moved(wall.at_start[f], wall, wall.*pose);
  }



  void
  WallSet::place_facets(const std::vector<std::uint32_t> &some)
  {
    for (const std::uint32_t f : some)
      {
        const MovingWall &wall = moving[moving_of_wall[facets[f].wall]];
        facets[f] = moved(wall.at_start[f - wall.first_facet], wall, wall.now);
      }
  }



  std::vector<std::uint32_t>
  WallSet::moving_among(std::vector<std::uint32_t> some) const
  {
    const auto stands = [&](const std::uint32_t f) {
      const std::uint32_t wall = facets[f].wall;
      if (wall >= moving_of_wall.size() || moving_of_wall[wall] < 0)
        return true;
      const MovingWall &mover = moving[moving_of_wall[wall]];
      return !mover.changes_place();
    };
    some.erase(std::remove_if(some.begin(), some.end(), stands), some.end());
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    return some;
  }



  double
  WallSet::farthest() const
  {
    double way = 0.;
    for (const MovingWall &wall : moving)
      way = std::max(way, distance_between(wall, wall.now, wall.reference));
    return way;
  }



  double
  WallSet::fastest(const double now) const
  {
    double speed = 0.;
    for (const MovingWall &wall : moving)
      {
        double of_wall = 0.;
        if (wall.course.velocity)
          of_wall += norm(wall.course.velocity(now));
        if (wall.course.angular_velocity)
          of_wall += std::abs(wall.course.angular_velocity(now)) * wall.reach;
        speed = std::max(speed, of_wall);
      }
    return speed;
  }
} // namespace Thalweg
