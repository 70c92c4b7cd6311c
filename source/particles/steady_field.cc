// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/particles/steady_field.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  using namespace CellPolynomial;


  template <int dim>
  SteadyField<dim>::SteadyField(const CellGraph<dim>    &graph,
                                const CellVelocity<dim> &velocity,
                                const double             greatest_way,
                                const double             direction)
  {
    AssertDimension(velocity.size(), graph.n_cells());
    flow.reserve(graph.n_cells());
    for (unsigned int i = 0; i < graph.n_cells(); ++i)
      flow.push_back(
        prepare(graph.cell(i), velocity[i], greatest_way, direction));
  }


  template <int dim>
  typename SteadyField<dim>::Flow
  SteadyField<dim>::prepare(const typename CellGraph<dim>::Cell &geometry,
                            const Polynomial                    &nodal_velocity,
                            const double                         greatest_way,
                            const double                         direction)
  {
    Polynomial shape{};
    if (!geometry.axis_parallel)
      shape = CellMaps<dim>::shape_of(geometry);
    Flow   result;
    double fastest = 0;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        Coordinates velocity, vertex;
        for (unsigned int d = 0; d < dim; ++d)
          {
            velocity[d] = direction * nodal_velocity[v * dim + d];
            vertex[d]   = (v >> d) & 1;
          }
        Coordinates rate;
        if (geometry.axis_parallel)
          {
            for (unsigned int d = 0; d < dim; ++d)
              rate[d] = velocity[d] * geometry.inverse_extent[d];
            velocity = rate;
          }
        else
          rate = solve<dim>(gradient<dim>(shape, vertex), velocity);
        for (unsigned int d = 0; d < dim; ++d)
          {
            result.velocity[v * dim + d] = velocity[d];
            fastest                      = std::max(fastest, std::abs(rate[d]));
          }
      }
    to_polynomial<dim>(result.velocity);
    result.longest_substep =
      fastest > 0 ? greatest_way / fastest : std::numeric_limits<double>::max();
    return result;
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::SteadyField)
