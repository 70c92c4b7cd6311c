// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_set_h
#define thalweg_dem_wall_set_h

#include <thalweg/dem/wall_geometry.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Thalweg
{
  /// How far a wall has come since the start.
  struct WallPose
  {
    Vec3   shift{0., 0., 0.}; ///< of its center, m
    double angle = 0.;        ///< about its axis, rad
  };

  /// How a wall moves: functions of time in s; what is not there is zero.
  struct WallCourse
  {
    std::function<Vec3(const double)>   velocity;         ///< m/s
    std::function<double(const double)> angular_velocity; ///< rad/s
    std::function<Vec3(const double)>   slide;            ///< see Wall, m/s
    Vec3   center{0., 0., 0.}; ///< a point of the axis at the start, m
    Vec3   axis{0., 0., 1.};
    double first_time = -std::numeric_limits<double>::infinity();
    double last_time  = std::numeric_limits<double>::infinity();
  };

  /// A wall that may move, with its facets where they were at the start.
  struct MovingWall
  {
    std::uint32_t      wall, first_facet;
    std::vector<Facet> at_start;
    WallCourse         course;
    /// Of what rotation moves, the distance from the axis, m; nothing: it only
    /// slides in itself.
    double   reach = 0.;
    WallPose now, reference{}; ///< reference: at the last rebuild of lists

    bool
    changes_place() const
    {
      return course.velocity || reach > 0.;
    }
  };

  /// All walls with their facets, the same on all ranks.
  struct WallSet
  {
    std::vector<Facet>      facets;
    std::vector<Wall>       walls;
    std::vector<WallForce>  forces; ///< on each wall, by this rank's grains
    std::vector<MovingWall> moving;
    double                  time = 0.; ///< s

    /**
     * @brief Adds a wall that may move.
     * @param extent of the domain, m: endless facets reach so far
     */
    void
    add_moving(const std::vector<Facet> &of_wall,
               const WallCourse         &course,
               const unsigned int        material,
               const double              extent);

    /// Moves walls to the end of a step, but not their facets.
    /// @return how far points of them came at the most, m
    double
    move(const double start, const double dt);

    /// Sets velocities, and which walls are there. @param now s
    void
    set_velocities(const double now);

    /// Puts all facets of moving walls in place: MovingWall::now or reference.
    void
    place_facets(const WallPose MovingWall::*pose);

    /// The same for some of the facets, where they are now.
    void
    place_facets(const std::vector<std::uint32_t> &some);

    /// Which of some facets change their place.
    std::vector<std::uint32_t>
    moving_among(std::vector<std::uint32_t> some) const;

    /// How far walls are from their references, m, at the most.
    double
    farthest() const;

    /// The greatest speed of points that change their place, m/s.
    double
    fastest(const double now) const;

  private:
    std::vector<std::int32_t> moving_of_wall; ///< or -1
  };
} // namespace Thalweg

#endif
