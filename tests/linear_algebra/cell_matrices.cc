// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/linear_algebra/amg.h>
#include <thalweg/linear_algebra/cell_matrices.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <gtest/gtest.h>

namespace
{
  /// Q1 on a mesh with hanging nodes.
  template <int dim>
  struct Q1System
  {
    static constexpr unsigned int n = 1 << dim;
    using Matrices                  = Thalweg::CellMatrices<n>;

    Q1System()
      : triangulation(MPI_COMM_WORLD)
      , dofs(triangulation)
    {
      dealii::GridGenerator::subdivided_hyper_cube(triangulation, 4);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center().norm() < .4)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
      dofs.distribute_dofs(dealii::FE_Q<dim>(1));
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
      constraints.reinit(relevant);
      dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
      constraints.close();
      pattern.reinit(dofs.n_dofs(), dofs.n_dofs(), relevant);
      dealii::DoFTools::make_sparsity_pattern(dofs,
                                              pattern,
                                              constraints,
                                              false);
      dealii::SparsityTools::distribute_sparsity_pattern(
        pattern, dofs.locally_owned_dofs(), MPI_COMM_WORLD, relevant);
      std::vector<dealii::types::global_dof_index> indices(n);
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(indices);
            cells.emplace_back();
            std::copy(indices.begin(), indices.end(), cells.back().begin());
          }
    }

    void
    initialize(dealii::TrilinosWrappers::SparseMatrix &matrix) const
    {
      matrix.reinit(dofs.locally_owned_dofs(), pattern, MPI_COMM_WORLD);
    }

    /// Symmetric and positive definite, and different in each cell.
    typename Matrices::Local
    local(const unsigned int cell) const
    {
      typename Matrices::Local matrix;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix[i][j] =
            (1. + cell % 7) * (i == j ? n : -1. + .1 * (i + j) / n);
      return matrix;
    }

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    dealii::DoFHandler<dim>                           dofs;
    dealii::AffineConstraints<double>                 constraints;
    dealii::DynamicSparsityPattern                    pattern;
    std::vector<typename Matrices::Indices>           cells;
  };



  template <int dim>
  void
  check_sum()
  {
    const Q1System<dim>                    setup;
    constexpr unsigned int                 n = Q1System<dim>::n;
    dealii::TrilinosWrappers::SparseMatrix expected, matrix;
    setup.initialize(expected);
    setup.initialize(matrix);
    for (unsigned int c = 0; c < setup.cells.size(); ++c)
      {
        dealii::FullMatrix<double> full(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            full(i, j) = setup.local(c)[i][j];
        setup.constraints.distribute_local_to_global(
          full,
          std::vector<dealii::types::global_dof_index>(setup.cells[c].begin(),
                                                       setup.cells[c].end()),
          expected);
      }
    expected.compress(dealii::VectorOperation::add);

    typename Q1System<dim>::Matrices sums;
    sums.initialize(matrix, setup.constraints, setup.cells);
    for (unsigned int repetition = 0; repetition < 2; ++repetition)
      {
        matrix = 0.;
        for (unsigned int c = 0; c < setup.cells.size(); ++c)
          sums.add(c, setup.local(c));
        matrix.compress(dealii::VectorOperation::add);
        EXPECT_GT(matrix.frobenius_norm(), 1.);
        dealii::TrilinosWrappers::SparseMatrix difference;
        difference.copy_from(matrix);
        difference.add(-1., expected);
        EXPECT_LT(difference.frobenius_norm(),
                  1e-13 * expected.frobenius_norm());
      }
  }
} // namespace



TEST(CellMatricesMpi, AddUpToTheMatrixWithConstraints)
{
  check_sum<2>();
  check_sum<3>();
}



TEST(AmgPreconditionerMpi, IsBuiltAnewOnlyForOtherEntries)
{
  const Q1System<2>                      setup;
  dealii::TrilinosWrappers::SparseMatrix matrix;
  setup.initialize(matrix);
  Q1System<2>::Matrices sums;
  sums.initialize(matrix, setup.constraints, setup.cells);
  Thalweg::AmgPreconditioner amg;
  const auto                 assemble = [&](const double factor) {
    matrix = 0.;
    for (unsigned int c = 0; c < setup.cells.size(); ++c)
      sums.add(c, setup.local(c));
    matrix.compress(dealii::VectorOperation::add);
    matrix *= factor;
    amg.update(matrix);
  };
  assemble(1.);
  assemble(1.);
  EXPECT_EQ(amg.n_builds(), 1u);
  assemble(2.);
  EXPECT_EQ(amg.n_builds(), 2u);
}
