#include <thalweg/core/registry.h>
#include <thalweg/postprocess/flow_means.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  template <int dim>
  void
  FlowMeans<dim>::begin(const FlowFields<dim> &flow)
  {
    mean_velocity.reinit(flow.velocity);
    mean_pressure.reinit(flow.pressure);
    for (auto &products : stress_times_time)
      products.reinit(flow.velocity);

    const auto &fe     = flow.velocity_dofs.get_fe();
    const auto &layout = *flow.velocity.get_partitioner();
    std::vector<dealii::types::global_dof_index> indices(fe.dofs_per_cell);
    partners.assign(layout.locally_owned_size(), {});
    for (const auto &cell : flow.velocity_dofs.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          if (layout.in_local_range(indices[i]))
            for (unsigned int d = 0; d < dim; ++d)
              partners[layout.global_to_local(indices[i])][d] =
                layout.global_to_local(indices[fe.component_to_system_index(
                  d, fe.system_to_component_index(i).second)]);
      }
  }


  template <int dim>
  void
  FlowMeans<dim>::add(const FlowFields<dim> &flow, const double duration)
  {
    if (total_time == 0.)
      begin(flow);
    AssertThrow(flow.velocity.size() == mean_velocity.size(),
                dealii::ExcMessage("'time averages' needs a mesh that stays "
                                   "the same from 'Average from' on."));
    total_time += duration;
    const double part = duration / total_time;
    // The products of fluctuations grow with the mean as it was, which loses
    // no digits as a difference of means of products would.
    const auto fluctuation = [&](const unsigned int i) {
      return flow.velocity.local_element(i) - mean_velocity.local_element(i);
    };
    for (unsigned int i = 0; i < partners.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        stress_times_time[d].local_element(i) +=
          duration * (1. - part) * fluctuation(i) * fluctuation(partners[i][d]);
    mean_velocity.sadd(1. - part, part, flow.velocity);
    mean_pressure.sadd(1. - part, part, flow.pressure);
    mean_velocity.update_ghost_values();
    mean_pressure.update_ghost_values();
  }


  template <int dim>
  typename FlowMeans<dim>::Vector
  FlowMeans<dim>::stress(const unsigned int component) const
  {
    Vector row = stress_times_time[component];
    row /= total_time;
    row.update_ghost_values();
    return row;
  }


  THALWEG_INSTANTIATE(FlowMeans)
} // namespace Thalweg
