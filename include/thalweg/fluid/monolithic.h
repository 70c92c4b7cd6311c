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

    bool
    takes_jumps() const override
    {
      return true;
    }

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
    using EnrichedFlow<dim>::shear;
    using EnrichedFlow<dim>::space;
    using EnrichedFlow<dim>::v;
    using EnrichedFlow<dim>::viscous;

    /// Reads what convection and forces are, and how large.
    void
    begin_step(const Vector &rate, const Vector &lead, const double duration);

    /// Sets operator and preconditioners up for the present viscosities.
    void
    update_blocks(const double duration);

    /// Lets the viscosities be those of v, and finds what the equations lack.
    /// @return its norm
    double
    find_residual();

    /// After so many iterations Newton's method is left for a repetition.
    static constexpr unsigned int patience_with_newton = 150;

    /// Finds the direction in which the residual of this norm becomes less.
    void
    find_direction(const double norm);

    /// Finds increments that make up for the residual.
    void
    solve_linear(const double linear_tolerance, const unsigned int maximum);

    /// Adds a part of the increments to velocity and pressure.
    void
    add_increment(const double part);

    /// Adds as much of the increments as lets the residual become less.
    /// @return the residual's norm
    double
    search_along_increment(const double before);

    /// Repeats all that while the viscosities change.
    void
    solve_nonlinear(const double duration);

    double       tolerance            = 1e-8;
    double       theta                = 1.;
    unsigned int basis_size           = 60;
    std::string  linearization        = "newton";
    double       nonlinear_tolerance  = 1e-6;
    unsigned int nonlinear_iterations = 30;

    Choice<CoupledStabilization>              stabilization;
    Choice<VelocityBlock<dim>>                velocity_block;
    Choice<SchurBlock<dim>>                   schur_block;
    std::unique_ptr<CoupledSystem<dim>>       system;
    std::unique_ptr<BlockPreconditioner<dim>> preconditioner;
    CoupledFlow                               residual, increment;
    /// The rate with what turning of the frame makes, the lead, the velocity
    /// that the step begins with, and what it has changed by so far.
    Vector whole_rate, lead_, start, difference;
    double fourier_number = 0.;
    bool   has_warned     = false;
  };
} // namespace Thalweg

#endif
