// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/tools.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace Geometries
  {
    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    box_sides()
    {
      static const char *const names[] = {
        "left", "right", "bottom", "top", "front", "back"};
      std::map<std::string, dealii::types::boundary_id> sides;
      for (unsigned int side = 0; side < 2 * dim; ++side)
        sides[names[side]] = side;
      return sides;
    }


    template <int dim>
    void
    check_corners(const dealii::Point<dim> &lower,
                  const dealii::Point<dim> &upper,
                  const std::string        &what)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (!(lower[d] < upper[d]))
          {
            std::ostringstream message;
            message << what << " from (" << lower << ") to (" << upper
                    << ") has no extent in direction "
                    << "xyz"[d]
                    << ": each coordinate of the first corner must be less "
                       "than that of the second.";
            AssertThrow(false, dealii::ExcMessage(message.str()));
          }
    }


    double
    n_cells(const std::vector<unsigned int> &repetitions)
    {
      double n = 1.;
      for (const double repetition : repetitions)
        n *= repetition;
      return n;
    }


    template <int dim>
    void
    color_box(dealii::Triangulation<dim> &triangulation,
              const dealii::Point<dim>   &lower,
              const dealii::Point<dim>   &upper)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const dealii::Point<dim>   center = cell->face(f)->center();
              dealii::types::boundary_id id     = 2 * dim;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double tolerance = 1e-6 * cell->extent_in_direction(d);
                  if (std::abs(center[d] - lower[d]) < tolerance)
                    id = 2 * d;
                  else if (std::abs(center[d] - upper[d]) < tolerance)
                    id = 2 * d + 1;
                }
              cell->face(f)->set_boundary_id(id);
            }
    }


    std::vector<double>
    divide(const double        lower,
           const double        upper,
           std::vector<double> fixed,
           const double        size)
    {
      const double tolerance = 1e-6 * std::min(size, upper - lower);
      std::sort(fixed.begin(), fixed.end());
      std::vector<double> lines{lower};
      for (const double position : fixed)
        if (position > lines.back() + tolerance && position < upper - tolerance)
          lines.push_back(position);
      lines.push_back(upper);

      std::vector<double> steps;
      for (std::size_t i = 1; i < lines.size(); ++i)
        {
          const double length = lines[i] - lines[i - 1];
          const auto n = std::max<unsigned int>(1, std::lround(length / size));
          steps.insert(steps.end(), n, length / n);
        }
      return steps;
    }


    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    numbered_boundaries(const dealii::Triangulation<dim> &triangulation)
    {
      std::map<std::string, dealii::types::boundary_id> names;
      for (const auto id : triangulation.get_boundary_ids())
        names[std::to_string(id)] = id;
      return names;
    }


    void
    check_plane(const std::vector<dealii::Point<3>> &points,
                const std::string                   &what)
    {
      if (points.empty())
        return;
      dealii::Point<3> lower = points[0], upper = lower;
      for (const auto &point : points)
        for (unsigned int d = 0; d < 3; ++d)
          {
            lower[d] = std::min(lower[d], point[d]);
            upper[d] = std::max(upper[d], point[d]);
          }
      const double tolerance = 1e-6 * lower.distance(upper);
      if (upper[2] - lower[2] <= tolerance)
        return;
      std::ostringstream message;
      message << what << " does not lie in the plane of x and y: its z go from "
              << lower[2] << " to " << upper[2];
      for (const unsigned int d : {0, 1})
        if (upper[d] - lower[d] <= tolerance)
          message << ", and all of its "
                  << "xy"[d] << " are " << lower[d];
      message << ". In two dimensions the vertical axis is y, and z does not "
                 "exist: turn the mesh (in Gmsh, for one in x and z: 'Rotate "
                 "{{1, 0, 0}, {0, 0, 0}, -Pi/2} {Surface{:};}').";
      throw dealii::ExcMessage(message.str());
    }


    void
    refuse_cell(const std::string &what, const std::string &cell)
    {
      throw dealii::ExcMessage(
        what +
        " has inverted or distorted cells, whose volume is not positive "
        "everywhere. The first is cell " +
        cell +
        " (counted from 0 without lines and, in 3D, surfaces). Repair the "
        "mesh.");
    }

    void
    refuse_shapes(const std::string &what, const unsigned int dim)
    {
      throw dealii::ExcMessage(
        what + " has cells that are not " +
        (dim == 2 ? "quadrilaterals" : "hexahedra") +
        ", which are the only ones supported, whatever 'Partition/Model' is. "
        "Set 'Geometry/file/Divide cells = true', or let the mesh generator "
        "recombine them (in Gmsh: 'Mesh.RecombineAll = 1; "
        "Mesh.SubdivisionAlgorithm = " +
        (dim == 2 ? "1" : "2") + ";').");
    }

    template <int dim>
    void
    orient_cells(dealii::Triangulation<dim> &mesh)
    {
      if (!mesh.all_reference_cells_are_hyper_cube() || mesh.n_levels() != 1)
        return;
      auto [points, cells, subcells] =
        dealii::GridTools::get_coarse_mesh_description(mesh);
      auto near = points;
      for (auto &point : near)
        point -= dealii::Tensor<1, dim>(points[0]);
      const auto before = cells;
      dealii::GridTools::invert_cells_with_negative_measure(near, cells);
      bool is_changed = false;
      for (std::size_t c = 0; c < cells.size(); ++c)
        is_changed = is_changed || cells[c].vertices != before[c].vertices;
      if (!is_changed)
        return;
      dealii::GridTools::consistently_order_cells(cells);
      mesh.clear();
      mesh.create_triangulation(points, cells, subcells);
    }


    namespace
    {
      /// Refuses cells whose map is not invertible at every corner.
      template <int dim>
      void
      check_cells(const dealii::Triangulation<dim> &mesh,
                  const std::string                &what)
      {
        using Info = dealii::GeometryInfo<dim>;
        for (const auto &cell : mesh.active_cell_iterators())
          {
            dealii::Point<dim> vertices[Info::vertices_per_cell];
            for (const unsigned int v : cell->vertex_indices())
              vertices[v] = cell->vertex(v);
            dealii::Tensor<0, dim> determinants[Info::vertices_per_cell];
            Info::alternating_form_at_vertices(vertices, determinants);
            for (const double determinant : determinants)
              if (determinant <= 1e-9 * std::pow(cell->diameter(), dim))
                {
                  std::ostringstream text;
                  text.precision(10);
                  text << cell->index() << " with its centre at ("
                       << cell->center() << ")";
                  refuse_cell(what, text.str());
                }
          }
      }
    } // namespace

    template <int dim>
    void
    copy_coarse_mesh(const dealii::Triangulation<dim> &source,
                     dealii::Triangulation<dim>       &target,
                     const std::string                &what)
    {
      AssertThrow(source.n_active_cells() > 0,
                  dealii::ExcMessage(what + " has no cells in " +
                                     std::to_string(dim) +
                                     " dimensions. Does the parameter "
                                     "'Dimension' fit the mesh?"));
      if (!source.all_reference_cells_are_hyper_cube())
        refuse_shapes(what, dim);
      AssertThrow(source.n_levels() == 1,
                  dealii::ExcMessage(what +
                                     " is refined, but a coarse mesh must "
                                     "not be; refine in 'Refinement'."));
      check_cells(source, what);
      target.copy_triangulation(source);
    }


#define THALWEG_INSTANTIATE_TOOLS(dim)                                         \
  template std::map<std::string, dealii::types::boundary_id> box_sides<dim>(); \
  template void check_corners(const dealii::Point<dim> &,                      \
                              const dealii::Point<dim> &,                      \
                              const std::string &);                            \
  template void color_box(dealii::Triangulation<dim> &,                        \
                          const dealii::Point<dim> &,                          \
                          const dealii::Point<dim> &);                         \
  template std::map<std::string, dealii::types::boundary_id>                   \
                numbered_boundaries(const dealii::Triangulation<dim> &);       \
  template void copy_coarse_mesh(const dealii::Triangulation<dim> &,           \
                                 dealii::Triangulation<dim> &,                 \
                                 const std::string &);                         \
  template void orient_cells(dealii::Triangulation<dim> &);
    THALWEG_INSTANTIATE_TOOLS(2)
    THALWEG_INSTANTIATE_TOOLS(3)
#undef THALWEG_INSTANTIATE_TOOLS
  } // namespace Geometries
} // namespace Thalweg
