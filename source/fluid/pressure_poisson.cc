// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/pressure_poisson.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Thalweg
{
  template <int dim>
  PressurePoisson<dim>::PressurePoisson(const FlowOperators<dim> &operators,
                                        const FlowBoundary<dim>  &boundary)
    : operators(operators)
    , boundary(boundary)
    , singular(!boundary.conditions().has_open_boundary())
    , pinned_node(dealii::numbers::invalid_unsigned_int)
  {
    operators.pressure_space.initialize(work, 1);
    assemble();
  }



  template <int dim>
  PressurePoisson<dim>::~PressurePoisson() = default;



  template <int dim>
  void
  PressurePoisson<dim>::assemble()
  {
    const auto &space  = operators.pressure_space;
    const auto &dofs   = space.scalar();
    const auto &layout = space.scalar_layout();

    // Which nodes are open is known to their owners; others need it too.
    Vector is_open;
    space.initialize(is_open, 1);
    for (const auto &entry : boundary.open_nodes())
      is_open.local_element(entry.node) = 1.;
    is_open.update_ghost_values();
    dealii::AffineConstraints<double> constraints,
      open(space.scalar_constraints().get_local_lines());
    constraints.copy_from(space.scalar_constraints());
    for (unsigned int n = 0; n < space.dependences().n_nodes(); ++n)
      if (is_open.local_element(n) > 0. &&
          open.can_store_line(layout.local_to_global(n)))
        open.add_line(layout.local_to_global(n));
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

    const unsigned int                           m = space.n_nodes_per_cell();
    dealii::FullMatrix<double>                   local(m, m);
    std::vector<dealii::types::global_dof_index> indices(m);
    const auto &L = operators.pressure_stiffness;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        for (unsigned int i = 0; i < m; ++i)
          {
            indices[i] = layout.local_to_global(space.nodes(c)[i]);
            for (unsigned int j = 0; j < m; ++j)
              local(i, j) = L.matrix(L.shape(c))[i * m + j];
          }
        constraints.distribute_local_to_global(local, indices, *matrix);
      }
    matrix->compress(dealii::VectorOperation::add);
    if (singular)
      {
        // One raised diagonal entry fixes the constant: compatible right
        // hand sides are solved exactly.
        if (dealii::Utilities::MPI::this_mpi_process(dofs.get_communicator()) ==
            0)
          for (unsigned int n = 0;
               n < space.n_owned_nodes() && pinned_value == 0.;
               ++n)
            if (!space.is_dependent(n))
              {
                const auto index = layout.local_to_global(n);
                pinned_node      = n;
                pinned_value     = matrix->diag_element(index);
                matrix->add(index, index, pinned_value);
              }
        matrix->compress(dealii::VectorOperation::add);
      }
    // Incomplete factors break down where degree and stretched cells make
    // for large positive entries, on whichever rank.
    using Smoother = AmgPreconditioner::Smoother;
    const int is_harmless =
      space.degree() == 1 && space.mesh().graph().all_axis_parallel();
    amg.build(*matrix,
              dealii::Utilities::MPI::min(is_harmless,
                                          dofs.get_communicator()) == 1
                ? Smoother::incomplete_cholesky
                : Smoother::chebyshev);
  }



  template <int dim>
  void
  PressurePoisson<dim>::vmult(Vector &destination, const Vector &source) const
  {
    const auto &space = operators.pressure_space;
    work.copy_locally_owned_data_from(source);
    boundary.project_open(work);
    space.interpolate(work, 1);
    destination = 0.;
    operators.pressure_stiffness.add_product(work, destination, 1, 1., factors);
    space.fold(destination, 1);
    for (const Dependence &entry : space.dependences().all())
      if (entry.node < space.n_owned_nodes())
        destination.local_element(entry.node) =
          source.local_element(entry.node);
    if (pinned_value > 0.)
      destination.local_element(pinned_node) +=
        pinned_value * work.local_element(pinned_node);
    boundary.project_open(destination);
  }



  template <int dim>
  SolveReport
  PressurePoisson<dim>::solve(Vector                    &x,
                              Vector                    &b,
                              const std::vector<double> &cell_factors,
                              const double               tolerance,
                              const unsigned int         maximum)
  {
    const auto &space = operators.pressure_space;
    factors           = cell_factors.data();
    boundary.project_open(b);
    if (singular)
      {
        // What the boundary values pass in and out may not balance exactly.
        const double surplus = mean(b);
        for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
          if (!space.is_dependent(n))
            b.local_element(n) -= surplus;
      }
    x = 0.;
    SolveReport report;
    if (b.l2_norm() > tolerance)
      report = solve_cg(*this, x, b, amg, tolerance, maximum, "pressure");
    space.interpolate(x, 1);
    return report;
  }



  template <int dim>
  double
  PressurePoisson<dim>::mean(const Vector &values) const
  {
    const auto &space  = operators.pressure_space;
    double      sum[2] = {0., 0.};
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      if (!space.is_dependent(n))
        {
          sum[0] += values.local_element(n);
          sum[1] += 1.;
        }
    dealii::Utilities::MPI::sum(sum, space.scalar().get_communicator(), sum);
    return sum[0] / sum[1];
  }



  template <int dim>
  void
  PressurePoisson<dim>::normalize(Vector &pressure) const
  {
    if (!singular)
      return;
    const double constant = mean(pressure);
    pressure.zero_out_ghost_values();
    pressure.add(-constant);
    operators.pressure_space.interpolate(pressure, 1);
  }



  THALWEG_INSTANTIATE(PressurePoisson)
} // namespace Thalweg
