// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/monolithic.h>

#include <deal.II/lac/solver_gmres.h>

namespace Thalweg
{
  template <int dim>
  void
  Monolithic<dim>::declare_parameters(const Section &section)
  {
    section.add("Tolerance",
                tolerance,
                "",
                "Residual of both equations relative to what acts in them.",
                dealii::Patterns::Double(0., 1.));
    section.add("Theta",
                theta,
                "",
                "How much of the friction is that of the step's end: 1 damps "
                "whatever a step is too long for, 0.5 is of second order.",
                dealii::Patterns::Double(.5, 1.));
    section.add("Krylov space",
                basis_size,
                "",
                "After so many iterations the solver (flexible GMRES) forgets "
                "their directions, of which it holds two vectors each.",
                dealii::Patterns::Integer(2, 1000));
    this->declare_common_parameters(section);
    stabilization.declare_parameters(section.enter("Stabilization"),
                                     "oss",
                                     "stabilization of the pressure");
    velocity_block.declare_parameters(section.enter("Velocity block"),
                                      "automatic",
                                      "preconditioner of the velocity");
    schur_block.declare_parameters(section.enter("Pressure block"),
                                   "cahouet chabard",
                                   "preconditioner of the pressure");
  }



  template <int dim>
  void
  Monolithic<dim>::initialize(const FlowSetup<dim> &setup)
  {
    EnrichedFlow<dim>::initialize(setup);
    const CoupledParts<dim> parts{
      *space, *boundary, *phase, *forces, *mass, *pressure_system, *viscous};
    velocity_block->initialize(*space, *boundary, *viscous);
    system = std::make_unique<CoupledSystem<dim>>(parts, *stabilization);
    preconditioner = std::make_unique<BlockPreconditioner<dim>>(
      parts, *system, *velocity_block, *schur_block);
    schur_block->initialize({*space,
                             *phase,
                             *pressure_system,
                             *viscous,
                             system->stabilization_times()});
    initialize_coupled(*space, residual);
    initialize_coupled(*space, increment);
    space->initialize_velocity(whole_rate);
  }



  template <int dim>
  void
  Monolithic<dim>::update(const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "assembly");
    const double fourier_number = system->update(duration, theta, deflection);
    viscous->update(mass->lumped(), theta * duration);
    const unsigned int before = velocity_block->n_setups();
    velocity_block->update(fourier_number);
    context->statistics.set("velocity set-ups",
                            velocity_block->n_setups() - before);
    schur_block->update(1. / duration, theta);
  }



  template <int dim>
  void
  Monolithic<dim>::solve_coupled(const Vector &rate, const Vector &lead)
  {
    dealii::TimerOutput::Scope scope(context->timers, "coupled flow");
    EnrichedPressure           given;
    Thalweg::initialize(*space, given);
    pressure_system->apply_open_boundary(nodal(given));
    space->interpolate(nodal(given), 1);
    system->find_scales(v, given);
    system->find_residual(v, rate, lead, p, residual);

    increment = 0.;
    const SolveReport report = run_solver(
      tolerance,
      maximal_iterations,
      "coupled flow",
      [this](dealii::SolverControl &control) {
        using Solver = dealii::SolverFGMRES<CoupledFlow>;
        Solver(control, typename Solver::AdditionalData(basis_size))
          .solve(*system, increment, residual, *preconditioner);
      });
    context->statistics.set("coupled iterations", report.iterations);
    context->statistics.set("coupled residual", report.residual);

    this->advance(Thalweg::velocity(increment), 1.);
    EnrichedPressure change;
    Thalweg::initialize(*space, change);
    get_pressure(increment, change);
    add(*space, change, p);
  }



  template <int dim>
  void
  Monolithic<dim>::solve(const Vector &velocity_star,
                         const Vector &rate,
                         const Vector &lead,
                         const double  duration)
  {
    this->begin(velocity_star, lead, duration);
    whole_rate.zero_out_ghost_values();
    whole_rate.copy_locally_owned_data_from(rate);
    if (forces->is_rotating())
      whole_rate.add(1., deflected);
    space->interpolate(whole_rate, dim);
    update(duration);
    solve_coupled(whole_rate, lead);
    budget->record("flow", v);
    this->normalize_pressure();
    this->remove_divergence(lead);
    budget->record("divergence", v);
  }



  THALWEG_INSTANTIATE(Monolithic)
  THALWEG_REGISTER(FluidSolver,
                   Monolithic,
                   "monolithic",
                   "velocity and enriched pressure together (Eq. 88 to 92), "
                   "for flows in which viscosity rules")
} // namespace Thalweg
