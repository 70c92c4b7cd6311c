// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_incremental_step_h
#define thalweg_fluid_incremental_step_h

#include <thalweg/core/context.h>
#include <thalweg/fields/boundary_extension.h>
#include <thalweg/fields/operator_solver.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/fluid/convective_term.h>
#include <thalweg/fluid/flow_operators.h>
#include <thalweg/fluid/pressure_poisson.h>
#include <thalweg/fluid/single_fluid_flow_parameters.h>
#include <thalweg/fluid/stokes_pressure.h>
#include <thalweg/materials/fluids.h>

#include <memory>

namespace Thalweg
{
  /**
   * @brief The mesh stage of PFEM-2 for a single fluid: steps A to C of the
   * incremental fractional step (Eq. 81b to 81d), and the nodal fields of
   * explicit forces (Eq. 77 to 80). Pressures and forces are divided by the
   * density.
   */
  template <int dim>
  class IncrementalStep
  {
  public:
    /// All arguments must outlive the object.
    IncrementalStep(Context                          &context,
                    const FlowOperators<dim>         &operators,
                    const FlowBoundary<dim>          &boundary,
                    const PressureStabilization<dim> &stabilization,
                    const IncrementalStepParameters  &parameters,
                    const double                      kinematic_viscosity);

    /**
     * @brief g: M g = -nu K V + boundary terms (Eq. 78), m/s^2.
     *
     * At slip walls, which have no such terms, its normal component is zero,
     * as on flat ones. Elements of degree 1 do not know second derivatives at
     * boundaries, where this equation then makes g zero: there they have those
     * of the nodes next to them instead.
     */
    void
    viscous_acceleration(const Vector &velocity, Vector &g);

    /**
     * @brief The viscous acceleration as it may be integrated along
     * streamlines at any Fourier number: S g + S (g - S g), where S =
     * (M + theta nu dt K)^{-1} M is what an implicit step makes of a field.
     *
     * It stays below 2 V / (theta dt) and differs from g by
     * (theta nu dt K)^2 g in smooth fields.
     */
    void
    smooth(const Vector &g, const double dt, Vector &smoothed);

    /// pi: M pi = G p (Eq. 79), m/s^2.
    void
    pressure_acceleration(const Vector &pressure, Vector &pi);

    /**
     * @brief The pressure that belongs to a velocity field: that with which
     * its material acceleration keeps it free of divergence,
     *
     * (grad q, grad p) = (grad q, forces - c) - nu <grad q, n x rot V>
     *                    - <q, n . dV_D/dt>,
     *
     * where M c = (N, V . grad V), and friction is that of StokesPressure.
     * Elements of degree 1 damp waves by the square of the cells' size in this
     * equation and in the gradient; what the gradient pi of p misses, (grad q,
     * grad p - pi), corrects p once, and the gradient is of fourth order inside
     * uniform meshes.
     *
     * @param velocity ghosted
     * @param forces body forces, m/s^2, ghosted
     * @param viscous the viscous acceleration, m/s^2, ghosted
     * @param boundary_acceleration nodal, where the velocity is given, else
     *   zero; ghosted
     * @param pressure in: its values at open boundaries, and a guess; out:
     *   ghosted, m^2/s^2
     * @throws StepFailure
     */
    void
    find_pressure(const Vector &velocity,
                  const Vector &forces,
                  const Vector &viscous,
                  const Vector &boundary_acceleration,
                  Vector       &pressure);

    /// What the particles' velocity contains already.
    struct Explicit
    {
      const Vector &pressure;              ///< its gradient, m^2/s^2
      const Vector &pressure_acceleration; ///< the same as nodal field
      /// The viscous acceleration at the end of the step; theta dt times this.
      const Vector &viscous;
      const Vector &forces; ///< b + g for the stabilization
    };

    /**
     * @brief Steps A to C.
     * @param velocity_star projected from the particles, ghosted
     * @param given what it contains
     * @param stabilized whether to stabilize the pressure
     * @param dt s
     * @param velocity out: V^{n+1}, ghosted
     * @param pressure out: p^{n+1/2}, ghosted; must not be that in @p given
     * @throws StepFailure
     */
    void
    solve(const Vector   &velocity_star,
          const Explicit &given,
          const bool      stabilized,
          const double    dt,
          Vector         &velocity,
          Vector         &pressure);

    /**
     * @brief From now on solve() and remove_divergence() leave @p part of the
     * divergence that @p velocity has, that of the step's beginning.
     *
     * A projection with an assembled Laplacian leaves some divergence, of
     * which the next step takes out another part, whatever its size. A step
     * that is short beside others must not: many of them would change the
     * flow, and one alone the forces, which are momentum over time.
     */
    void
    keep_divergence(const Vector &velocity, const double part);

    /**
     * @brief Takes from a velocity the gradient that holds its divergence, as
     * far as the pressures of the operators see it. Pressures do not change.
     * @param velocity ghosted
     * @throws StepFailure
     */
    void
    remove_divergence(Vector &velocity);

  private:
    /// Makes M + theta nu dt K anew when dt has changed.
    void
    update_implicit(const double dt);

    /// What g is, by the lumped mass, at the nodes of boundaries where the
    /// velocity is given; g: M g = load, @p g without its values there.
    void
    extend_to_boundary(Vector &g);

    /// smoothed = S field, from a guess; both may be the same vector.
    void
    smooth_once(const Vector &field, Vector &smoothed);

    /// Corrects the pressure by what its nodal gradient misses.
    void
    sharpen_pressure(const double tolerance, Vector &pressure);

    /// pressure += L^{-1} pressure_load
    void
    add_to_pressure(const double tolerance, Vector &pressure);

    /// tau of each cell, and tau / dt + 1 for the operator of the pressure.
    void
    find_stabilization(const Vector &velocity,
                       const bool    stabilized,
                       const double  dt);

    /// solution = A^{-1} load.
    SolveReport
    solve(const OperatorSolver<dim> &solver,
          Vector                    &solution,
          const std::string         &what,
          const double               reference = 0.);

    void
    predict(const Vector   &velocity_star,
            const Explicit &given,
            const double    dt,
            const Vector   &pressure,
            Vector         &velocity);

    /// increment = L^{-1} right_hand_side, where L has the factors of the
    /// cells.
    SolveReport
    solve_poisson(Vector &right_hand_side, const double tolerance);

    /// divergence = D velocity less what is kept, folded.
    void
    find_divergence(const Vector &velocity);

    /// velocity -= M^{-1} G increment
    void
    subtract_gradient(Vector &velocity);

    void
    correct(const Explicit &given,
            const double    dt,
            Vector         &velocity,
            Vector         &pressure);

    Context                          &context;
    const FlowOperators<dim>         &operators;
    const FlowBoundary<dim>          &boundary;
    const PressureStabilization<dim> &stabilization;
    const IncrementalStepParameters  &parameters;
    const double                      nu;

    OperatorSolver<dim>                  mass;       ///< nothing is fixed
    OperatorSolver<dim>                  slip_mass;  ///< normals at slip walls
    OperatorSolver<dim>                  fixed_mass; ///< with fixed nodes
    OperatorSolver<dim>                  pressure_mass;
    BoundaryExtension<dim>               extension;
    Vector                               lumped_mass; ///< M 1
    PressurePoisson<dim>                 poisson;
    ConvectiveTerm<dim>                  convection;
    StokesPressure<dim>                  stokes;
    double                               implicit_dt = -1.;
    CellOperator<dim>                    implicit_matrix;
    std::unique_ptr<OperatorSolver<dim>> implicit;
    std::unique_ptr<OperatorSolver<dim>> fixed_implicit;
    bool                                 is_stabilized = false;
    std::vector<double>                  tau;
    std::vector<double>                  factors;
    Vector                               load;
    Vector                               change;
    Vector                               pressure_load;
    Vector                               increment;
    Vector                               divergence;
    Vector                               kept_divergence;
    bool                                 keeps_divergence = false;
  };
} // namespace Thalweg

#endif
