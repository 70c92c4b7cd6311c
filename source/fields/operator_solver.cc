// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/operator_solver.h>

#include <deal.II/lac/diagonal_matrix.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  OperatorSolver<dim>::OperatorSolver(const CellOperator<dim> &A,
                                      const unsigned int       n_components,
                                      const Projector         &project,
                                      const double *const      cell_factors)
    : A(A)
    , n_components(n_components)
    , project(project)
    , cell_factors(cell_factors)
  {
    A.space().initialize(work, n_components);
    A.space().initialize(inverse_diagonal, n_components);
    A.add_diagonal(inverse_diagonal, n_components, cell_factors);
    A.space().fold(inverse_diagonal, n_components);
    for (unsigned int n = 0; n < A.space().n_owned_nodes(); ++n)
      for (unsigned int d = 0; d < n_components; ++d)
        {
          double &entry = inverse_diagonal.local_element(n * n_components + d);
          entry = A.space().is_dependent(n) || entry <= 0. ? 1. : 1. / entry;
        }
  }



  template <int dim>
  void
  OperatorSolver<dim>::vmult(Vector &destination, const Vector &source) const
  {
    const auto &space = A.space();
    work.copy_locally_owned_data_from(source);
    if (project)
      project(work);
    space.interpolate(work, n_components);
    destination = 0.;
    A.add_product(work, destination, n_components, 1., cell_factors);
    space.fold(destination, n_components);
    for (const Dependence &entry : space.dependences().all())
      if (entry.node < space.n_owned_nodes())
        for (unsigned int d = 0; d < n_components; ++d)
          destination.local_element(entry.node * n_components + d) =
            source.local_element(entry.node * n_components + d);
    if (project)
      project(destination);
  }



  template <int dim>
  void
  OperatorSolver<dim>::multiply(Vector &vector) const
  {
    work.copy_locally_owned_data_from(vector);
    A.space().interpolate(work, n_components);
    vector = 0.;
    A.add_product(work, vector, n_components, 1., cell_factors);
    A.space().fold(vector, n_components);
  }



  template <int dim>
  SolveReport
  OperatorSolver<dim>::solve(Vector            &x,
                             Vector            &b,
                             const double       tolerance,
                             const unsigned int maximum,
                             const std::string &what,
                             const double       reference) const
  {
    if (project)
      {
        project(b);
        project(x);
      }
    for (const Dependence &entry : A.space().dependences().all())
      if (entry.node < A.space().n_owned_nodes())
        for (unsigned int d = 0; d < n_components; ++d)
          x.local_element(entry.node * n_components + d) = 0.;
    SolveReport  report;
    const double norm = std::max(b.l2_norm(), reference);
    x.zero_out_ghost_values();
    if (norm > 0.)
      report = solve_cg(*this,
                        x,
                        b,
                        dealii::DiagonalMatrix<Vector>(inverse_diagonal),
                        tolerance * norm,
                        maximum,
                        what);
    else
      x = 0.;
    A.space().interpolate(x, n_components);
    return report;
  }



  THALWEG_INSTANTIATE(OperatorSolver)
} // namespace Thalweg
