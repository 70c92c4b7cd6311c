// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/division.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      template <int dim>
      class Division
      {
      public:
        using CellIterator =
          typename dealii::Triangulation<dim>::active_cell_iterator;

        Division(const dealii::Triangulation<dim> &source,
                 const std::string                &what)
          : what(what)
          , points(source.get_vertices())
        {
          for (const auto &cell : source.active_cell_iterators())
            {
              for (const unsigned int v : cell->vertex_indices())
                add_corner(cell, cell->vertex_index(v));
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary())
                  boundary_ids[middle_of(cell->face(f))] =
                    cell->face(f)->boundary_id();
            }
        }


        void
        create(dealii::Triangulation<dim> &target)
        {
          dealii::GridTools::consistently_order_cells(cells);
          target.create_triangulation(points, cells, {});
          // Of the vertices of a part of a face one is the face's middle.
          for (const auto &face : target.active_face_iterators())
            if (face->at_boundary())
              for (const unsigned int v : face->vertex_indices())
                if (const auto id = boundary_ids.find(face->vertex_index(v));
                    id != boundary_ids.end())
                  face->set_boundary_id(id->second);
        }

      private:
        /// The vertices of a line, face or cell.
        template <typename Object>
        static std::vector<unsigned int>
        corners_of(const Object &object)
        {
          std::vector<unsigned int> corners;
          for (const unsigned int v : object->vertex_indices())
            corners.push_back(object->vertex_index(v));
          std::sort(corners.begin(), corners.end());
          return corners;
        }


        /// The number of the point in the middle of a line, face or cell.
        template <typename Object>
        unsigned int
        middle_of(const Object &object)
        {
          const auto [entry, is_new] =
            middles.try_emplace(corners_of(object), points.size());
          if (is_new)
            {
              dealii::Point<dim> sum;
              for (const unsigned int corner : entry->first)
                sum += points[corner];
              points.push_back(sum / double(entry->first.size()));
            }
          return entry->second;
        }


        /// The middle of the face to which all of @p corners belong.
        unsigned int
        middle_of_face(const CellIterator              &cell,
                       const std::vector<unsigned int> &corners)
        {
          for (const unsigned int f : cell->face_indices())
            {
              const auto all = corners_of(cell->face(f));
              if (std::all_of(corners.begin(),
                              corners.end(),
                              [&](const unsigned int corner) {
                                return std::binary_search(all.begin(),
                                                          all.end(),
                                                          corner);
                              }))
                return middle_of(cell->face(f));
            }
          Assert(false, dealii::ExcInternalError());
          return 0;
        }


        /// Adds the part of @p cell at @p corner.
        void
        add_corner(const CellIterator &cell, const unsigned int corner)
        {
          // The other ends of the edges that begin here, and their middles.
          std::vector<std::pair<unsigned int, unsigned int>> edges;
          for (const unsigned int l : cell->line_indices())
            for (const unsigned int v : {0, 1})
              if (cell->line(l)->vertex_index(v) == corner)
                edges.emplace_back(cell->line(l)->vertex_index(1 - v),
                                   middle_of(cell->line(l)));
          AssertThrow(edges.size() == dim,
                      dealii::ExcMessage(
                        what +
                        " has pyramids, which cannot be divided into "
                        "hexahedra. Let the mesh generator make others."));
          dealii::Tensor<2, dim> directions;
          for (unsigned int d = 0; d < dim; ++d)
            directions[d] = points[edges[d].second] - points[corner];
          if (determinant(directions) < 0)
            std::swap(edges[0], edges[1]);

          dealii::CellData<dim> part;
          part.material_id              = cell->material_id();
          part.vertices[0]              = corner;
          part.vertices[(1 << dim) - 1] = middle_of(cell);
          for (unsigned int d = 0; d < dim; ++d)
            {
              part.vertices[1 << d] = edges[d].second;
              if constexpr (dim == 3)
                for (unsigned int e = 0; e < d; ++e)
                  part.vertices[(1 << d) + (1 << e)] =
                    middle_of_face(cell,
                                   {corner, edges[d].first, edges[e].first});
            }
          cells.push_back(part);
        }

        const std::string                                  what;
        std::vector<dealii::Point<dim>>                    points;
        std::vector<dealii::CellData<dim>>                 cells;
        std::map<std::vector<unsigned int>, unsigned int>  middles;
        std::map<unsigned int, dealii::types::boundary_id> boundary_ids;
      };
    } // namespace



    template <int dim>
    void
    divide_into_cubes(const dealii::Triangulation<dim> &source,
                      dealii::Triangulation<dim>       &target,
                      const std::string                &what)
    {
      Division<dim>(source, what).create(target);
    }

    template void
    divide_into_cubes(const dealii::Triangulation<2> &,
                      dealii::Triangulation<2> &,
                      const std::string &);
    template void
    divide_into_cubes(const dealii::Triangulation<3> &,
                      dealii::Triangulation<3> &,
                      const std::string &);
  } // namespace Geometries
} // namespace Thalweg
