// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_cell_field_h
#define thalweg_mesh_cell_field_h

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Nodal values of a Q1 field copied out cell by cell, for all
   * locally owned and ghost cells in the order of the CellGraph.
   *
   * Values at hanging nodes are the interpolated ones. Entry
   * `field[cell][n_components * vertex + component]`.
   */
  template <int dim, int n_components>
  using CellField = std::vector<std::array<double, n_components *(1 << dim)>>;

  /// A velocity, in m/s.
  template <int dim>
  using CellVelocity = CellField<dim, dim>;
} // namespace Thalweg

#endif
