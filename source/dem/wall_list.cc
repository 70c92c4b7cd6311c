// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/wall_list.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Facets in more cells than this are looked at one by one.
    constexpr double most_cells_of_facet = 64.;

    Vec3
    lower_corner(const Facet &facet)
    {
      Vec3 lower = facet.corner[0];
      for (unsigned int c = 1; c < facet.n_corners; ++c)
        lower = {std::min(lower.x, facet.corner[c].x),
                 std::min(lower.y, facet.corner[c].y),
                 std::min(lower.z, facet.corner[c].z)};
      return lower;
    }



    Vec3
    upper_corner(const Facet &facet)
    {
      Vec3 upper = facet.corner[0];
      for (unsigned int c = 1; c < facet.n_corners; ++c)
        upper = {std::max(upper.x, facet.corner[c].x),
                 std::max(upper.y, facet.corner[c].y),
                 std::max(upper.z, facet.corner[c].z)};
      return upper;
    }



    std::int64_t
    cell_number(const double way, const double edge)
    {
      return static_cast<std::int64_t>(std::floor(way / edge));
    }
  } // namespace



  double
  distance_from(const Facet &facet, const Vec3 &x)
  {
    const Vec3   from_point = x - facet.corner[0];
    const double height     = dot(from_point, facet.normal);
    if (facet.kind == Facet::Kind::plane)
      return facet.is_solid ? std::max(height, 0.) : std::abs(height);
    if (facet.kind == Facet::Kind::cylinder)
      {
        const double side = facet.radius > 0. ? 1. : -1.;
        const double way  = side * (std::abs(facet.radius) -
                                   norm(from_point - height * facet.normal));
        return facet.is_solid ? std::max(way, 0.) : std::abs(way);
      }
    if (facet.kind == Facet::Kind::cone)
      {
        const ConeView view    = view_cone(facet, x);
        const double   out     = view.from_axis - view.radius;
        const double   up      = view.along_axis - view.height;
        const double   inwards = up * view.slope_out - out * view.slope_up;
        return facet.is_solid && view.is_inside &&
                   (facet.has_grains_outside ? inwards > 0. : inwards < 0.)
                 ? 0.
                 : std::sqrt(out * out + up * up);
      }
    bool         is_inside;
    const Vec3   nearest  = nearest_in_polygon(facet, x, is_inside);
    const double distance = norm(x - nearest);
    return facet.is_solid && is_inside && height < 0. ? 0. : distance;
  }



  FacetFinder::FacetFinder(const std::vector<Facet> &facets, const double reach)
    : facets(facets)
    , edge(std::max(reach, 1e-300))
  {
    std::vector<std::uint32_t> polygons;
    for (std::uint32_t f = 0; f < facets.size(); ++f)
      {
        const Vec3   size = upper_corner(facets[f]) - lower_corner(facets[f]);
        const double n_cells =
          (size.x / edge + 2.) * (size.y / edge + 2.) * (size.z / edge + 2.);
        if (facets[f].kind != Facet::Kind::polygon ||
            n_cells > most_cells_of_facet)
          large.push_back(f);
        else
          polygons.push_back(f);
      }
    if (polygons.empty())
      return;
    origin = facets[polygons[0]].corner[0];
    for (const std::uint32_t f : polygons)
      {
        const Vec3 low  = lower_corner(facets[f]) - origin;
        const Vec3 high = upper_corner(facets[f]) - origin;
        for (auto iz = cell_number(low.z, edge);
             iz <= cell_number(high.z, edge);
             ++iz)
          for (auto iy = cell_number(low.y, edge);
               iy <= cell_number(high.y, edge);
               ++iy)
            for (auto ix = cell_number(low.x, edge);
                 ix <= cell_number(high.x, edge);
                 ++ix)
              small[key(ix, iy, iz)].push_back(f);
      }
  }



  FacetFinder::Key
  FacetFinder::key(const std::int64_t ix,
                   const std::int64_t iy,
                   const std::int64_t iz) const
  {
    constexpr std::int64_t mask = (1 << 21) - 1;
    return Key(iz & mask) << 42 | Key(iy & mask) << 21 | Key(ix & mask);
  }



  void
  FacetFinder::append_near(const Vec3                 &x,
                           const double                distance,
                           std::vector<std::uint32_t> &list) const
  {
    const std::size_t first = list.size();
    for (const std::uint32_t f : large)
      if (distance_from(facets[f], x) <= distance)
        list.push_back(f);
    if (!small.empty())
      {
        const Vec3 way   = x - origin;
        const auto range = [&](const double at) {
          return std::make_pair(cell_number(at - distance, edge),
                                cell_number(at + distance, edge));
        };
        const auto [x0, x1] = range(way.x);
        const auto [y0, y1] = range(way.y);
        const auto [z0, z1] = range(way.z);
        for (auto iz = z0; iz <= z1; ++iz)
          for (auto iy = y0; iy <= y1; ++iy)
            for (auto ix = x0; ix <= x1; ++ix)
              if (const auto cell = small.find(key(ix, iy, iz));
                  cell != small.end())
                for (const std::uint32_t f : cell->second)
                  if (distance_from(facets[f], x) <= distance)
                    list.push_back(f);
      }
    std::sort(list.begin() + first, list.end());
    list.erase(std::unique(list.begin() + first, list.end()), list.end());
  }



  void
  WallList::make(const GrainArrays &grains,
                 const WallSet     &walls,
                 const double       skin)
  {
    grain.clear();
    facet.clear();
    begin.assign(1, 0);
    double largest = 0.;
    for (const GrainPlace &place : grains.place)
      largest = std::max(largest, place.r);
    const FacetFinder finder(walls.facets, largest + skin);
    for (std::uint32_t i = 0; i < grains.size(); ++i)
      if (grains.own[i])
        {
          finder.append_near(grains.place[i].x,
                             grains.place[i].r + skin,
                             facet);
          if (facet.size() == begin.back())
            continue;
          grain.push_back(i);
          begin.push_back(facet.size());
        }
    memory.assign(facet.size(), WallMemory());
  }



  void
  WallList::remember(const std::size_t row,
                     const WallMemory *old,
                     const std::size_t n)
  {
    const std::size_t room = begin[row + 1] - begin[row];
    std::copy(old, old + std::min(n, room), memory.begin() + begin[row]);
  }
} // namespace Thalweg
