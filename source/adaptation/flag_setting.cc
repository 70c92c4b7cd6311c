// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/flag_setting.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>

namespace Thalweg
{
  namespace
  {
    /// Agrees on the levels that the cells are going to have: raises them
    /// until they fit together.
    template <int dim>
    class LevelAgreement
    {
    public:
      using Triangulation = typename Mesh<dim>::Triangulation;
      using CellIterator  = typename Triangulation::active_cell_iterator;

      LevelAgreement(const Mesh<dim>                &mesh,
                     const std::vector<signed char> &change)
        : tria(mesh.triangulation())
        , graph(mesh.graph())
        , target(tria.n_active_cells(), 0)
        , vertex_group(tria.n_vertices())
      {
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          at(graph.iterator(c)) = graph.iterator(c)->level() + change[c];
        join_periodic_vertices();
      }

      /// The level of each local cell by active_cell_index().
      std::vector<int>
      agree()
      {
        bool goes_on = true;
        while (goes_on)
          {
            update_ghosts();
            bool raised = false;
            while (raise_beside_finer() | keep_incomplete_families())
              raised = true;
            goes_on =
              dealii::Utilities::MPI::logical_or(raised,
                                                 tria.get_communicator());
          }
        return target;
      }

    private:
      int &
      at(const CellIterator &cell)
      {
        return target[cell->active_cell_index()];
      }

      void
      join_periodic_vertices()
      {
        for (unsigned int v = 0; v < vertex_group.size(); ++v)
          vertex_group[v] = v;
        if (tria.get_periodic_face_map().empty())
          return;
        std::map<unsigned int, std::vector<unsigned int>> groups;
        std::map<unsigned int, unsigned int>              group_of;
        dealii::GridTools::collect_coinciding_vertices(tria, groups, group_of);
        for (const auto &[vertex, group] : group_of)
          vertex_group[vertex] = group;
      }

      void
      update_ghosts()
      {
        dealii::GridTools::exchange_cell_data_to_ghosts<int, Triangulation>(
          tria,
          [this](const CellIterator &cell) {
            return std::optional<int>(at(cell));
          },
          [this](const CellIterator &cell, const int level) {
            at(cell) = level;
          });
      }

      bool
      raise_beside_finer()
      {
        std::vector<int> highest(vertex_group.size(), 0);
        for (unsigned int c = 0; c < graph.n_cells(); ++c)
          for (const unsigned int v : graph.iterator(c)->vertex_indices())
            {
              int &level = highest[group(c, v)];
              level      = std::max(level, at(graph.iterator(c)));
            }
        bool raised = false;
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          for (const unsigned int v : graph.iterator(c)->vertex_indices())
            {
              const int least = highest[group(c, v)] - 1;
              if (at(graph.iterator(c)) < least)
                {
                  at(graph.iterator(c)) = least;
                  raised                = true;
                }
            }
        return raised;
      }

      bool
      keep_incomplete_families()
      {
        bool raised = false;
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          {
            const auto &cell = graph.iterator(c);
            if (at(cell) >= cell->level())
              continue;
            bool complete = cell->level() > 0;
            for (unsigned int k = 0; complete && k < (1u << dim); ++k)
              {
                const auto sibling = cell->parent()->child(k);
                complete =
                  sibling->is_active() && !sibling->is_artificial() &&
                  target[sibling->active_cell_index()] < sibling->level();
              }
            if (!complete)
              {
                at(cell) = cell->level();
                raised   = true;
              }
          }
        return raised;
      }

      unsigned int
      group(const unsigned int cell, const unsigned int vertex) const
      {
        return vertex_group[graph.iterator(cell)->vertex_index(vertex)];
      }

      const Triangulation      &tria;
      const CellGraph<dim>     &graph;
      std::vector<int>          target;
      std::vector<unsigned int> vertex_group;
    };
  } // namespace



  template <int dim>
  bool
  set_flags(Mesh<dim> &mesh, const std::vector<signed char> &change)
  {
    const auto levels = LevelAgreement<dim>(mesh, change).agree();
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
    for (unsigned int c = 0; c < mesh.graph().n_cells(); ++c)
      {
        const auto &cell  = mesh.graph().iterator(c);
        const int   level = levels[cell->active_cell_index()];
        if (level > cell->level())
          cell->set_refine_flag();
        else if (level < cell->level())
          // Siblings of ghost cells may be unknown here. Without their flags
          // deal.II would not believe that the family vanishes, and keep our
          // own cells beside it.
          for (unsigned int k = 0; k < (1u << dim); ++k)
            cell->parent()->child(k)->set_coarsen_flag();
      }
    mesh.triangulation().prepare_coarsening_and_refinement();

    bool any = false;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      any = any || (cell->is_locally_owned() &&
                    (cell->refine_flag_set() || cell->coarsen_flag_set()));
    return dealii::Utilities::MPI::logical_or(
      any, mesh.triangulation().get_communicator());
  }



  template bool
  set_flags<2>(Mesh<2> &, const std::vector<signed char> &);
  template bool
  set_flags<3>(Mesh<3> &, const std::vector<signed char> &);
} // namespace Thalweg
