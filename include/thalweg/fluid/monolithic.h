// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_monolithic_h
#define thalweg_fluid_monolithic_h

#include <thalweg/fluid/block_preconditioner.h>
#include <thalweg/fluid/enriched_flow.h>

namespace Thalweg
{
  /**
   * @brief Velocity and enriched pressure of one or two fluids together
   * (Eq. 88 to 92), for flows in which viscosity may rule: a CoupledSystem,
   * solved by flexible GMRES with a BlockPreconditioner.
   *
   * At last the velocity is made free of divergence, cell by cell, as the
   * fractional step does it.
   */
  template <int dim>
  class Monolithic : public EnrichedFlow<dim>
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
    using EnrichedFlow<dim>::context;
    using EnrichedFlow<dim>::deflected;
    using EnrichedFlow<dim>::deflection;
    using EnrichedFlow<dim>::forces;
    using EnrichedFlow<dim>::mass;
    using EnrichedFlow<dim>::maximal_iterations;
    using EnrichedFlow<dim>::p;
    using EnrichedFlow<dim>::phase;
    using EnrichedFlow<dim>::pressure_system;
    using EnrichedFlow<dim>::space;
    using EnrichedFlow<dim>::v;
    using EnrichedFlow<dim>::viscous;

    /// Sets operators and preconditioners up for the present step.
    void
    update(const double duration);

    /// Finds the increments of velocity and pressure, and adds them.
    void
    solve_coupled(const Vector &rate, const Vector &lead);

    double       tolerance  = 1e-8;
    double       theta      = 1.;
    unsigned int basis_size = 60;

    Choice<CoupledStabilization>              stabilization;
    Choice<VelocityBlock<dim>>                velocity_block;
    Choice<SchurBlock<dim>>                   schur_block;
    std::unique_ptr<CoupledSystem<dim>>       system;
    std::unique_ptr<BlockPreconditioner<dim>> preconditioner;
    CoupledFlow                               residual, increment;
    Vector                                    whole_rate;
  };
} // namespace Thalweg

#endif
