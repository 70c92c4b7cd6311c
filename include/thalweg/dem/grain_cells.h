// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_cells_h
#define thalweg_dem_grain_cells_h

#include <thalweg/dem/grain_arrays.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// What all grains of all ranks have in common when lists are made.
  struct GrainExtent
  {
    Vec3   lower, upper;      ///< of their places, m
    double smallest, largest; ///< radius, m
  };

  /**
   * @brief Linked cells: grids of cubes, one for each class of sizes, whose edges
   * halve from one to the next, so that grains of very different sizes find
   * their neighbours in few cells (hierarchical grid).
   *
   * They cover what grains there are and are nothing that lasts.
   */
  class GrainCells
  {
  public:
    using Key                                 = std::uint64_t;
    static constexpr unsigned int most_levels = 16;

    /// @param skin by which two may be apart and are neighbours, m
    void
    set_up(const GrainExtent &extent, const double skin);

    /// Of the cell of a grain: keys grow with the size of the grains, then with
    /// z, y and x.
    Key
    key(const Vec3 &x, const double r) const;

    /// The keys of the cells from the one before to the one behind that of a
    /// place, in the row that is dy and dz cells away.
    std::pair<Key, Key>
    row(const Vec3        &x,
        const unsigned int level,
        const int          dy,
        const int          dz) const;

    /// The same around a cell.
    static std::pair<Key, Key>
    row(const Key cell, const int dy, const int dz);

    unsigned int
    n_levels() const
    {
      return n;
    }

    static unsigned int
    level_of(const Key key)
    {
      return key >> (3 * bits);
    }

    static Key
    first_of_level(const unsigned int level)
    {
      return Key(level) << (3 * bits);
    }

  private:
    static constexpr unsigned int bits = 19;

    Key
    key_on(const Vec3 &x, const unsigned int level) const;

    unsigned int                    n = 1;
    Vec3                            origin{0., 0., 0.};
    double                          skin = 0.;
    std::array<double, most_levels> edge{}, inverse_edge{};
  };

  /// Pairs of grains, of each grain those with others behind it, in their
  /// order.
  struct PairList
  {
    std::vector<std::uint32_t> begin, partner;
  };

  /**
   * @brief All pairs of grains that are less than @p skin apart and of which one
   * is this rank's.
   * @param place in the order of @p key
   * @param key of the cell of each grain
   */
  void
  find_pairs(const GrainCells                   &cells,
             const std::vector<GrainPlace>      &place,
             const std::vector<GrainCells::Key> &key,
             const std::vector<std::uint8_t>    &own,
             const double                        skin,
             PairList                           &list);
} // namespace Thalweg

#endif
