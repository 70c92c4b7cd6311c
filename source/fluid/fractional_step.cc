// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/turn_nodes.h>
#include <thalweg/fluid/fractional_step.h>

namespace Thalweg
{
  template <int dim>
  void
  FractionalStep<dim>::declare_parameters(const Section &section)
  {
    section.add("Iterations",
                iterations,
                "",
                "At most so many repetitions of the steps C to E (Eq. 87), "
                "which find the pressure that friction asks for.",
                dealii::Patterns::Integer(0, 1000));
    section.add("Iteration tolerance",
                iteration_tolerance,
                "",
                "The repetitions end when the velocity changes by less than "
                "this part of itself.",
                dealii::Patterns::Double(0));
    section.add("Pressure tolerance",
                pressure_tolerance,
                "",
                "Residual of the pressure equation relative to its right hand "
                "side.",
                dealii::Patterns::Double(0, 1));
    section.add("Velocity tolerance",
                velocity_tolerance,
                "",
                "Residual of the viscous equation relative to the momentum of "
                "the flow over the time step.",
                dealii::Patterns::Double(0, 1));
    this->declare_common_parameters(section);
  }



  template <int dim>
  void
  FractionalStep<dim>::initialize(const FlowSetup<dim> &setup)
  {
    EnrichedFlow<dim>::initialize(setup);
    Thalweg::initialize(*space, dp);
    space->initialize_velocity(before_friction);
  }



  template <int dim>
  void
  FractionalStep<dim>::accelerate(const EnrichedPressure &pressure,
                                  const bool              with_forces,
                                  const double            duration)
  {
    pressure_system->accelerate(pressure, with_forces, *mass, force);
    if (forces->is_rotating())
      turn_nodes<dim>(deflection, force);
    this->advance(force, duration);
  }



  template <int dim>
  bool
  FractionalStep<dim>::predict(const double dt)
  {
    force = 0.;
    viscous->subtract_viscous_force(v, force);
    space->fold(force, dim);
    boundary->project(force);
    if (force.linfty_norm() == 0.)
      return false;
    const Vector &masses = mass->lumped();
    viscous->update(masses, dt);
    change.zero_out_ghost_values();
    double momentum = 0;
    for (unsigned int n = 0; n < masses.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        momentum +=
          std::pow(masses.local_element(n) / dt * v.local_element(dim * n + d),
                   2);
    momentum =
      std::sqrt(dealii::Utilities::MPI::sum(momentum, context->communicator));
    change = 0.;
    const SolveReport report =
      solve_cg(*viscous,
               change,
               force,
               viscous->jacobi(),
               velocity_tolerance * std::max(momentum, force.l2_norm()),
               maximal_iterations,
               "viscous predictor");
    context->statistics.add("viscous iterations", report.iterations);
    this->advance(change, 1.);
    return true;
  }



  template <int dim>
  void
  FractionalStep<dim>::balance_forces(const Vector &rate, const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "pressure");
    if (forces->is_rotating())
      pressure_system->add_acceleration(1., deflected);
    const SolveReport report = pressure_system->correct(
      rate, true, p, pressure_tolerance, maximal_iterations);
    if (forces->is_rotating())
      pressure_system->add_acceleration(-1., deflected);
    context->statistics.add("pressure iterations", report.iterations);
    context->statistics.set("pressure residual", report.residual);
    accelerate(p, true, duration);
  }



  template <int dim>
  void
  FractionalStep<dim>::correct_pressure(const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "pressure");
    auto                      &statistics = context->statistics;
    unsigned int               i          = 0;
    double                     difference = 1.;
    for (; i < iterations && difference > iteration_tolerance; ++i)
      {
        dp.zero_out_ghost_values();
        dp = 0.;
        change.copy_locally_owned_data_from(v);
        change.add(-1., before_friction);
        change *= 1. / duration;
        space->interpolate(change, dim);
        const SolveReport report =
          pressure_system->correct(change,
                                   false,
                                   dp,
                                   pressure_tolerance,
                                   maximal_iterations); // (87c,d)
        statistics.add("pressure iterations", report.iterations);
        if (report.iterations == 0)
          break;
        change.copy_locally_owned_data_from(v);
        accelerate(dp, false, duration); // (87e)
        change.zero_out_ghost_values();
        change.add(-1., v);
        const double norm = v.l2_norm();
        difference        = norm > 0 ? change.l2_norm() / norm : 0.;
        add(*space, dp, p);
      }
    statistics.set("fractional step iterations", i);
    statistics.set("velocity change", i == 0 ? 0. : difference);
  }



  template <int dim>
  void
  FractionalStep<dim>::solve(const Vector &velocity_star,
                             const Vector &rate,
                             const Vector &lead,
                             const double  duration)
  {
    for (const char *column : {"pressure iterations",
                               "viscous iterations",
                               "fractional step iterations",
                               "velocity change"})
      context->statistics.set(column, 0);
    this->begin(velocity_star, lead, duration);
    balance_forces(rate, duration);
    budget->record("forces and pressure", v);
    before_friction.copy_locally_owned_data_from(v);
    bool has_friction = false;
    {
      dealii::TimerOutput::Scope scope(context->timers, "viscosity");
      has_friction = predict(duration); // (87b)
    }
    budget->record("viscosity", v);
    if (has_friction)
      correct_pressure(duration);
    budget->record("pressure of friction", v);
    this->finish_pressure();
    this->remove_divergence(lead);
    budget->record("divergence", v);
  }



  THALWEG_INSTANTIATE(FractionalStep)
  THALWEG_REGISTER(FluidSolver,
                   FractionalStep,
                   "fractional step",
                   "viscous predictor and enriched pressure correction, "
                   "repeated (Eq. 87)")
} // namespace Thalweg
