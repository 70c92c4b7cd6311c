// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_cell_gradients_h
#define thalweg_adaptation_cell_gradients_h

#include <thalweg/mesh/cell_graph.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace Thalweg
{
  /// The gradient at the centre of a cell of a field with the values
  /// @p values at its vertices, `values[vertex][component]`; entry
  /// `[component][direction]` of the result.
  template <int dim, int n_components>
  std::array<dealii::Tensor<1, dim>, n_components>
  gradient_at_center(
    const typename CellGraph<dim>::Cell                            &cell,
    const std::array<std::array<double, n_components>, (1 << dim)> &values);

  /// The edge of a square or cube as large as @p cell, in m.
  template <int dim>
  double
  cell_size(const typename CellGraph<dim>::Cell &cell);
} // namespace Thalweg

#endif
