// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/projection.h>

namespace Thalweg
{
  template <int dim>
  void
  add_increment(Population<dim>      &population,
                const NodeSpace<dim> &space,
                const Vector         &new_velocity,
                const Vector         &velocity_star,
                const double          factor)
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto                         &nodes = space.nodes(c);
        std::array<double, dim *(1 << dim)> increment;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            increment[dim * v + d] =
              factor * (new_velocity.local_element(dim * nodes[v] + d) -
                        velocity_star.local_element(dim * nodes[v] + d));
        for (auto &particle : population.in_cell(c))
          {
            const auto shape      = Q1::values<dim>(particle.reference());
            const auto properties = particle.properties();
            for (unsigned int v = 0; v < nodes.size(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                properties[Population<dim>::velocity_offset + d] +=
                  shape[v] * increment[dim * v + d];
          }
      }
  }



  template void
  add_increment<2>(Population<2> &,
                   const NodeSpace<2> &,
                   const Vector &,
                   const Vector &,
                   const double);
  template void
  add_increment<3>(Population<3> &,
                   const NodeSpace<3> &,
                   const Vector &,
                   const Vector &,
                   const double);
} // namespace Thalweg
