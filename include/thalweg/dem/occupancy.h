// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_occupancy_h
#define thalweg_dem_occupancy_h

#include <thalweg/dem/grain_arrays.h>

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Thalweg
{
  /// Circles or spheres in a grid, to see which overlap.
  class Occupancy
  {
  public:
    explicit Occupancy(const double diameter)
      : edge(diameter)
    {}

    void
    add(const GrainPlace &grain)
    {
      cells[key(grain.x, 0, 0, 0)].push_back(grain);
    }

    bool
    is_free(const GrainPlace &grain) const
    {
      for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (const auto cell = cells.find(key(grain.x, dx, dy, dz));
                cell != cells.end())
              for (const GrainPlace &other : cell->second)
                {
                  const double contact = grain.r + other.r;
                  if (norm_square(grain.x - other.x) < contact * contact)
                    return false;
                }
      return true;
    }

  private:
    std::uint64_t
    key(const Vec3 &x, const int dx, const int dy, const int dz) const
    {
      const auto number = [&](const double at, const int d) {
        constexpr std::int64_t mask = (1 << 21) - 1;
        return std::uint64_t(
          (static_cast<std::int64_t>(std::floor(at / edge)) + d) & mask);
      };
      return number(x.x, dx) | number(x.y, dy) << 21 | number(x.z, dz) << 42;
    }

    const double                                               edge;
    std::unordered_map<std::uint64_t, std::vector<GrainPlace>> cells;
  };
} // namespace Thalweg

#endif
