// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_turn_nodes_h
#define thalweg_fields_turn_nodes_h

#include <thalweg/fields/dependences.h>

#include <deal.II/base/tensor.h>

namespace Thalweg
{
  /// Multiplies the owned nodes' vectors by a matrix.
  template <int dim>
  void
  turn_nodes(const dealii::Tensor<2, dim> &matrix, Vector &vector)
  {
    for (unsigned int n = 0; n < vector.locally_owned_size() / dim; ++n)
      {
        dealii::Tensor<1, dim> value;
        for (unsigned int d = 0; d < dim; ++d)
          value[d] = vector.local_element(dim * n + d);
        value = matrix * value;
        for (unsigned int d = 0; d < dim; ++d)
          vector.local_element(dim * n + d) = value[d];
      }
  }
} // namespace Thalweg

#endif
