// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/methods/convected_change.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim>
  ConvectedChange<dim>::ConvectedChange(const NodeSpace<dim> &space)
    : space(space)
  {
    // Of the cells around a node the same one whoever owns them: where a way
    // begins decides how it is divided into substeps.
    dealii::Tensor<1, dim> direction;
    for (unsigned int d = 0; d < dim; ++d)
      direction[d] = std::sqrt(1. + d * (d + 1) / 2.);
    const auto &graph = space.mesh().graph();
    const auto  key   = [&](const unsigned int c, const unsigned int v) {
      dealii::Tensor<1, dim> to_center;
      for (const auto &vertex : graph.cell(c).vertices)
        to_center += vertex - graph.cell(c).vertices[v];
      return direction * to_center;
    };
    Vector keys;
    space.initialize_scalar(keys);
    for (unsigned int n = 0; n < space.dependences().n_nodes(); ++n)
      keys.local_element(n) = std::numeric_limits<double>::lowest();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int v = 0; v < space.nodes(c).size(); ++v)
        {
          double &greatest = keys.local_element(space.nodes(c)[v]);
          greatest         = std::max(greatest, key(c, v));
        }
    keys.compress(dealii::VectorOperation::max);
    keys.update_ghost_values();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int v = 0; v < space.nodes(c).size(); ++v)
        {
          const unsigned int node = space.nodes(c)[v];
          if (space.is_dependent(node) || key(c, v) != keys.local_element(node))
            continue;
          keys.local_element(node) = std::numeric_limits<double>::max();
          dealii::Point<dim> reference;
          for (unsigned int d = 0; d < dim; ++d)
            reference[d] = (v >> d) & 1u;
          nodes.push_back(node);
          cells.push_back(c);
          reference_points.push_back(reference);
        }
  }



  template <int dim>
  void
  ConvectedChange<dim>::find(const StreamlineConvection<dim> &convection,
                             const Vector                    &velocity,
                             const CellField<dim, 1>         &level_set,
                             const double                     time,
                             Vector                          &change) const
  {
    CellVelocity<dim> in_cells;
    space.copy_to_cells(velocity, in_cells);
    const auto feet =
      convection.trace_back(cells, reference_points, in_cells, level_set, time);
    change.zero_out_ghost_values();
    change = 0.;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < dim; ++d)
        change.local_element(dim * nodes[k] + d) =
          feet[k].velocity[d] - velocity.local_element(dim * nodes[k] + d);
    change.compress(dealii::VectorOperation::add);
  }



  THALWEG_INSTANTIATE(ConvectedChange)
} // namespace Thalweg
