// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/dependences.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// The lines of @p constraints that are for @p indices.
    dealii::AffineConstraints<double>
    lines_for(const dealii::AffineConstraints<double> &constraints,
              const dealii::IndexSet                  &indices)
    {
      dealii::AffineConstraints<double> lines(indices);
      for (const auto &line : constraints.get_lines())
        if (indices.is_element(line.index))
          {
            lines.add_line(line.index);
            lines.add_entries(line.index, line.entries);
          }
      return lines;
    }
  } // namespace



  template <int dim>
  void
  make_continuity(const Mesh<dim>                   &mesh,
                  const dealii::DoFHandler<dim>     &dofs,
                  dealii::AffineConstraints<double> &constraints)
  {
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    constraints.clear();
    constraints.reinit(relevant);
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
    for (const auto &pair : mesh.periodic_pairs())
      dealii::DoFTools::make_periodicity_constraints(
        dofs, pair.first, pair.second, pair.direction, constraints);

    // A ghost cell's hanging node may have its masters in a cell that is
    // unknown here, and these may depend on others in turn, behind a periodic
    // boundary: all must be known to resolve the chain.
    const MPI_Comm   communicator = dofs.get_communicator();
    dealii::IndexSet known        = relevant;
    for (bool complete = false; !complete;)
      {
        constraints.make_consistent_in_parallel(dofs.locally_owned_dofs(),
                                                known,
                                                communicator);
        const auto n_known = known.n_elements();
        std::vector<dealii::types::global_dof_index> masters;
        for (const auto &line : constraints.get_lines())
          for (const auto &entry : line.entries)
            masters.push_back(entry.first);
        std::sort(masters.begin(), masters.end());
        known.add_indices(masters.begin(), masters.end());
        complete = dealii::Utilities::MPI::max(known.n_elements() - n_known,
                                               communicator) == 0;
        if (!complete)
          constraints.copy_from(lines_for(constraints, known));
      }
    constraints.close();
    constraints.copy_from(lines_for(constraints, relevant));
    constraints.close();
  }



  template <int dim>
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
  make_partitioner(const dealii::DoFHandler<dim>           &dofs,
                   const dealii::AffineConstraints<double> &constraints,
                   const unsigned int                       n_components)
  {
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    for (const auto &line : constraints.get_lines())
      for (const auto &entry : line.entries)
        relevant.add_index(entry.first);
    dealii::IndexSet owned(dofs.n_dofs() * n_components);
    dealii::IndexSet ghosted(dofs.n_dofs() * n_components);
    for (const auto node : dofs.locally_owned_dofs())
      owned.add_range(node * n_components, (node + 1) * n_components);
    for (const auto node : relevant)
      ghosted.add_range(node * n_components, (node + 1) * n_components);
    return std::make_shared<const dealii::Utilities::MPI::Partitioner>(
      owned, ghosted, dofs.get_communicator());
  }



  void
  Dependences::build(const dealii::AffineConstraints<double>   &constraints,
                     const dealii::Utilities::MPI::Partitioner &partitioner)
  {
    list.clear();
    dependent.assign(partitioner.locally_owned_size() +
                       partitioner.n_ghost_indices(),
                     false);
    for (const auto &line : constraints.get_lines())
      {
        const unsigned int node = partitioner.global_to_local(line.index);
        dependent[node]         = true;
        for (const auto &entry : line.entries)
          list.push_back(
            {node, partitioner.global_to_local(entry.first), entry.second});
      }
  }



  void
  Dependences::fold(Vector &vector, const unsigned int n_components) const
  {
    for (const Dependence &entry : list)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.master * n_components + c) +=
          entry.weight * vector.local_element(entry.node * n_components + c);
    for (const Dependence &entry : list)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) = 0.;
    vector.compress(dealii::VectorOperation::add);
  }



  void
  Dependences::join_copies(
    Vector                               &vector,
    const unsigned int                    n_components,
    const dealii::VectorOperation::values operation) const
  {
    for (std::size_t first = 0, end = 0; first < list.size(); first = end)
      {
        while (end < list.size() && list[end].node == list[first].node)
          ++end;
        if (end > first + 1)
          continue;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const double copy =
              vector.local_element(list[first].node * n_components + c);
            double &value =
              vector.local_element(list[first].master * n_components + c);
            value = operation == dealii::VectorOperation::add ? value + copy
                    : operation == dealii::VectorOperation::min
                      ? std::min(value, copy)
                      : std::max(value, copy);
          }
      }
    if (operation == dealii::VectorOperation::add)
      for (const Dependence &entry : list)
        for (unsigned int c = 0; c < n_components; ++c)
          vector.local_element(entry.node * n_components + c) = 0.;
    vector.compress(operation);
  }



  void
  Dependences::interpolate(Vector            &vector,
                           const unsigned int n_components) const
  {
    vector.update_ghost_values();
    for (const Dependence &entry : list)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) = 0.;
    for (const Dependence &entry : list)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) +=
          entry.weight * vector.local_element(entry.master * n_components + c);
  }



#define INSTANTIATE(dim)                                                   \
  template void make_continuity<dim>(const Mesh<dim> &,                    \
                                     const dealii::DoFHandler<dim> &,      \
                                     dealii::AffineConstraints<double> &); \
  template std::shared_ptr<const dealii::Utilities::MPI::Partitioner>      \
  make_partitioner<dim>(const dealii::DoFHandler<dim> &,                   \
                        const dealii::AffineConstraints<double> &,         \
                        const unsigned int);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
