// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_cell_order_h
#define thalweg_mesh_cell_order_h

#include <deal.II/base/types.h>

#include <vector>

namespace Thalweg
{
  /// Things in the order of the cells where they are; those of a cell keep
  /// their order. Takes a time that is linear in both numbers.
  struct CellOrder
  {
    /// @param cells of the things; dealii::numbers::invalid_unsigned_int: it
    ///   is in none
    explicit CellOrder(const std::vector<unsigned int> &cells,
                       const unsigned int               n_cells);

    /// Where those of each cell begin in things, and the end.
    std::vector<unsigned int> begin;
    /// The numbers of those that are in cells.
    std::vector<unsigned int> things;
  };
} // namespace Thalweg

#endif
