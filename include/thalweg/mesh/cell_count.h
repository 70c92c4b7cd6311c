// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_cell_count_h
#define thalweg_mesh_cell_count_h

#include <deal.II/base/function.h>
#include <deal.II/grid/tria.h>

namespace Thalweg
{
  /// No cell can be finer: p4est has numbers for no more.
  template <int dim>
  constexpr int highest_level = dim == 2 ? 20 : 18;

  /**
   * @brief How many cells a mesh will have when it is refined, without
   * refining it.
   *
   * Cells that are refined only so that neighbours differ by one level do not
   * count, and new cells are taken as flat.
   * @param coarse mesh
   * @param global_levels how often each cell is refined
   * @param local_levels how often a cell is refined beyond that, by its centre
   * @param is_constant whether @p local_levels is the same everywhere
   * @param most where counting may stop: a greater number is returned then
   * @throws dealii::ExcMessage if a level is above the highest one
   */
  template <int dim>
  double
  count_cells(const dealii::Triangulation<dim> &coarse,
              const unsigned int                global_levels,
              const dealii::Function<dim>      &local_levels,
              const bool                        is_constant,
              const double                      most);
} // namespace Thalweg

#endif
