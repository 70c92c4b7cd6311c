// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_gather_h
#define thalweg_fields_gather_h

#include <deal.II/lac/la_parallel_vector.h>

#include <array>

namespace Thalweg
{
  /// Values of a ghosted scalar at the nodes of a cell.
  template <int dim>
  inline std::array<double, (1 << dim)>
  gather(const dealii::LinearAlgebra::distributed::Vector<double> &scalar,
         const std::array<unsigned int, (1 << dim)>               &nodes)
  {
    std::array<double, (1 << dim)> values;
    for (unsigned int v = 0; v < nodes.size(); ++v)
      values[v] = scalar.local_element(nodes[v]);
    return values;
  }

  /// Values of a ghosted velocity at the nodes of a cell, the components of
  /// a node one behind the other.
  template <int dim>
  inline std::array<double, dim *(1 << dim)>
  gather_velocity(
    const dealii::LinearAlgebra::distributed::Vector<double> &velocity,
    const std::array<unsigned int, (1 << dim)>               &nodes)
  {
    std::array<double, dim *(1 << dim)> values;
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (unsigned int d = 0; d < dim; ++d)
        values[dim * v + d] = velocity.local_element(dim * nodes[v] + d);
    return values;
  }
} // namespace Thalweg

#endif
