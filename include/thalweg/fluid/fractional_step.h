// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_fractional_step_h
#define thalweg_fluid_fractional_step_h

#include <thalweg/fluid/enriched_flow.h>

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
  class FractionalStep : public EnrichedFlow<dim>
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

  private:
    using EnrichedFlow<dim>::boundary;
    using EnrichedFlow<dim>::budget;
    using EnrichedFlow<dim>::change;
    using EnrichedFlow<dim>::context;
    using EnrichedFlow<dim>::deflected;
    using EnrichedFlow<dim>::deflection;
    using EnrichedFlow<dim>::force;
    using EnrichedFlow<dim>::forces;
    using EnrichedFlow<dim>::mass;
    using EnrichedFlow<dim>::maximal_iterations;
    using EnrichedFlow<dim>::p;
    using EnrichedFlow<dim>::pressure_system;
    using EnrichedFlow<dim>::space;
    using EnrichedFlow<dim>::v;
    using EnrichedFlow<dim>::viscous;

    /// v += duration M^{-1} (forces - int N grad p), then boundary values.
    void
    accelerate(const EnrichedPressure &pressure,
               const bool              with_forces,
               const double            duration);

    /// The pressure of @p rate and the body forces, and v with it.
    void
    balance_forces(const Vector &rate, const double duration);

    /// (87b): v += (M/dt + K)^{-1} (-K v)
    /// @return whether friction changes anything
    bool
    predict(const double dt);

    /// (87c) to (87e): the pressure that takes the divergence out of what
    /// friction has changed.
    void
    correct_pressure(const double duration);

    unsigned int     iterations          = 4;
    double           iteration_tolerance = 1e-4;
    double           pressure_tolerance  = 1e-8;
    double           velocity_tolerance  = 1e-8;
    Vector           before_friction;
    EnrichedPressure dp;
  };
} // namespace Thalweg

#endif
