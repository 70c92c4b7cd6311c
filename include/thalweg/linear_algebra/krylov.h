// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_krylov_h
#define thalweg_linear_algebra_krylov_h

#include <thalweg/core/errors.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <cmath>
#include <sstream>
#include <string>

namespace Thalweg
{
  /// What a solve cost, and how well it went.
  struct SolveReport
  {
    unsigned int iterations = 0;
    double       residual   = 0.;
  };

  /**
   * @brief Runs a linear solver, or throws.
   * @param tolerance for the norm of the residual
   * @param maximum of iterations
   * @param what is solved for, for the message
   * @param solve takes the control
   * @throws StepFailure
   */
  template <typename Solve>
  SolveReport
  run_solver(const double       tolerance,
             const unsigned int maximum,
             const std::string &what,
             const Solve       &solve)
  {
    // An infinite tolerance would be met by anything.
    if (!std::isfinite(tolerance))
      throw StepFailure("The linear solver for the " + what +
                        " cannot begin: its right-hand side is no finite "
                        "number.");
    dealii::SolverControl control(maximum, tolerance);
    try
      {
        solve(control);
      }
    catch (const dealii::SolverControl::NoConvergence &failure)
      {
        std::ostringstream message;
        message << "The linear solver for the " << what
                << " did not converge: after " << failure.last_step
                << " iterations the residual is " << failure.last_residual
                << " instead of " << tolerance << ".";
        throw StepFailure(message.str());
      }
    return {control.last_step(), control.last_value()};
  }

  /**
   * @brief Solves A x = b by conjugate gradients, or throws.
   * @param x initial guess and solution
   * @param tolerance for the norm of the residual
   * @param maximum of iterations
   * @param what is solved for, for the message
   * @throws StepFailure
   */
  template <typename Matrix, typename Vector, typename Preconditioner>
  SolveReport
  solve_cg(const Matrix         &A,
           Vector               &x,
           const Vector         &b,
           const Preconditioner &preconditioner,
           const double          tolerance,
           const unsigned int    maximum,
           const std::string    &what)
  {
    return run_solver(
      tolerance, maximum, what, [&](dealii::SolverControl &control) {
        dealii::SolverCG<Vector>(control).solve(A, x, b, preconditioner);
      });
  }
} // namespace Thalweg

#endif
