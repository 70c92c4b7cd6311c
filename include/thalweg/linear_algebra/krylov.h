// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_krylov_h
#define thalweg_linear_algebra_krylov_h

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace Thalweg
{
  /// A linear or time-step solver did not converge; the step may be repeated
  /// with half the size.
  class SolverFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// What a solve cost, and how well it went.
  struct SolveReport
  {
    unsigned int iterations = 0;
    double       residual   = 0.;
  };

  /**
   * @brief Solves A x = b by conjugate gradients, or throws.
   * @param x initial guess and solution
   * @param tolerance for the norm of the residual
   * @param maximum of iterations
   * @param what is solved for, for the message
   * @throws SolverFailure
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
    // An infinite tolerance would be met by anything.
    if (!std::isfinite(tolerance))
      throw SolverFailure("The linear solver for the " + what +
                          " cannot begin: its right-hand side is no finite "
                          "number.");
    dealii::SolverControl    control(maximum, tolerance);
    dealii::SolverCG<Vector> cg(control);
    try
      {
        cg.solve(A, x, b, preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &failure)
      {
        std::ostringstream message;
        message << "The linear solver for the " << what
                << " did not converge: after " << failure.last_step
                << " iterations the residual is " << failure.last_residual
                << " instead of " << tolerance << ".";
        throw SolverFailure(message.str());
      }
    return {control.last_step(), control.last_value()};
  }
} // namespace Thalweg

#endif
