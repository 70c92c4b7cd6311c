// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/boundary_facets.h>
#include <thalweg/dem/points.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mpi.h>
#include <tuple>

namespace Thalweg
{
  namespace
  {
    /// A side of a cell.
    struct Side
    {
      unsigned int boundary;
      unsigned int n_corners; ///< 2 or 4, in deal.II's order
      Vec3         corner[4];
      Vec3         inside; ///< the center of the cell
    };



    /// A side along the axes: a range of two coordinates at a third.
    struct Rectangle
    {
      unsigned int          boundary;
      int                   axis;
      double                level;
      bool                  upwards; ///< where the cells are
      std::array<double, 2> low, high;

      /// All but the range of one of the coordinates, and where that begins.
      auto
      key(const unsigned int along) const
      {
        return std::make_tuple(boundary,
                               axis,
                               upwards,
                               level,
                               low[1 - along],
                               high[1 - along],
                               low[along]);
      }
    };



    double
    component(const Vec3 &x, const int axis)
    {
      return axis == 0 ? x.x : axis == 1 ? x.y : x.z;
    }



    void
    set_component(Vec3 &x, const int axis, const double value)
    {
      (axis == 0 ? x.x : axis == 1 ? x.y : x.z) = value;
    }



    /// Whether a side is along the axes but for round-off, and as what.
    bool
    as_rectangle(const Side &side, const int dim, Rectangle &rectangle)
    {
      const double negligible =
        1e-10 * norm(side.corner[side.n_corners - 1] - side.corner[0]);
      const auto is_at = [&](const double a, const double b) {
        return std::abs(a - b) <= negligible;
      };
      for (int axis = 0; axis < dim; ++axis)
        {
          const double level   = component(side.corner[0], axis);
          bool         is_flat = true;
          for (unsigned int v = 1; v < side.n_corners; ++v)
            is_flat = is_flat && is_at(component(side.corner[v], axis), level);
          if (!is_flat)
            continue;
          rectangle = {side.boundary,
                       axis,
                       level,
                       component(side.inside, axis) > level,
                       {},
                       {}};
          for (unsigned int k = 0; k < 2; ++k)
            {
              const int d   = (axis + 1 + k) % 3;
              double    low = component(side.corner[0], d), high = low;
              for (unsigned int v = 1; v < side.n_corners; ++v)
                {
                  low  = std::min(low, component(side.corner[v], d));
                  high = std::max(high, component(side.corner[v], d));
                }
              // Corners of a rectangle are at its ends only.
              for (unsigned int v = 0; v < side.n_corners; ++v)
                if (!is_at(component(side.corner[v], d), low) &&
                    !is_at(component(side.corner[v], d), high))
                  return false;
              rectangle.low[k]  = low;
              rectangle.high[k] = high;
            }
          return true;
        }
      return false;
    }



    /// Face @p f of a cell with these corners.
    template <int dim>
    Side
    side_of(const std::array<dealii::Point<dim>, (1 << dim)> &vertices,
            const unsigned int                                f)
    {
      Side side{0, 1 << (dim - 1), {}, {0., 0., 0.}};
      for (unsigned int v = 0; v < side.n_corners; ++v)
        side.corner[v] = as_vec3<dim>(
          vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)]);
      for (const auto &vertex : vertices)
        side.inside += (1. / vertices.size()) * as_vec3<dim>(vertex);
      return side;
    }



    /// The corners of the coarse cell that a cell is a part of.
    template <int dim>
    std::array<dealii::Point<dim>, (1 << dim)>
    coarse_vertices(typename dealii::Triangulation<dim>::cell_iterator cell)
    {
      while (cell->level() > 0)
        cell = cell->parent();
      std::array<dealii::Point<dim>, (1 << dim)> vertices;
      for (unsigned int v = 0; v < vertices.size(); ++v)
        vertices[v] = cell->vertex(v);
      return vertices;
    }



    /// Whether both are along the axes and the first one contains the other.
    bool
    contains(const Side &coarse, const Side &fine, const int dim)
    {
      Rectangle a, b;
      if (!as_rectangle(coarse, dim, a) || !as_rectangle(fine, dim, b))
        return false;
      const double negligible =
        1e-10 * norm(coarse.corner[coarse.n_corners - 1] - coarse.corner[0]);
      bool result = a.axis == b.axis &&
                    std::abs(a.level - b.level) <= negligible &&
                    a.upwards == b.upwards;
      for (unsigned int k = 0; k < 2; ++k)
        result = result && a.low[k] - negligible <= b.low[k] &&
                 a.high[k] + negligible >= b.high[k];
      return result;
    }



    template <int dim>
    std::vector<Side>
    own_sides(const CellGraph<dim> &graph)
    {
      std::vector<Side> sides;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (unsigned int f = 0; f < graph.n_faces; ++f)
          {
            const auto &cell = graph.cell(c);
            if (cell.faces[f].behind != CellGraph<dim>::Behind::boundary)
              continue;
            Side       side = side_of<dim>(cell.vertices, f);
            const Side coarse =
              side_of<dim>(coarse_vertices<dim>(graph.iterator(c)), f);
            if (contains(coarse, side, dim))
              side = coarse;
            side.boundary = cell.faces[f].boundary_id;
            sides.push_back(side);
          }
      return sides;
    }



    std::vector<Side>
    gather(const MPI_Comm communicator, const std::vector<Side> &own)
    {
      int n_ranks;
      MPI_Comm_size(communicator, &n_ranks);
      const int        n_bytes = own.size() * sizeof(Side);
      std::vector<int> bytes(n_ranks), begin(n_ranks + 1, 0);
      MPI_Allgather(
        &n_bytes, 1, MPI_INT, bytes.data(), 1, MPI_INT, communicator);
      for (int r = 0; r < n_ranks; ++r)
        begin[r + 1] = begin[r] + bytes[r];
      std::vector<Side> all(begin[n_ranks] / sizeof(Side));
      MPI_Allgatherv(own.data(),
                     n_bytes,
                     MPI_BYTE,
                     all.data(),
                     bytes.data(),
                     begin.data(),
                     MPI_BYTE,
                     communicator);
      const auto key = [](const Side &side) {
        return std::make_tuple(side.boundary,
                               side.corner[0].z + side.corner[1].z,
                               side.corner[0].y + side.corner[1].y,
                               side.corner[0].x + side.corner[1].x,
                               side.inside.z,
                               side.inside.y,
                               side.inside.x);
      };
      std::sort(all.begin(), all.end(), [&](const Side &a, const Side &b) {
        return key(a) < key(b);
      });
      // Cells on the same side of a coarse one.
      all.erase(std::unique(all.begin(),
                            all.end(),
                            [&](const Side &a, const Side &b) {
                              return key(a) == key(b);
                            }),
                all.end());
      return all;
    }



    /// Joins neighbours as long as there are some.
    void
    join(std::vector<Rectangle> &rectangles)
    {
      for (std::size_t before = 0; before != rectangles.size();)
        {
          before = rectangles.size();
          for (unsigned int along = 0; along < 2; ++along)
            {
              std::sort(rectangles.begin(),
                        rectangles.end(),
                        [&](const Rectangle &a, const Rectangle &b) {
                          return a.key(along) < b.key(along);
                        });
              std::vector<Rectangle> joined;
              for (const Rectangle &next : rectangles)
                {
                  if (!joined.empty())
                    {
                      Rectangle &last       = joined.back();
                      auto       expected   = last.key(along);
                      std::get<6>(expected) = last.high[along];
                      if (expected == next.key(along) &&
                          next.high[along] > next.low[along])
                        {
                          last.high[along] = next.high[along];
                          continue;
                        }
                    }
                  joined.push_back(next);
                }
              rectangles.swap(joined);
            }
        }
    }



    /// In two dimensions sides reach as far as this to both sides of the plane.
    std::vector<Vec3>
    upright(const Vec3 &a, const Vec3 &b)
    {
      const Vec3 up{0., 0., norm(b - a)};
      return {a - up, b - up, b + up, a + up};
    }



    BoundaryFacet
    facet_of(const Rectangle &rectangle, const int dim)
    {
      const int  u = (rectangle.axis + 1) % 3, v = (rectangle.axis + 2) % 3;
      const auto at = [&](const double on_u, const double on_v) {
        Vec3 x{0., 0., 0.};
        set_component(x, rectangle.axis, rectangle.level);
        set_component(x, u, on_u);
        set_component(x, v, on_v);
        return x;
      };
      Vec3 inside = at(rectangle.low[0], rectangle.low[1]);
      set_component(inside,
                    rectangle.axis,
                    rectangle.level + (rectangle.upwards ? 1. : -1.));
      std::vector<Vec3> corners{at(rectangle.low[0], rectangle.low[1]),
                                at(rectangle.high[0], rectangle.low[1]),
                                at(rectangle.high[0], rectangle.high[1]),
                                at(rectangle.low[0], rectangle.high[1])};
      if (dim == 2)
        corners = upright(corners[0], corners[2]);
      Facet facet = make_polygon(corners, inside);
      // Exactly along the axis.
      facet.normal = {0., 0., 0.};
      set_component(facet.normal, rectangle.axis, rectangle.upwards ? 1. : -1.);
      return {facet, rectangle.boundary};
    }



    void
    append(const Side &side, std::vector<BoundaryFacet> &facets)
    {
      const Vec3 *c = side.corner;
      if (side.n_corners == 2)
        {
          facets.push_back(
            {make_polygon(upright(c[0], c[1]), side.inside), side.boundary});
          return;
        }
      facets.push_back(
        {make_polygon({c[0], c[1], c[3]}, side.inside), side.boundary});
      facets.push_back(
        {make_polygon({c[0], c[3], c[2]}, side.inside), side.boundary});
    }
  } // namespace



  Facet
  make_polygon(const std::vector<Vec3> &corners, const Vec3 &inside)
  {
    Facet facet{};
    facet.kind      = Facet::Kind::polygon;
    facet.is_solid  = true;
    facet.n_corners = corners.size();
    std::copy(corners.begin(), corners.end(), facet.corner);
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    facet.normal      = (1. / norm(normal)) * normal;
    if (dot(facet.normal, inside - corners[0]) < 0.)
      {
        std::reverse(facet.corner, facet.corner + facet.n_corners);
        facet.normal = -facet.normal;
      }
    return facet;
  }



  template <int dim>
  std::vector<BoundaryFacet>
  boundary_facets(const Mesh<dim> &mesh)
  {
    std::vector<Rectangle>     rectangles;
    std::vector<BoundaryFacet> facets, others;
    for (const Side &side : gather(mesh.triangulation().get_communicator(),
                                   own_sides(mesh.graph())))
      {
        Rectangle rectangle;
        if (as_rectangle(side, dim, rectangle))
          rectangles.push_back(rectangle);
        else
          append(side, others);
      }
    join(rectangles);
    for (const Rectangle &rectangle : rectangles)
      facets.push_back(facet_of(rectangle, dim));
    facets.insert(facets.end(), others.begin(), others.end());
    return facets;
  }



  template std::vector<BoundaryFacet>
  boundary_facets(const Mesh<2> &);
  template std::vector<BoundaryFacet>
  boundary_facets(const Mesh<3> &);
} // namespace Thalweg
