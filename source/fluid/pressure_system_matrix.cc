// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrix of PressureSystem.
#include <thalweg/fluid/pressure_system.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Thalweg
{
  template <int dim>
  void
  PressureSystem<dim>::initialize_matrix()
  {
    const auto &dofs    = space.scalar();
    const auto &scalars = *nodal(residual).get_partitioner();
    constraints.copy_from(space.scalar_constraints());
    dealii::AffineConstraints<double> open(
      space.scalar_constraints().get_local_lines());
    for (const auto &node : boundary.pressure_nodes())
      {
        const auto index = scalars.local_to_global(node.node);
        if (open.can_store_line(index))
          open.add_line(index);
      }
    open.close();
    constraints.merge(open,
                      dealii::AffineConstraints<double>::left_object_wins);
    constraints.close();

    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    dealii::DynamicSparsityPattern pattern(relevant);
    dealii::DoFTools::make_sparsity_pattern(dofs, pattern, constraints, false);
    dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, dofs.locally_owned_dofs(), dofs.get_communicator(), relevant);
    matrix = std::make_unique<dealii::TrilinosWrappers::SparseMatrix>();
    matrix->reinit(dofs.locally_owned_dofs(), pattern, dofs.get_communicator());

    using Matrices = CellMatrices<(1 << dim)>;
    std::vector<typename Matrices::Indices> cells(
      space.mesh().graph().n_owned_cells());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int v = 0; v < (1 << dim); ++v)
        cells[c][v] = scalars.local_to_global(space.nodes(c)[v]);
    cell_matrices.initialize(*matrix, constraints, cells);
    enriched =
      std::make_unique<EnrichedMatrix<dim>>(space, boundary, phase, *matrix);
  }



  template <int dim>
  typename PressureSystem<dim>::CellMatrix
  PressureSystem<dim>::cell_matrix(const unsigned int cell) const
  {
    const CutCell<dim> *cut = cut_cell(cell);
    CellMatrix          local =
      cut ? cut->laplace : integrals.laplace(space.mesh().graph().cell(cell));
    if (!cut)
      {
        const double inverse = 1. / phase.fluid(cell).density;
        for (auto &row : local)
          for (double &entry : row)
            entry *= inverse;
      }
    return local;
  }



  template <int dim>
  void
  PressureSystem<dim>::assemble()
  {
    *matrix = 0.;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      cell_matrices.add(c, cell_matrix(c));
    matrix->compress(dealii::VectorOperation::add);

    if (singular)
      {
        // The constant is fixed by raising one diagonal entry: compatible
        // right hand sides are solved exactly, the value there is zero.
        if (dealii::Utilities::MPI::this_mpi_process(
              space.scalar().get_communicator()) == 0)
          for (const auto index : space.scalar().locally_owned_dofs())
            if (!constraints.is_constrained(index))
              {
                matrix->add(index, index, matrix->diag_element(index));
                break;
              }
        matrix->compress(dealii::VectorOperation::add);
      }
    enriched->update();
    amg.update(*matrix);
    find_acceleration();
  }



  template void
  PressureSystem<2>::initialize_matrix();
  template void
  PressureSystem<3>::initialize_matrix();
  template typename PressureSystem<2>::CellMatrix
  PressureSystem<2>::cell_matrix(const unsigned int) const;
  template typename PressureSystem<3>::CellMatrix
  PressureSystem<3>::cell_matrix(const unsigned int) const;
  template void
  PressureSystem<2>::assemble();
  template void
  PressureSystem<3>::assemble();
} // namespace Thalweg
