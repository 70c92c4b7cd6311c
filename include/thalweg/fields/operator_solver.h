// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_operator_solver_h
#define thalweg_fields_operator_solver_h

#include <thalweg/fields/cell_operator.h>
#include <thalweg/linear_algebra/krylov.h>

#include <functional>
#include <string>

namespace Thalweg
{
  /**
   * @brief Solves A x = b for a symmetric, positive definite CellOperator by
   * conjugate gradients with the diagonal as preconditioner.
   */
  template <int dim>
  class OperatorSolver
  {
  public:
    /// Removes the components of a vector that are fixed.
    using Projector = std::function<void(Vector &)>;

    /**
     * @param A must outlive the solver and stay as it is
     * @param n_components 1 or dim
     * @param project nothing is fixed where it is empty
     * @param cell_factors factors of the cells' matrices, or nullptr
     */
    OperatorSolver(const CellOperator<dim> &A,
                   const unsigned int       n_components,
                   const Projector         &project      = {},
                   const double *const      cell_factors = nullptr);

    /// destination = P A P source
    void
    vmult(Vector &destination, const Vector &source) const;

    /// @p vector = A @p vector, folded; the fixed components count.
    void
    multiply(Vector &vector) const;

    /**
     * @brief Solves, or throws.
     * @param x initial guess and solution, its fixed components zero or
     *   ignored; ghosted and consistent afterwards
     * @param b folded
     * @param tolerance relative to the norm of b, or to @p reference if this
     *   is greater
     * @param what is solved for, for the message
     * @throws StepFailure
     */
    SolveReport
    solve(Vector            &x,
          Vector            &b,
          const double       tolerance,
          const unsigned int maximum,
          const std::string &what,
          const double       reference = 0.) const;

  private:
    const CellOperator<dim> &A;
    const unsigned int       n_components;
    const Projector          project;
    const double *const      cell_factors;
    Vector                   inverse_diagonal;
    mutable Vector           work;
  };
} // namespace Thalweg

#endif
