// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_pressure_poisson_h
#define thalweg_fluid_pressure_poisson_h

#include <thalweg/fluid/flow_operators.h>
#include <thalweg/linear_algebra/amg.h>
#include <thalweg/linear_algebra/krylov.h>

#include <memory>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Thalweg
{
  /**
   * @brief The pressure equation of a single fluid, sum_K f_K L_K p = b, with
   * factors f_K of the cells; preconditioned by the multigrid hierarchy of
   * L, which is built once.
   */
  template <int dim>
  class PressurePoisson
  {
  public:
    /// The arguments must outlive the object.
    PressurePoisson(const FlowOperators<dim> &operators,
                    const FlowBoundary<dim>  &boundary);
    ~PressurePoisson();

    /**
     * @param x solution, zero at open boundaries; ghosted and consistent
     * @param b folded; made compatible where the pressure is free
     * @param cell_factors of all owned cells
     * @param tolerance for the norm of the residual
     * @throws StepFailure
     */
    SolveReport
    solve(Vector                    &x,
          Vector                    &b,
          const std::vector<double> &cell_factors,
          const double               tolerance,
          const unsigned int         maximum);

    /// destination = A source, for the solver.
    void
    vmult(Vector &destination, const Vector &source) const;

    /// Takes the mean of the nodal values away where the pressure is free.
    void
    normalize(Vector &pressure) const;

  private:
    void
    assemble();

    /// Of the values at the nodes that do not depend on others. Collective.
    double
    mean(const Vector &values) const;

    const FlowOperators<dim>                               &operators;
    const FlowBoundary<dim>                                &boundary;
    std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> matrix;
    AmgPreconditioner                                       amg;
    /// Whether the pressure is free, and the entry that fixes it on the rank
    /// that owns it.
    bool           singular;
    unsigned int   pinned_node;
    double         pinned_value = 0;
    const double  *factors      = nullptr;
    mutable Vector work;
  };
} // namespace Thalweg

#endif
