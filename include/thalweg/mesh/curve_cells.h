// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_curve_cells_h
#define thalweg_mesh_curve_cells_h

#include <thalweg/mesh/cell_graph.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief An active cell as a place on p4est's space-filling curve, in plain
   * memory, as files have it.
   */
  struct CurveCell
  {
    /// The numbers of the children that lead from the coarse cell to this one,
    /// dim bits each, the finest last.
    std::uint64_t path = 0;
    /// The number of the coarse cell along the curve.
    std::uint32_t tree  = 0;
    std::uint32_t level = 0;

    bool
    operator==(const CurveCell &other) const
    {
      return path == other.path && tree == other.tree && level == other.level;
    }
  };

  /// Cells of more levels cannot be written down.
  template <int dim>
  constexpr std::uint32_t highest_curve_level = dim == 2 ? 29 : 18;

  /// The cells of this rank in the order of @p graph.
  template <int dim>
  std::vector<CurveCell>
  curve_cells(const CellGraph<dim> &graph);

  /**
   * @brief Whether the cells of all ranks, one behind the other, are each
   * possible and cover all coarse cells, none twice. Collective.
   * @param cells of this rank
   * @param n_trees how many coarse cells there are
   * @return what is wrong, the same on all ranks; empty: nothing
   */
  template <int dim>
  std::string
  fault_of(const MPI_Comm                communicator,
           const std::vector<CurveCell> &cells,
           const std::uint64_t           n_trees);
} // namespace Thalweg

#endif
