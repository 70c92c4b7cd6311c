// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/flow_terms.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// By how many times of what is known it is extrapolated: a slope over a
    /// step that was cut short says nothing about one that is far longer.
    constexpr double largest_reach = 4.;
  } // namespace



  double
  NodalAcceleration::part_of_now(const double time) const
  {
    const double span = time_now - time_before;
    return span > 0. && time - time_now <= largest_reach * span
             ? (time - time_before) / span
             : 1.;
  }



  template <int dim>
  void
  FlowTerms<dim>::attach(const NodeSpace<dim> &space)
  {
    nodes = &space;
    accelerations.clear();
  }



  template <int dim>
  void
  FlowTerms<dim>::accelerate(const std::string       &whose,
                             const NodalAcceleration &acceleration)
  {
    accelerations[whose] = &acceleration;
  }



  template <int dim>
  void
  FlowTerms<dim>::set_time(const double new_time)
  {
    time = new_time;
  }



  template <int dim>
  void
  FlowTerms<dim>::add_acceleration(Vector &field) const
  {
    field.zero_out_ghost_values();
    for (const auto &[whose, acceleration] : accelerations)
      {
        const double part = acceleration->part_of_now(time);
        field.add(part, acceleration->now, 1. - part, acceleration->before);
      }
  }



  template <int dim>
  void
  FlowTerms<dim>::add_acceleration(const LagrangeSpace<dim> &space,
                                   Vector                   &field) const
  {
    Vector sum;
    nodes->initialize_velocity(sum);
    add_acceleration(sum);
    nodes->interpolate(sum, dim);

    field.zero_out_ghost_values();
    const unsigned int n_owned = space.n_owned_nodes();
    std::vector<bool>  is_done(n_owned, false);
    for (unsigned int c = 0; c < space.mesh().graph().n_cells(); ++c)
      for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
        {
          const unsigned int node = space.nodes(c)[i];
          if (node >= n_owned || is_done[node])
            continue;
          is_done[node] = true;
          for (unsigned int v = 0; v < NodeSpace<dim>::n_vertices; ++v)
            {
              const double weight =
                dealii::GeometryInfo<dim>::d_linear_shape_function(
                  space.unit_nodes()[i], v);
              for (unsigned int d = 0; d < dim && weight != 0.; ++d)
                field.local_element(dim * node + d) +=
                  weight * sum.local_element(dim * nodes->nodes(c)[v] + d);
            }
        }
  }



  THALWEG_INSTANTIATE(FlowTerms)
} // namespace Thalweg
