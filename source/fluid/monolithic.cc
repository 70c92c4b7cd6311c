// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/monolithic.h>

#include <deal.II/lac/solver_gmres.h>

#include <algorithm>

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
    section.add("Linearization",
                linearization,
                "",
                "How viscosities that depend on the shear rate are found: "
                "repeatedly from the last velocity (`picard`), or by `newton` "
                "with a search along its direction.",
                dealii::Patterns::Selection("picard|newton"));
    section.add("Nonlinear tolerance",
                nonlinear_tolerance,
                "",
                "The same where viscosities depend on the shear rate.",
                dealii::Patterns::Double(0.));
    section.add("Nonlinear iterations",
                nonlinear_iterations,
                "",
                "At most so many repetitions for such viscosities.",
                dealii::Patterns::Integer(1));
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
    const CoupledParts<dim> parts{*space,
                                  *boundary,
                                  *phase,
                                  *forces,
                                  *mass,
                                  *pressure_system,
                                  *viscous,
                                  *shear};
    velocity_block->initialize(*space, *boundary, *viscous);
    system = std::make_unique<CoupledSystem<dim>>(parts, *stabilization);
    preconditioner = std::make_unique<BlockPreconditioner<dim>>(parts,
                                                                *system,
                                                                *velocity_block,
                                                                *schur_block);
    schur_block->initialize({*space,
                             *phase,
                             *pressure_system,
                             *viscous,
                             system->stabilization_times()});
    initialize_coupled(*space, residual);
    initialize_coupled(*space, increment);
    for (Vector *vector : {&whole_rate, &lead_, &start, &difference})
      space->initialize_velocity(*vector);
  }



  template <int dim>
  void
  Monolithic<dim>::begin_step(const Vector &rate,
                              const Vector &lead,
                              const double  duration)
  {
    whole_rate.zero_out_ghost_values();
    whole_rate.copy_locally_owned_data_from(rate);
    if (forces->is_rotating())
      whole_rate.add(1., deflected);
    lead_.zero_out_ghost_values();
    lead_.copy_locally_owned_data_from(lead);
    start.zero_out_ghost_values();
    start.copy_locally_owned_data_from(v);
    for (Vector *vector : {&whole_rate, &lead_, &start})
      space->interpolate(*vector, dim);

    EnrichedPressure given;
    Thalweg::initialize(*space, given);
    pressure_system->apply_open_boundary(nodal(given));
    space->interpolate(nodal(given), 1);
    fourier_number = system->update(duration, theta, deflection);
    system->find_scales(start, given);
  }



  template <int dim>
  void
  Monolithic<dim>::update_blocks(const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "assembly");
    viscous->update(mass->lumped(), theta * duration);
    const unsigned int before = velocity_block->n_setups();
    velocity_block->update(fourier_number);
    context->statistics.add("velocity set-ups",
                            velocity_block->n_setups() - before);
    schur_block->update(1. / duration, theta);
  }



  template <int dim>
  double
  Monolithic<dim>::find_residual()
  {
    difference.zero_out_ghost_values();
    difference.copy_locally_owned_data_from(v);
    difference.add(-1., start);
    if (shear->depend_on_shear())
      {
        Vector middle(start);
        middle.add(theta, difference);
        space->interpolate(middle, dim);
        shear->update(middle, /*with_cut_cells=*/false);
      }
    space->interpolate(difference, dim);
    system->find_residual(start, whole_rate, lead_, difference, p, residual);
    return residual.l2_norm();
  }



  template <int dim>
  void
  Monolithic<dim>::find_direction(const double norm)
  {
    // More exactly, the next linearization would not be better.
    constexpr double forcing          = 1e-2;
    const double     linear_tolerance = std::max(tolerance, forcing * norm);
    if (linearization == "newton")
      try
        {
          system->set_tangent(1.);
          solve_linear(linear_tolerance,
                       std::min(patience_with_newton, maximal_iterations));
          return;
        }
      catch (const StepFailure &)
        {
          // The blocks know nothing of the tangent.
        }
    system->set_tangent(0.);
    solve_linear(linear_tolerance, maximal_iterations);
  }



  template <int dim>
  void
  Monolithic<dim>::solve_linear(const double       linear_tolerance,
                                const unsigned int maximum)
  {
    increment = 0.;
    const SolveReport report =
      run_solver(linear_tolerance,
                 maximum,
                 "coupled flow",
                 [this](dealii::SolverControl &control) {
                   using Solver = dealii::SolverFGMRES<CoupledFlow>;
                   Solver(control, typename Solver::AdditionalData(basis_size))
                     .solve(*system, increment, residual, *preconditioner);
                 });
    context->statistics.add("coupled iterations", report.iterations);
    context->statistics.set("coupled residual", report.residual);
  }



  template <int dim>
  void
  Monolithic<dim>::add_increment(const double part)
  {
    EnrichedPressure change;
    Thalweg::initialize(*space, change);
    get_pressure(increment, change);
    change *= part;
    this->advance(Thalweg::velocity(increment), part);
    add(*space, change, p);
  }



  template <int dim>
  double
  Monolithic<dim>::search_along_increment(const double before)
  {
    constexpr unsigned int n_halvings = 5;
    add_increment(1.);
    double norm = find_residual();
    double part = 1.;
    for (unsigned int i = 0; i < n_halvings && !(norm < before); ++i)
      {
        part *= .5;
        add_increment(-part);
        norm = find_residual();
      }
    return norm;
  }



  template <int dim>
  void
  Monolithic<dim>::solve_nonlinear(const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "coupled flow");
    const bool                 is_linear = !shear->depend_on_shear();
    double                     norm      = find_residual();
    unsigned int               i         = 0;
    while (i == 0 || (i < nonlinear_iterations && norm > nonlinear_tolerance))
      {
        update_blocks(duration);
        ++i;
        if (is_linear)
          {
            solve_linear(tolerance, maximal_iterations);
            add_increment(1.);
            return;
          }
        find_direction(norm);
        norm = search_along_increment(norm);
      }
    context->statistics.set("rheology iterations", i);
    context->statistics.set("rheology residual", norm);
    if (norm > nonlinear_tolerance && !has_warned)
      {
        has_warned = true;
        context->log.warning(
          "The viscosities that depend on the shear rate are not found: "
          "after " +
          std::to_string(i) + " iterations the residual is " +
          std::to_string(norm) +
          ". See 'rheology residual' in the statistics; shorter steps, a "
          "smaller 'Growth time' or more 'Nonlinear iterations' help. This is "
          "said once.");
      }
  }



  template <int dim>
  void
  Monolithic<dim>::solve(const Vector &velocity_star,
                         const Vector &rate,
                         const Vector &lead,
                         const double  duration)
  {
    for (const char *column : {"coupled iterations", "velocity set-ups"})
      context->statistics.set(column, 0);
    this->begin(velocity_star, lead, duration);
    begin_step(rate, lead, duration);
    solve_nonlinear(duration);
    budget->record("flow", v);
    this->finish_pressure();
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
