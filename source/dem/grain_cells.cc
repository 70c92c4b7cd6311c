// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/grain_cells.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  void
  GrainCells::set_up(const GrainExtent &extent, const double skin_)
  {
    skin = skin_;
    // Room for halos and cells around, and no more cells than keys have bits.
    const double reach    = 2. * (2. * extent.largest + skin);
    origin                = extent.lower - Vec3{reach, reach, reach};
    const Vec3   size     = extent.upper - origin + Vec3{reach, reach, reach};
    const double longest  = std::max({size.x, size.y, size.z});
    const double smallest = longest / ((1u << bits) - 4);
    const auto   needed   = [&](const double r) {
      return std::max(1.000001 * (2. * r + skin), smallest);
    };
    const double top = needed(extent.largest);
    n                = 1;
    while (n < most_levels &&
           .5 * top / (1u << (n - 1)) >= needed(extent.smallest))
      ++n;
    for (unsigned int level = 0; level < n; ++level)
      {
        edge[level]         = top / (1u << (n - 1 - level));
        inverse_edge[level] = 1. / edge[level];
      }
  }



  GrainCells::Key
  GrainCells::key_on(const Vec3 &x, const unsigned int level) const
  {
    const Vec3 way     = x - origin;
    const auto integer = [&](const double coordinate) {
      return static_cast<Key>(coordinate * inverse_edge[level]);
    };
    return first_of_level(level) | integer(way.z) << (2 * bits) |
           integer(way.y) << bits | integer(way.x);
  }



  GrainCells::Key
  GrainCells::key(const Vec3 &x, const double r) const
  {
    unsigned int level = 0;
    while (level + 1 < n && edge[level] < 1.000001 * (2. * r + skin))
      ++level;
    return key_on(x, level);
  }



  std::pair<GrainCells::Key, GrainCells::Key>
  GrainCells::row(const Key cell, const int dy, const int dz)
  {
    const Key middle =
      cell + (std::int64_t(dz) * (std::int64_t(1) << (2 * bits)) +
              std::int64_t(dy) * (std::int64_t(1) << bits));
    return {middle - 1, middle + 1};
  }



  std::pair<GrainCells::Key, GrainCells::Key>
  GrainCells::row(const Vec3        &x,
                  const unsigned int level,
                  const int          dy,
                  const int          dz) const
  {
    return row(key_on(x, level), dy, dz);
  }



  namespace
  {
    /// A range of grains.
    struct Range
    {
      std::uint32_t begin, end;
    };

    /// The occupied cells and where their grains begin.
    struct Occupied
    {
      std::vector<GrainCells::Key> key;
      std::vector<std::uint32_t>   begin;

      explicit Occupied(const std::vector<GrainCells::Key> &keys)
      {
        for (std::size_t i = 0; i < keys.size(); ++i)
          if (i == 0 || keys[i] != keys[i - 1])
            {
              key.push_back(keys[i]);
              begin.push_back(i);
            }
        begin.push_back(keys.size());
      }

      /// The grains in cells with these keys.
      Range
      range(const std::pair<GrainCells::Key, GrainCells::Key> &keys) const
      {
        const auto first = std::lower_bound(key.begin(), key.end(), keys.first);
        const auto last  = std::upper_bound(first, key.end(), keys.second);
        return {begin[first - key.begin()], begin[last - key.begin()]};
      }
    };

    /// Rows of cells behind a cell, of the same size.
    constexpr int rows_behind[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};

    /// Finds the grains in rows_behind for one cell after the other: keys of
    /// rows grow with those of the cells, so that nothing is searched.
    class RowPointers
    {
    public:
      explicit RowPointers(const Occupied &cells)
        : cells(cells)
      {}

      Range
      advance(const unsigned int row, const GrainCells::Key cell)
      {
        const auto [low, high] =
          GrainCells::row(cell, rows_behind[row][0], rows_behind[row][1]);
        std::size_t &p = pointer[row];
        while (p < cells.key.size() && cells.key[p] < low)
          ++p;
        std::size_t q = p;
        while (q < cells.key.size() && cells.key[q] <= high)
          ++q;
        return {cells.begin[p], cells.begin[q]};
      }

    private:
      const Occupied            &cells;
      std::array<std::size_t, 4> pointer{};
    };



    /// Appends those of a range that are near a grain.
    class Finder
    {
    public:
      Finder(const std::vector<GrainPlace>   &place,
             const std::vector<std::uint8_t> &own,
             const double                     skin,
             std::vector<std::uint32_t>      &partner)
        : place(place)
        , own(own)
        , skin(skin)
        , partner(partner)
      {}

      void
      append(const std::uint32_t i, const Range &range)
      {
        if (range.begin >= range.end)
          return;
        const std::size_t needed = n + (range.end - range.begin);
        if (needed > partner.size())
          partner.resize(needed + needed / 2 + 1000);
        const GrainPlace   a       = place[i];
        const double       reach   = a.r + skin;
        const std::uint8_t is_ours = own[i];
        for (std::uint32_t j = range.begin; j < range.end; ++j)
          {
            const double least = reach + place[j].r;
            partner[n]         = j;
            n += unsigned(norm_square(a.x - place[j].x) < least * least) &
                 unsigned(is_ours | own[j]);
          }
      }

      std::uint32_t n = 0;

    private:
      const std::vector<GrainPlace>   &place;
      const std::vector<std::uint8_t> &own;
      const double                     skin;
      std::vector<std::uint32_t>      &partner;
    };
  } // namespace



  void
  find_pairs(const GrainCells                   &cells,
             const std::vector<GrainPlace>      &place,
             const std::vector<GrainCells::Key> &key,
             const std::vector<std::uint8_t>    &own,
             const double                        skin,
             PairList                           &list)
  {
    const Occupied occupied(key);
    RowPointers    pointers(occupied);
    list.begin.resize(place.size() + 1);
    Finder finder(place, own, skin, list.partner);
    for (std::size_t c = 0; c < occupied.key.size(); ++c)
      {
        const GrainCells::Key cell = occupied.key[c];
        const std::uint32_t   end  = occupied.begin[c + 1];
        const bool            has_next =
          c + 1 < occupied.key.size() && occupied.key[c + 1] == cell + 1;
        const std::uint32_t end_of_row = has_next ? occupied.begin[c + 2] : end;
        std::array<Range, 4> rows;
        for (unsigned int row = 0; row < 4; ++row)
          rows[row] = pointers.advance(row, cell);
        for (std::uint32_t i = occupied.begin[c]; i < end; ++i)
          {
            list.begin[i] = finder.n;
            finder.append(i, {i + 1, end_of_row});
            for (const Range &range : rows)
              finder.append(i, range);
            for (unsigned int level = GrainCells::level_of(cell) + 1;
                 level < cells.n_levels();
                 ++level)
              for (int dz = -1; dz <= 1; ++dz)
                for (int dy = -1; dy <= 1; ++dy)
                  finder.append(
                    i, occupied.range(cells.row(place[i].x, level, dy, dz)));
          }
      }
    list.begin[place.size()] = finder.n;
  }
} // namespace Thalweg
