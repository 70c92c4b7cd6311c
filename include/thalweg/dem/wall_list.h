// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_list_h
#define thalweg_dem_wall_list_h

#include <thalweg/dem/wall_loop.h>
#include <thalweg/dem/wall_set.h>

#include <unordered_map>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Which facets are near a place: those that are small are found in a
   * grid, the others looked at one by one.
   */
  class FacetFinder
  {
  public:
    /// @param reach farthest distance that is asked for, m
    FacetFinder(const std::vector<Facet> &facets, const double reach);

    /// Appends the facets that are no farther than @p distance, in their order.
    void
    append_near(const Vec3                 &x,
                const double                distance,
                std::vector<std::uint32_t> &list) const;

  private:
    using Key = std::uint64_t;

    Key
    key(const std::int64_t ix,
        const std::int64_t iy,
        const std::int64_t iz) const;

    const std::vector<Facet>                           &facets;
    double                                              edge;
    Vec3                                                origin{0., 0., 0.};
    std::vector<std::uint32_t>                          large;
    std::unordered_map<Key, std::vector<std::uint32_t>> small;
  };

  /// The distance of a place from a facet, m.
  double
  distance_from(const Facet &facet, const Vec3 &x);

  /// The grains near walls, with the facets that are near them and what they
  /// remember of these.
  struct WallList
  {
    std::vector<std::uint32_t> grain, begin{0}, facet;
    std::vector<WallMemory>    memory;

    /// @param skin by which facets may be away, m
    void
    make(const GrainArrays &grains, const WallSet &walls, const double skin);

    /// Puts what grain number @p row of the list remembers in place.
    void
    remember(const std::size_t row, const WallMemory *old, const std::size_t n);

    /// How many contacts it remembers.
    std::size_t
    n_remembered(const std::size_t row) const
    {
      std::size_t n = 0;
      while (n < begin[row + 1] - begin[row] &&
             memory[begin[row] + n].wall != no_wall)
        ++n;
      return n;
    }
  };
} // namespace Thalweg

#endif
