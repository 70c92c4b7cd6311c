#include <thalweg/core/compat.h>
#include <thalweg/fields/node_space.h>

#include <deal.II/dofs/dof_tools.h>

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
      constraints.close();
    }



    /// All locally relevant entries, and those that constraints reach.
    template <int dim>
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
    make_partitioner(const dealii::DoFHandler<dim>           &dofs,
                     const dealii::AffineConstraints<double> &constraints)
    {
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
      std::vector<dealii::types::global_dof_index> reached;
      for (const auto &line : constraints.get_lines())
        for (const auto &entry : line.entries)
          reached.push_back(entry.first);
      std::sort(reached.begin(), reached.end());
      reached.erase(std::unique(reached.begin(), reached.end()),
                    reached.end());
      relevant.add_indices(reached.begin(), reached.end());
      return std::make_shared<const dealii::Utilities::MPI::Partitioner>(
        dofs.locally_owned_dofs(), relevant, dofs.get_communicator());
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
    make_continuity(mesh_, velocity_dofs, velocity_continuity);
    scalar_partitioner   = make_partitioner(scalar_dofs, scalar_continuity);
    velocity_partitioner = make_partitioner(velocity_dofs, velocity_continuity);

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
