// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_shape_h
#define thalweg_dem_wall_shape_h

#include <thalweg/core/registry.h>
#include <thalweg/dem/wall_geometry.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// What a wall of its own looks like; registered.
  class WallShape
  {
  public:
    virtual ~WallShape() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /**
     * @brief Its facets where they are at the start.
     * @param dim 2: in the plane of x and y
     * @param where the section, for messages
     * @throws dealii::ExcMessage for what cannot be
     */
    virtual std::vector<Facet>
    facets(const int dim, const std::string &where) const = 0;

    /// A point of the axis that it turns about if the user says nothing, m.
    virtual Vec3
    center(const int) const
    {
      return {0., 0., 0.};
    }

    /// The direction of that axis, of any length.
    virtual Vec3
    axis(const int) const
    {
      return {0., 0., 1.};
    }
  };

  /// The vector that a user gave as @p dim numbers; nothing: @p otherwise.
  /// @param where the parameter, for messages
  /// @throws dealii::ExcMessage for another number of them
  Vec3
  vector_of(const std::vector<double> &numbers,
            const int                  dim,
            const Vec3                &otherwise,
            const std::string         &where);

  /// The same for what must be given, and made of length one where it is a
  /// direction.
  Vec3
  direction_of(const std::vector<double> &numbers,
               const int                  dim,
               const std::string         &where);

  /// A polygon that is felt from both sides; in two dimensions it stands
  /// upright
  /// on a line. @param corners 2 in two dimensions, else 3 or 4
  Facet
  thin_polygon(const std::vector<Vec3> &corners);
} // namespace Thalweg

#endif
