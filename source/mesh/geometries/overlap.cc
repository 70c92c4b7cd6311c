// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/overlap.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      template <int dim>
      using Cell = typename dealii::Triangulation<dim>::cell_iterator;


      /// Whether @p x is in @p cell, and not merely at its side.
      template <int dim>
      bool
      is_inside(const Cell<dim> &cell, const dealii::Point<dim> &x)
      {
        constexpr double margin = 1e-3;
        try
          {
            static const dealii::MappingQ1<dim> mapping;
            const auto unit = mapping.transform_real_to_unit_cell(cell, x);
            for (unsigned int d = 0; d < dim; ++d)
              if (!(unit[d] > margin && unit[d] < 1. - margin))
                return false;
            return true;
          }
        catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
          {
            return false;
          }
      }


      template <int dim>
      bool
      has_vertex(const Cell<dim> &cell, const unsigned int vertex)
      {
        const auto all = cell->vertex_indices();
        return std::any_of(all.begin(), all.end(), [&](const unsigned int v) {
          return cell->vertex_index(v) == vertex;
        });
      }


      /// Finds cells by places.
      template <int dim>
      class Finder
      {
      public:
        Finder(const dealii::Triangulation<dim> &mesh, const std::string &what)
          : what(what)
        {
          std::vector<Entry> entries;
          for (const auto &cell : mesh.cell_iterators_on_level(0))
            {
              entries.emplace_back(cell->bounding_box(), cells.size());
              cells.push_back(cell);
            }
          tree = dealii::pack_rtree(entries);
        }


        /// Refuses the mesh if @p x is in a cell for which @p may_be_in is
        /// false.
        template <typename Condition>
        void
        check(const dealii::Point<dim> &x,
              const unsigned int        index,
              const Condition          &may_be_in) const
        {
          std::vector<Entry> near;
          tree.query(boost::geometry::index::intersects(x),
                     std::back_inserter(near));
          for (const auto &[box, other] : near)
            if (!may_be_in(other) && is_inside<dim>(cells[other], x))
              {
                std::ostringstream text;
                text.precision(10);
                text << what << " has cells that overlap: cell " << index
                     << " reaches into cell " << other << " at (" << x
                     << ") (counted from 0 without lines and, in 3D, "
                        "surfaces). Repair the mesh.";
                throw dealii::ExcMessage(text.str());
              }
        }


        void
        check_all() const
        {
          for (unsigned int c = 0; c < cells.size(); ++c)
            {
              check(cells[c]->center(), c, [c](const unsigned int other) {
                return other == c;
              });
              for (const unsigned int v : cells[c]->vertex_indices())
                check(cells[c]->vertex(v), c, [&](const unsigned int other) {
                  return has_vertex<dim>(cells[other],
                                         cells[c]->vertex_index(v));
                });
            }
        }

      private:
        using Entry = std::pair<dealii::BoundingBox<dim>, unsigned int>;

        const std::string                                 &what;
        std::vector<Cell<dim>>                             cells;
        decltype(dealii::pack_rtree(std::vector<Entry>())) tree;
      };
    } // namespace



    template <int dim>
    void
    check_overlap(const dealii::Triangulation<dim> &mesh,
                  const std::string                &what)
    {
      Finder<dim>(mesh, what).check_all();
    }



    template void
    check_overlap(const dealii::Triangulation<2> &, const std::string &);
    template void
    check_overlap(const dealii::Triangulation<3> &, const std::string &);
  } // namespace Geometries
} // namespace Thalweg
