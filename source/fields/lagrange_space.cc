// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fields/lagrange_space.h>

#include <deal.II/dofs/dof_renumbering.h>

namespace Thalweg
{
  template <int dim>
  LagrangeSpace<dim>::LagrangeSpace(const Mesh<dim>            &mesh,
                                    const unsigned int          degree,
                                    const dealii::Mapping<dim> &mapping)
    : mesh_(mesh)
    , mapping_(mapping)
    , fe_scalar(degree)
    , fe_velocity(dealii::FE_Q<dim>(degree), dim)
    , scalar_dofs(mesh.triangulation())
    , velocity_dofs(mesh.triangulation())
    , lexicographic_numbering(fe_scalar.get_poly_space_numbering())
  {
    scalar_dofs.distribute_dofs(fe_scalar);
    velocity_dofs.distribute_dofs(fe_velocity);
    // Along the curve of the cells, whatever became of the mesh before.
    dealii::DoFRenumbering::hierarchical(scalar_dofs);
    dealii::DoFRenumbering::hierarchical(velocity_dofs);
    make_continuity(mesh_, scalar_dofs, scalar_continuity);
    scalar_partitioner = make_partitioner(scalar_dofs, scalar_continuity, 1);
    velocity_partitioner =
      make_partitioner(scalar_dofs, scalar_continuity, dim);
    node_dependences.build(scalar_continuity, *scalar_partitioner);
    number_cells();
  }



  // Here, and not in each translation unit: it makes the code of elements.
  template <int dim>
  LagrangeSpace<dim>::~LagrangeSpace() = default;



  template <int dim>
  void
  LagrangeSpace<dim>::number_cells()
  {
    const unsigned int n = n_nodes_per_cell();
    unit_support_points.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      unit_support_points[lexicographic_numbering[i]] =
        fe_scalar.get_unit_support_points()[i];

    const CellGraph<dim> &graph = mesh_.graph();
    cell_nodes.resize(graph.n_cells() * n);
    std::vector<dealii::types::global_dof_index> scalar(n), velocity(dim * n);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      {
        const auto &cell = graph.iterator(c);
        Compat::on_dof_handler(cell, scalar_dofs)->get_dof_indices(scalar);
        Compat::on_dof_handler(cell, velocity_dofs)->get_dof_indices(velocity);
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int node =
              scalar_partitioner->global_to_local(scalar[i]);
            cell_nodes[c * n + lexicographic_numbering[i]] = node;
            for (unsigned int d = 0; d < dim; ++d)
              AssertThrow(
                velocity_partitioner->global_to_local(
                  velocity[fe_velocity.component_to_system_index(d, i)]) ==
                  dim * node + d,
                dealii::ExcMessage(
                  "Velocity and scalar nodes are numbered differently."));
          }
      }
  }



  template <int dim>
  void
  LagrangeSpace<dim>::copy_to_cells(const Vector        &velocity,
                                    std::vector<double> &cells) const
  {
    cells.resize(cell_nodes.size() * dim);
    for (std::size_t i = 0; i < cell_nodes.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        cells[i * dim + d] = velocity.local_element(dim * cell_nodes[i] + d);
  }



  THALWEG_INSTANTIATE(LagrangeSpace)
} // namespace Thalweg
