// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_record_h
#define thalweg_dem_grain_record_h

#include <thalweg/dem/contact_list.h>
#include <thalweg/dem/wall_loop.h>

namespace Thalweg
{
  /// All that a grain knows of itself, to be kept, sent or saved.
  struct GrainRecord
  {
    std::uint64_t id;
    Vec3          x, v, w;
    /// Force and torque; in the midst of a step, when these are used up,
    /// velocity and spin as contacts feel them.
    Vec3          force, torque;
    Vec3          reference; ///< place at the last rebuild, m
    double        r;         ///< m
    std::uint32_t material;
    std::uint32_t cell; ///< of the mesh's graph on its rank
  };

  /// Grains with all that they remember.
  struct GrainSet
  {
    std::vector<GrainRecord>   grains;
    ContactTable               contacts;      ///< a row a grain
    std::vector<std::uint32_t> wall_begin{0}; ///< a row a grain
    std::vector<WallMemory>    walls;

    /// Appends a grain with its contacts out of bare arrays.
    void
    append(const GrainRecord   &grain,
           const ContactRecord *contact,
           const std::size_t    n_contacts,
           const WallMemory    *wall,
           const std::size_t    n_walls)
    {
      grains.push_back(grain);
      contacts.contacts.insert(contacts.contacts.end(),
                               contact,
                               contact + n_contacts);
      contacts.begin.push_back(contacts.contacts.size());
      walls.insert(walls.end(), wall, wall + n_walls);
      wall_begin.push_back(walls.size());
    }

    /// Appends grain @p g of another set.
    void
    append(const GrainSet &other, const std::size_t g)
    {
      append(other.grains[g],
             other.contacts.contacts.data() + other.contacts.begin[g],
             other.contacts.begin[g + 1] - other.contacts.begin[g],
             other.walls.data() + other.wall_begin[g],
             other.wall_begin[g + 1] - other.wall_begin[g]);
    }
  };
} // namespace Thalweg

#endif
