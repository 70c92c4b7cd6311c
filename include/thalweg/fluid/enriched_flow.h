// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_enriched_flow_h
#define thalweg_fluid_enriched_flow_h

#include <thalweg/fluid/cell_projection.h>
#include <thalweg/fluid/fluid_solver.h>
#include <thalweg/fluid/kinetic_budget.h>
#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/fluid/pressure_system.h>
#include <thalweg/fluid/shear_viscosities.h>
#include <thalweg/fluid/viscous_operator.h>

namespace Thalweg
{
  /**
   * @brief What solvers have in common that find an equal order Q1 velocity
   * and an enriched Q1 pressure of one or two fluids: fields, operators, forces
   * and conditions. They differ in how both are found.
   */
  template <int dim>
  class EnrichedFlow : public FluidSolver<dim>
  {
  public:
    void
    initialize(const FlowSetup<dim> &setup) override;

    void
    keep(const State<dim> &state) override
    {
      state.field("velocity", *space, v, dim);
      state.field("pressure", *space, nodal(p), 1);
      if (has_hidden_pressure())
        state.field("whole pressure", *space, whole_pressure, 1);
    }

    Vector &
    velocity() override
    {
      return v;
    }

    Vector &
    pressure() override
    {
      return has_hidden_pressure() ? whole_pressure : nodal(p);
    }

  protected:
    /// Declares what all of these solvers have.
    void
    declare_common_parameters(const Section &section);

    /**
     * @brief Reads the present phases and forces, lets viscosities that depend
     * on the shear rate be those of the last velocity, and lets v begin with
     * @p velocity_star, with what turning of the frame and the boundary
     * conditions make of it, and p with the last one.
     */
    void
    begin(const Vector &velocity_star,
          const Vector &lead,
          const double  duration);

    /// v += @p acceleration duration, then boundary values.
    void
    advance(const Vector &acceleration, const double duration);

    /// Sets fixed components to their values; v is ghosted and consistent.
    void
    apply_boundary();

    /**
     * The pressure at open boundaries. Where fluid comes in it has been at rest
     * outside and comes in along the normal, so that what is given is its
     * total pressure, and rho (V.n)^2 / 2 is spent on its velocity. Without
     * this a flow that turns round at an open side gets its energy anew each
     * time, and air above a splash is blown up to any velocity.
     */
    void
    apply_open_boundary();

    /// Makes v + @p lead free of divergence.
    void
    remove_divergence(const Vector &lead);

    /// Ends the step: removes the constant of the pressure where it is free,
    /// and adds what surface tension hides.
    void
    finish_pressure();

    double       divergence_tolerance = 1e-2;
    unsigned int maximal_iterations   = 1000;

    Context                               *context  = nullptr;
    const NodeSpace<dim>                  *space    = nullptr;
    const BoundaryNodes<dim>              *boundary = nullptr;
    const PhaseField<dim>                 *phase    = nullptr;
    const BodyForces<dim>                 *forces   = nullptr;
    const FlowTerms<dim>                  *terms    = nullptr;
    InterfaceForce<dim>                   *tension  = nullptr;
    std::unique_ptr<NodalMass<dim>>        mass;
    std::unique_ptr<PressureSystem<dim>>   pressure_system;
    std::unique_ptr<KineticBudget<dim>>    budget;
    std::unique_ptr<ShearViscosities<dim>> shear;
    std::unique_ptr<ViscousOperator<dim>>  viscous;
    dealii::Tensor<2, dim>                 deflection; ///< D of deflect()
    Vector                                 force;
    Vector                                 change;
    Vector                                 deflected; ///< m/s^2
    Vector                                 v;
    EnrichedPressure                       p;

  private:
    /// Whether pressure() is not that of the equations.
    bool
    has_hidden_pressure() const
    {
      return tension != nullptr && tension->hides_pressure();
    }

    void
    normalize_pressure();

    /// What acts besides the body forces.
    void
    add_terms();

    /**
     * In a tank that turns, V^{n+1} = V* + dt (a - Omega x (V^n + V^{n+1})),
     * with both velocities of the mesh: V* has come from elsewhere, and
     * against V^{n+1} it has what the pressure is to take away. So
     * V^{n+1} = D (V* - dt Omega x V^n) + D dt a, D = (1 + dt Omega x)^{-1}.
     * This makes the first term in place of V*, which is in v, with V^n and
     * the leads of both in @ref change, lets the pressure balance the
     * difference as it does forces, and makes D.
     */
    void
    deflect(const Vector &lead, const double duration);

    std::unique_ptr<CellProjection<dim>> cell_projection;
    Vector                               whole_pressure;
  };
} // namespace Thalweg

#endif
