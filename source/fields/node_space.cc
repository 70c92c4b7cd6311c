#include <thalweg/core/compat.h>
#include <thalweg/fields/node_space.h>

#include <deal.II/dofs/dof_tools.h>

#include <limits>

namespace Thalweg
{
  namespace
  {
    /// Hanging-node and periodicity constraints of one DoFHandler.
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
      // unknown here.
      constraints.make_consistent_in_parallel(dofs.locally_owned_dofs(),
                                              relevant,
                                              dofs.get_communicator());
      constraints.close();
    }



    /// All locally relevant nodes, and those that constraints reach, with
    /// @p n_components entries a node.
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
  } // namespace



  template <int dim>
  NodeSpace<dim>::NodeSpace(const Mesh<dim> &mesh)
    : mesh_(mesh)
    , fe_scalar(1)
    , fe_velocity(dealii::FE_Q<dim>(1), dim)
    , scalar_dofs(mesh.triangulation())
    , velocity_dofs(mesh.triangulation())
  {
    distribute();
  }



  template <int dim>
  void
  NodeSpace<dim>::distribute()
  {
    scalar_dofs.distribute_dofs(fe_scalar);
    velocity_dofs.distribute_dofs(fe_velocity);
    make_continuity(mesh_, scalar_dofs, scalar_continuity);
    scalar_partitioner = make_partitioner(scalar_dofs, scalar_continuity, 1);
    velocity_partitioner =
      make_partitioner(scalar_dofs, scalar_continuity, dim);

    const CellGraph<dim> &graph = mesh_.graph();
    cell_nodes.resize(graph.n_cells());
    std::vector<dealii::types::global_dof_index> scalar(n_vertices);
    std::vector<dealii::types::global_dof_index> velocity(dim * n_vertices);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      {
        const auto &cell = graph.iterator(c);
        Compat::on_dof_handler(cell, scalar_dofs)->get_dof_indices(scalar);
        Compat::on_dof_handler(cell, velocity_dofs)->get_dof_indices(velocity);
        for (unsigned int v = 0; v < n_vertices; ++v)
          {
            cell_nodes[c][v] = scalar_partitioner->global_to_local(scalar[v]);
            for (unsigned int d = 0; d < dim; ++d)
              AssertThrow(
                velocity_partitioner->global_to_local(velocity[dim * v + d]) ==
                  dim * cell_nodes[c][v] + d,
                dealii::ExcMessage(
                  "Velocity and scalar nodes are numbered differently."));
          }
      }

    node_dependences.clear();
    hanging.clear();
    dependent.assign(scalar_partitioner->locally_owned_size() +
                       scalar_partitioner->n_ghost_indices(),
                     false);
    for (const auto &line : scalar_continuity.get_lines())
      {
        const unsigned int node =
          scalar_partitioner->global_to_local(line.index);
        dependent[node]          = true;
        const unsigned int first = node_dependences.size();
        for (const auto &entry : line.entries)
          node_dependences.push_back(
            {node,
             scalar_partitioner->global_to_local(entry.first),
             entry.second});
        if (line.entries.size() > 1)
          hanging[node] = {first,
                           static_cast<unsigned int>(node_dependences.size())};
      }
    dealii::Point<dim> unknown;
    for (unsigned int d = 0; d < dim; ++d)
      unknown[d] = std::numeric_limits<double>::quiet_NaN();
    node_positions.assign(dependent.size(), unknown);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        node_positions[cell_nodes[c][v]] = graph.cell(c).vertices[v];
  }



  template <int dim>
  void
  NodeSpace<dim>::fold(Vector &vector, const unsigned int n_components) const
  {
    for (const Dependence &entry : node_dependences)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.master * n_components + c) +=
          entry.weight * vector.local_element(entry.node * n_components + c);
    for (const Dependence &entry : node_dependences)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) = 0.;
    vector.compress(dealii::VectorOperation::add);
  }



  template <int dim>
  void
  NodeSpace<dim>::interpolate(Vector            &vector,
                              const unsigned int n_components) const
  {
    vector.update_ghost_values();
    for (const Dependence &entry : node_dependences)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) = 0.;
    for (const Dependence &entry : node_dependences)
      for (unsigned int c = 0; c < n_components; ++c)
        vector.local_element(entry.node * n_components + c) +=
          entry.weight * vector.local_element(entry.master * n_components + c);
  }



  template <int dim>
  void
  NodeSpace<dim>::initialize_scalar(Vector &vector) const
  {
    vector.reinit(scalar_partitioner);
  }



  template <int dim>
  void
  NodeSpace<dim>::initialize_velocity(Vector &vector) const
  {
    vector.reinit(velocity_partitioner);
  }



  template <int dim>
  void
  NodeSpace<dim>::copy_to_cells(const Vector      &velocity,
                                CellVelocity<dim> &cells) const
  {
    cells.resize(cell_nodes.size());
    for (unsigned int c = 0; c < cell_nodes.size(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        for (unsigned int d = 0; d < dim; ++d)
          cells[c][dim * v + d] =
            velocity.local_element(dim * cell_nodes[c][v] + d);
  }



  template <int dim>
  void
  NodeSpace<dim>::copy_to_cells(const Vector      &scalar,
                                CellField<dim, 1> &cells) const
  {
    cells.resize(cell_nodes.size());
    for (unsigned int c = 0; c < cell_nodes.size(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        cells[c][v] = scalar.local_element(cell_nodes[c][v]);
  }



  THALWEG_INSTANTIATE(NodeSpace)
} // namespace Thalweg
