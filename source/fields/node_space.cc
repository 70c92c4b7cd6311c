#include <thalweg/core/compat.h>
#include <thalweg/fields/node_space.h>

#include <limits>

namespace Thalweg
{
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

    node_dependences.build(scalar_continuity, *scalar_partitioner);
    hanging.clear();
    const auto &all = dependences();
    for (unsigned int first = 0, end = 0; first < all.size(); first = end)
      {
        while (end < all.size() && all[end].node == all[first].node)
          ++end;
        if (end > first + 1)
          hanging[all[first].node] = {first, end};
      }
    dealii::Point<dim> unknown;
    for (unsigned int d = 0; d < dim; ++d)
      unknown[d] = std::numeric_limits<double>::quiet_NaN();
    node_positions.assign(node_dependences.n_nodes(), unknown);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        node_positions[cell_nodes[c][v]] = graph.cell(c).vertices[v];
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
