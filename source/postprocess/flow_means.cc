// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/core/registry.h>
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/flow_means.h>

namespace Thalweg
{
  template <int dim>
  void
  FlowMeans<dim>::initialize(const Mesh<dim> &mesh, const FlowFields<dim> &flow)
  {
    const unsigned int velocity_degree = flow.velocity_dofs.get_fe().degree;
    const unsigned int pressure_degree = flow.pressure_dofs.get_fe().degree;
    velocity_space =
      std::make_shared<LagrangeSpace<dim>>(mesh, velocity_degree, flow.mapping);
    pressure_space = velocity_space;
    if (pressure_degree != velocity_degree)
      pressure_space = std::make_shared<LagrangeSpace<dim>>(mesh,
                                                            pressure_degree,
                                                            flow.mapping);
    velocity_sources =
      find_sources(*velocity_space, flow.velocity_dofs, flow.velocity);
    pressure_sources =
      find_sources(*pressure_space, flow.pressure_dofs, flow.pressure);
    velocity_space->initialize(mean_velocity, dim);
    pressure_space->initialize(mean_pressure, 1);
    if (has_traction(flow))
      velocity_space->initialize(mean_traction, dim);
    if (with_stresses)
      for (auto &products : stress_times_time)
        velocity_space->initialize(products, dim);
  }



  template <int dim>
  std::vector<unsigned int>
  FlowMeans<dim>::find_sources(const LagrangeSpace<dim>      &own,
                               const dealii::DoFHandler<dim> &dofs,
                               const Vector                  &vector)
  {
    const auto               &fe           = dofs.get_fe();
    const unsigned int        n_components = fe.n_components();
    const unsigned int        n_owned      = n_components * own.n_owned_nodes();
    const auto               &graph        = own.mesh().graph();
    std::vector<unsigned int> sources(n_owned);
    std::vector<dealii::types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      {
        Compat::on_dof_handler(graph.iterator(c), dofs)
          ->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          {
            const auto [component, place] = fe.system_to_component_index(i);
            const unsigned int entry =
              n_components * own.nodes(c)[own.lexicographic()[place]] +
              component;
            if (entry < n_owned)
              sources[entry] =
                vector.get_partitioner()->global_to_local(indices[i]);
          }
      }
    return sources;
  }



  template <int dim>
  void
  FlowMeans<dim>::add(const FlowFields<dim> &flow, const double duration)
  {
    total_time += duration;
    const double part = duration / total_time;
    // The products of fluctuations grow with the mean as it was, which loses
    // no digits as a difference of means of products would.
    const auto fluctuation = [&](const unsigned int i) {
      return flow.velocity.local_element(velocity_sources[i]) -
             mean_velocity.local_element(i);
    };
    if (with_stresses)
      for (unsigned int i = 0; i < velocity_sources.size(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          stress_times_time[d].local_element(i) += duration * (1. - part) *
                                                   fluctuation(i) *
                                                   fluctuation(i - i % dim + d);

    const auto average = [&](const std::vector<unsigned int> &sources,
                             const Vector                    &now,
                             Vector                          &mean) {
      for (unsigned int i = 0; i < sources.size(); ++i)
        mean.local_element(i) = (1. - part) * mean.local_element(i) +
                                part * now.local_element(sources[i]);
    };
    average(velocity_sources, flow.velocity, mean_velocity);
    average(pressure_sources, flow.pressure, mean_pressure);
    velocity_space->interpolate(mean_velocity, dim);
    pressure_space->interpolate(mean_pressure, 1);
    if (mean_traction.size() > 0)
      {
        average(velocity_sources, *flow.traction, mean_traction);
        velocity_space->interpolate(mean_traction, dim);
      }
    if (with_stresses)
      for (auto &products : stress_times_time)
        velocity_space->interpolate(products, dim);
  }



  template <int dim>
  FlowFields<dim>
  FlowMeans<dim>::flow(const FlowFields<dim> &present) const
  {
    return {present.mapping,
            velocity_space->velocity(),
            pressure_space->scalar(),
            mean_velocity,
            mean_pressure,
            nullptr,
            &mean_traction,
            present.density,
            present.viscosity,
            present.pressure_time};
  }



  template <int dim>
  Vector
  FlowMeans<dim>::stress(const unsigned int component) const
  {
    Vector row = stress_times_time[component];
    row /= total_time;
    row.update_ghost_values();
    return row;
  }



  template <int dim>
  void
  FlowMeans<dim>::keep(const State<dim> &state)
  {
    state.values().value("averaged time", total_time);
    state.field("mean velocity", *velocity_space, mean_velocity, dim);
    state.field("mean pressure", *pressure_space, mean_pressure, 1);
    if (mean_traction.size() > 0)
      state.field("mean traction", *velocity_space, mean_traction, dim);
    if (with_stresses)
      for (unsigned int d = 0; d < dim; ++d)
        state.field(std::string("stress ") + "xyz"[d],
                    *velocity_space,
                    stress_times_time[d],
                    dim);
  }


  THALWEG_INSTANTIATE(FlowMeans)
} // namespace Thalweg
