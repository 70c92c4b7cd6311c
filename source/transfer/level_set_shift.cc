// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/projection.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  void
  shift_level_sets(Population<dim>      &population,
                   const NodeSpace<dim> &space,
                   const Vector         &shift,
                   const double          factor)
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto nodal = gather<dim>(shift, space.nodes(c));
        if (std::all_of(nodal.begin(), nodal.end(), [](const double value) {
              return value == 0.;
            }))
          continue;
        for (auto &particle : population.in_cell(c))
          particle.properties()[Population<dim>::level_set_offset] +=
            factor * Q1::value<dim>(nodal, particle.reference());
      }
  }



  template void
  shift_level_sets<2>(Population<2> &,
                      const NodeSpace<2> &,
                      const Vector &,
                      const double);
  template void
  shift_level_sets<3>(Population<3> &,
                      const NodeSpace<3> &,
                      const Vector &,
                      const double);
} // namespace Thalweg
