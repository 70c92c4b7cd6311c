// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_fractional_step_h
#define thalweg_fluid_fractional_step_h

#include <thalweg/fluid/cell_projection.h>
#include <thalweg/fluid/fluid_solver.h>
#include <thalweg/fluid/kinetic_budget.h>
#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/fluid/pressure_system.h>
#include <thalweg/fluid/viscous_operator.h>

namespace Thalweg
{
  /**
   * @brief The fractional step for one or two fluids (Eq. 87) with equal
   * order Q1 velocity and enriched Q1 pressure.
   *
   * The pressure of the convection and the body forces is found first, so
   * that the viscous predictor sees balanced forces (fluids at rest stay at
   * rest, and a steady viscous flow has no splitting error); then the pressure
   * that friction asks for, repeated until the velocity no longer changes. At
   * last the velocity is made free of divergence, cell by cell.
   */
  template <int dim>
  class FractionalStep : public FluidSolver<dim>
  {
  public:
    void
    declare_parameters(const Section &section) override;

    void
    initialize(const FlowSetup<dim> &setup) override;

    void
    solve(const Vector &velocity_star,
          const Vector &rate,
          const Vector &lead,
          const double  duration) override;

    void
    keep(const State<dim> &state) override
    {
      state.field("velocity", *space, v, dim);
      state.field("pressure", *space, nodal(p), 1);
    }

    Vector &
    velocity() override
    {
      return v;
    }

    Vector &
    pressure() override
    {
      return nodal(p);
    }

  private:
    /// v += duration M^{-1} (forces - int N grad p), then boundary values.
    void
    accelerate(const EnrichedPressure &pressure,
               const bool              with_forces,
               const double            duration);

    /// What acts besides the body forces.
    void
    add_terms();

    /// Adds int N_i f of the force density to @ref force.
    void
    add_force_density();

    /**
     * The pressure at open boundaries. Where fluid comes in it has been at rest
     * outside and comes in along the normal, so that what is given is its
     * total pressure, and rho (V.n)^2 / 2 is spent on its velocity. Without
     * this a flow that turns round at an open side gets its energy anew each
     * time, and air above a splash is blown up to any velocity.
     */
    void
    apply_open_boundary();

    /// The pressure of @p rate and the body forces, and v with it.
    void
    balance_forces(const Vector &rate, const double duration);

    /// Multiplies the owned nodes' vectors by a matrix.
    void
    turn(const dealii::Tensor<2, dim> &matrix, Vector &vector) const;

    /**
     * In a tank that turns, V^{n+1} = V* + dt (a - Omega x (V^n + V^{n+1})),
     * with both velocities of the mesh: V* has come from elsewhere, and
     * against V^{n+1} it has what the pressure is to take away. So
     * V^{n+1} = D (V* - dt Omega x V^n) + D dt a, D = (1 + dt Omega x)^{-1}.
     * This makes the first term in place of V*, which is in v, with V^n and
     * the leads of both in @ref change, lets the pressure balance the
     * difference as it does forces, and makes D for accelerate().
     */
    void
    deflect(const Vector &lead, const double duration);

    /// (87b): v += (M/dt + K)^{-1} (-K v)
    /// @return whether friction changes anything
    bool
    predict(const double dt);

    /// (87c) to (87e): the pressure that takes the divergence out of what
    /// friction has changed.
    void
    correct_pressure(const double duration);

    /// Makes v + @p lead free of divergence.
    void
    remove_divergence(const Vector &lead);

    /// Ends the step: removes the constant of the pressure where it is free.
    void
    normalize_pressure();

    unsigned int iterations            = 4;
    double       iteration_tolerance   = 1e-4;
    double       pressure_tolerance    = 1e-8;
    double       divergence_tolerance  = 1e-2;
    double       velocity_tolerance    = 1e-8;
    unsigned int maximal_cg_iterations = 1000;

    Context                              *context  = nullptr;
    const NodeSpace<dim>                 *space    = nullptr;
    const BoundaryNodes<dim>             *boundary = nullptr;
    const PhaseField<dim>                *phase    = nullptr;
    const BodyForces<dim>                *forces   = nullptr;
    const FlowTerms<dim>                 *terms    = nullptr;
    Q1Integrals<dim>                      integrals;
    std::unique_ptr<NodalMass<dim>>       mass;
    std::unique_ptr<PressureSystem<dim>>  pressure_system;
    std::unique_ptr<CellProjection<dim>>  cell_projection;
    std::unique_ptr<KineticBudget<dim>>   budget;
    std::unique_ptr<ViscousOperator<dim>> viscous;
    dealii::Tensor<2, dim>                deflection; ///< D of deflect()
    Vector                                force;
    Vector                                change;
    Vector                                before_friction;
    Vector                                deflected; ///< m/s^2
    Vector                                v;
    EnrichedPressure                      p;
    EnrichedPressure                      dp;
  };
} // namespace Thalweg

#endif
