// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_fluid_solver_h
#define thalweg_fluid_fluid_solver_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/state.h>
#include <thalweg/fluid/flow_setup.h>

namespace Thalweg
{
  /**
   * @brief What remains of the flow equations on the mesh when particles
   * have done the convection: linear, and registered under "Fluid solver".
   */
  template <int dim>
  class FluidSolver
  {
  public:
    virtual ~FluidSolver() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Whether the pressure may have a jump at the interface.
    virtual bool
    takes_jumps() const
    {
      return false;
    }

    /// Sets up for the present mesh, with zero fields; once for each mesh. What
    /// it refers to must outlive the solver, or its next initialize().
    virtual void
    initialize(const FlowSetup<dim> &setup) = 0;

    /**
     * @brief From the convected velocity to that at the end of the step.
     * @param velocity_star projected from the particles, ghosted, m/s
     * @param rate at which the projected velocity has changed by the
     *   particles' motion, in agreement with the boundary conditions: ghosted,
     *   m/s^2. The pressure answers to this, not to what velocity_star is in
     *   all, in which the errors of the projection do not become less as
     *   steps do.
     * @param lead what the velocity at the end will have changed by when
     *   particles follow it, ghosted, m/s: the sum of both lets as much fluid
     *   into each cell as out of it
     * @param duration of the acceleration, s
     * @throws StepFailure
     */
    virtual void
    solve(const Vector &velocity_star,
          const Vector &rate,
          const Vector &lead,
          const double  duration) = 0;

    /// Names what the next step starts from.
    virtual void
    keep(const State<dim> &state) = 0;

    /// V^{n+1}, ghosted, m/s.
    virtual Vector &
    velocity() = 0;

    /// p^{n+1} at the nodes, ghosted, Pa.
    virtual Vector &
    pressure() = 0;
  };
} // namespace Thalweg

#endif
