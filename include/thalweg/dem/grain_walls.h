// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_walls_h
#define thalweg_dem_grain_walls_h

#include <thalweg/core/instances.h>
#include <thalweg/dem/grain_materials.h>
#include <thalweg/dem/wall_set.h>
#include <thalweg/dem/wall_shape.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// How a wall moves, as users write it: functions of t.
  class WallMotion
  {
  public:
    void
    declare_parameters(const Section &section);

    /// @param shape says about what it turns if the user does not
    /// @param where the wall's section, for messages
    /// @throws dealii::ExcMessage for what cannot be
    WallCourse
    course(const int          dim,
           const WallShape   &shape,
           const std::string &where) const;

  private:
    std::string         velocity, angular_velocity, slide;
    std::vector<double> center, axis;
    double              first_time = 0., last_time = 0.;
  };

  /**
   * @brief Walls beside the mesh's boundaries, by names of the user's:
   * "Walls/Names" and a section for each of them.
   */
  class GrainWalls
  {
  public:
    /// @throws dealii::ExcMessage for names that cannot be
    void
    declare_parameters(const Section &section);

    /// Appends what is wrong to a list.
    void
    check(const int                 dim,
          const GrainMaterials     &materials,
          std::vector<std::string> &faults) const;

    /// What is suspicious. @param low, high corners of the domain, m
    std::vector<std::string>
    warnings(const int dim, const Vec3 &low, const Vec3 &high) const;

    /**
     * @brief Adds the walls.
     * @param material of those that do not say
     * @param extent of the domain, m
     */
    void
    add_to(WallSet                  &walls,
           std::vector<std::string> &names,
           const int                 dim,
           const GrainMaterials     &materials,
           const unsigned int        material,
           const double              extent) const;

    std::vector<std::string>
    names() const
    {
      std::vector<std::string> all;
      for (const auto &shape : shapes)
        all.push_back(shape.name);
      return all;
    }

    /// Names and models, as the user gave them.
    const std::string &
    list() const
    {
      return names_;
    }

  private:
    /// What each has besides its shape.
    struct Settings
    {
      WallMotion  motion;
      std::string material;
    };

    std::string          names_;
    Instances<WallShape> shapes;
    std::deque<Settings> settings; ///< of each shape; they stay where they are
  };
} // namespace Thalweg

#endif
