// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/velocity_matrix.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Thalweg
{
  template <int dim>
  VelocityMatrix<dim>::VelocityMatrix(const NodeSpace<dim>       &space,
                                      const BoundaryNodes<dim>   &boundary,
                                      const ViscousOperator<dim> &viscous)
    : space(space)
    , boundary(boundary)
    , viscous(viscous)
    , sparse(std::make_unique<dealii::TrilinosWrappers::SparseMatrix>())
  {
    find_constraints();
    const auto      &dofs = space.velocity();
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    dealii::DynamicSparsityPattern pattern(relevant);
    dealii::DoFTools::make_sparsity_pattern(dofs, pattern, constraints, false);
    dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, dofs.locally_owned_dofs(), dofs.get_communicator(), relevant);
    sparse->reinit(dofs.locally_owned_dofs(), pattern, dofs.get_communicator());

    const auto &layout = space.scalar_layout();
    std::vector<typename CellMatrices<n_cell_values>::Indices> cells(
      space.mesh().graph().n_owned_cells());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int i = 0; i < n_cell_values; ++i)
        cells[c][i] =
          dim * layout.local_to_global(space.nodes(c)[i / dim]) + i % dim;
    cell_matrices.initialize(*sparse, constraints, cells);
  }



  template <int dim>
  VelocityMatrix<dim>::~VelocityMatrix() = default;



  template <int dim>
  void
  VelocityMatrix<dim>::find_constraints()
  {
    // What is left of the unit vectors at each node, with ghosts.
    std::array<Vector, dim> left;
    for (unsigned int d = 0; d < dim; ++d)
      {
        space.initialize_velocity(left[d]);
        for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
          left[d].local_element(dim * n + d) = 1.;
        boundary.project(left[d]);
        space.interpolate(left[d], dim);
      }

    constexpr double round_off = 1e-12;
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(space.velocity(), relevant);
    constraints.reinit(relevant);
    const auto &hanging = space.scalar_constraints();
    const auto &layout  = space.scalar_layout();
    for (unsigned int n = 0; n < space.dependences().n_nodes(); ++n)
      {
        const auto index = layout.local_to_global(n);
        if (!constraints.can_store_line(dim * index))
          continue;
        if (space.is_dependent(n))
          {
            for (unsigned int d = 0; d < dim; ++d)
              {
                constraints.add_line(dim * index + d);
                for (const auto &[master, weight] :
                     *hanging.get_constraint_entries(index))
                  constraints.add_entry(dim * index + d,
                                        dim * master + d,
                                        weight);
              }
            continue;
          }
        dealii::Tensor<2, dim> projector;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            projector[e][d] = left[d].local_element(dim * n + e);
        bool is_oblique = false;
        for (unsigned int d = 0; d < dim; ++d)
          if (projector[d].norm() < round_off)
            constraints.add_line(dim * index + d);
          else
            is_oblique = is_oblique || projector[d][d] < 1. - round_off;
        if (is_oblique)
          projectors[n] = projector;
      }
    constraints.close();
  }



  template <int dim>
  void
  VelocityMatrix<dim>::remove_fixed(
    const unsigned int                         cell,
    typename ViscousOperator<dim>::CellMatrix &matrix) const
  {
    if (projectors.empty())
      return;
    const auto &nodes = space.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        const auto entry = projectors.find(nodes[v]);
        if (entry == projectors.end())
          continue;
        const dealii::Tensor<2, dim> &P     = entry->second;
        double                        trace = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          trace += matrix[dim * v + d][dim * v + d] / dim;
        for (unsigned int j = 0; j < n_cell_values; ++j)
          {
            dealii::Tensor<1, dim> row;
            for (unsigned int d = 0; d < dim; ++d)
              row[d] = matrix[dim * v + d][j];
            row = P * row;
            for (unsigned int d = 0; d < dim; ++d)
              matrix[dim * v + d][j] = row[d];
          }
        for (unsigned int i = 0; i < n_cell_values; ++i)
          {
            dealii::Tensor<1, dim> column;
            for (unsigned int d = 0; d < dim; ++d)
              column[d] = matrix[i][dim * v + d];
            column = P * column;
            for (unsigned int d = 0; d < dim; ++d)
              matrix[i][dim * v + d] = column[d];
          }
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            matrix[dim * v + d][dim * v + e] +=
              trace * ((d == e ? 1. : 0.) - P[d][e]);
      }
  }



  template <int dim>
  void
  VelocityMatrix<dim>::assemble()
  {
    *sparse = 0.;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        auto local = viscous.cell_matrix(c);
        remove_fixed(c, local);
        cell_matrices.add(c, local);
      }
    sparse->compress(dealii::VectorOperation::add);

    const Vector &masses = viscous.masses();
    const auto   &layout = space.scalar_layout();
    for (unsigned int n = 0; n < masses.locally_owned_size(); ++n)
      if (!space.is_dependent(n))
        for (unsigned int d = 0; d < dim; ++d)
          {
            const auto index = dim * layout.local_to_global(n) + d;
            sparse->add(index,
                        index,
                        masses.local_element(n) / viscous.time_step());
          }
    sparse->compress(dealii::VectorOperation::add);
  }



  THALWEG_INSTANTIATE(VelocityMatrix)
} // namespace Thalweg
