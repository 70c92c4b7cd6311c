// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_arrays_h
#define thalweg_dem_grain_arrays_h

#include <thalweg/dem/vec3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Thalweg
{
  /// Where a grain is and how large: what decides whether two touch.
  struct GrainPlace
  {
    Vec3   x; ///< m
    double r; ///< radius, m
  };

  /// How a grain moves, as contacts feel it.
  struct GrainMotion
  {
    Vec3   v;            ///< m/s
    double inverse_mass; ///< 1/kg
    Vec3   w;            ///< spin, rad/s
    double padding;
  };

  /// What acts on a grain.
  struct GrainLoad
  {
    Vec3   force; ///< N
    double padding_1;
    Vec3   torque; ///< N m
    double padding_2;
  };

  /// What is integrated: velocity and spin half a step after the forces.
  struct GrainMomentum
  {
    Vec3   v; ///< m/s
    double inverse_mass;
    Vec3   w;               ///< rad/s
    double inverse_inertia; ///< 1/(kg m^2)
  };

  /**
   * @brief All grains that a rank knows, its own and those of the halo, in the
   * order of the linked cells: by the key of their cell and their number. It
   * does not depend on who owns what, so that sums over neighbours do not.
   */
  struct GrainArrays
  {
    std::vector<GrainPlace>    place;
    std::vector<GrainMotion>   motion;
    std::vector<GrainLoad>     load;
    std::vector<GrainMomentum> momentum;  ///< of own grains
    std::vector<Vec3>          reference; ///< place at the last rebuild, m
    std::vector<std::uint64_t> id;
    std::vector<std::uint8_t>  material;
    std::vector<std::uint8_t>  own; ///< whether this rank moves it

    std::size_t
    size() const
    {
      return place.size();
    }

    void
    resize(const std::size_t n)
    {
      place.resize(n);
      motion.resize(n);
      load.resize(n);
      momentum.resize(n);
      reference.resize(n);
      id.resize(n);
      material.resize(n);
      own.resize(n);
    }
  };
} // namespace Thalweg

#endif
