// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_node_targets_h
#define thalweg_transfer_node_targets_h

#include <thalweg/fields/node_space.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /// A node that a cell's particles speak to: its weight is a combination of
  /// the shape functions of the cell's vertices.
  template <int dim>
  struct NodeTarget
  {
    unsigned int                   node;
    dealii::Point<dim>             position;
    std::array<double, (1 << dim)> coefficients;

    /// From the values of the shape functions at a particle.
    double
    weight(const std::array<double, (1 << dim)> &shape) const
    {
      double sum = 0.;
      for (unsigned int v = 0; v < shape.size(); ++v)
        sum += coefficients[v] * shape[v];
      return sum;
    }
  };

  /**
   * @brief The nodes around an owned cell: its vertices, and in place of
   * hanging ones those that they depend on, each where it is nearest to the
   * cell if there are several images behind periodic boundaries.
   * @param targets filled anew
   */
  template <int dim>
  void
  find_node_targets(const NodeSpace<dim>         &space,
                    const unsigned int            cell,
                    std::vector<NodeTarget<dim>> &targets);
} // namespace Thalweg

#endif
