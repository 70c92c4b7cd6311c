// SPDX-License-Identifier: LGPL-2.1-or-later
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
    section.add("Divergence tolerance",
                divergence_tolerance,
                "",
                "The velocity has been made free of divergence when an "
                "iteration changes it by less than this part of the whole "
                "change.",
                dealii::Patterns::Double(0, 1));
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
    section.add("Maximal linear iterations",
                maximal_cg_iterations,
                "",
                "A linear solver that needs more fails, and the step is "
                "repeated with half the size.",
                dealii::Patterns::Integer(1));
  }



  template <int dim>
  void
  FractionalStep<dim>::initialize(const FlowSetup<dim> &setup)
  {
    context  = &setup.context;
    space    = &setup.space;
    boundary = &setup.boundary;
    phase    = &setup.phase;
    forces   = &setup.forces;
    terms    = &setup.terms;
    mass     = std::make_unique<NodalMass<dim>>(*space, *boundary, *phase);
    budget   = std::make_unique<KineticBudget<dim>>(*context, *mass);
    pressure_system =
      std::make_unique<PressureSystem<dim>>(*space, *boundary, *phase, *forces);
    cell_projection = std::make_unique<CellProjection<dim>>(*space,
                                                            *boundary,
                                                            *mass,
                                                            *pressure_system);
    viscous         = std::make_unique<ViscousOperator<dim>>(*space,
                                                     *boundary,
                                                     *phase,
                                                     &setup.viscosities);
    Thalweg::initialize(*space, p);
    Thalweg::initialize(*space, dp);
    space->initialize_velocity(force);
    space->initialize_velocity(change);
    space->initialize_velocity(before_friction);
    space->initialize_velocity(deflected);
    space->initialize_velocity(v);
  }



  template <int dim>
  void
  FractionalStep<dim>::add_terms()
  {
    if (!terms->has_acceleration())
      return;
    force.zero_out_ghost_values();
    force = 0.;
    terms->add_acceleration(force);
    pressure_system->add_acceleration(1., force);
  }



  template <int dim>
  void
  FractionalStep<dim>::add_force_density()
  {
    const CellGraph<dim> &graph = space->mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto measures = integrals.node_measures(graph.cell(c));
        const auto f        = forces->density(Q1::center<dim>(graph.cell(c)));
        for (unsigned int i = 0; i < measures.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            force.local_element(dim * space->nodes(c)[i] + d) +=
              measures[i] * f[d];
      }
  }



  template <int dim>
  void
  FractionalStep<dim>::accelerate(const EnrichedPressure &pressure,
                                  const bool              with_forces,
                                  const double            duration)
  {
    force = 0.;
    pressure_system->subtract_gradient(pressure, force);
    if (with_forces && forces->has_density())
      add_force_density();
    space->fold(force, dim);
    mass->accelerate(force,
                     with_forces ? forces->uniform_acceleration()
                                 : dealii::Tensor<1, dim>(),
                     with_forces ? &pressure_system->acceleration() : nullptr);
    if (forces->is_rotating())
      turn(deflection, force);
    v.zero_out_ghost_values();
    v.add(duration, force);
    boundary->apply(v);
    space->interpolate(v, dim);
  }



  template <int dim>
  void
  FractionalStep<dim>::turn(const dealii::Tensor<2, dim> &matrix,
                            Vector                       &vector) const
  {
    for (unsigned int n = 0; n < vector.locally_owned_size() / dim; ++n)
      {
        dealii::Tensor<1, dim> value;
        for (unsigned int d = 0; d < dim; ++d)
          value[d] = vector.local_element(dim * n + d);
        value = matrix * value;
        for (unsigned int d = 0; d < dim; ++d)
          vector.local_element(dim * n + d) = value[d];
      }
  }



  template <int dim>
  void
  FractionalStep<dim>::deflect(const Vector &lead, const double duration)
  {
    const dealii::Tensor<2, dim> spin = duration * forces->spin();
    deflection = dealii::invert(dealii::unit_symmetric_tensor<dim>() + spin);
    // change: what the rotation makes of V*, from the velocity before
    change.zero_out_ghost_values();
    change.add(2., lead);
    turn(spin, change);
    change.sadd(-1., 1., v);
    turn(deflection, change);
    change.add(-1., v);
    v.zero_out_ghost_values();
    v.add(1., change);
    deflected.zero_out_ghost_values();
    deflected.equ(1. / duration, change);
    space->interpolate(deflected, dim);
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
               maximal_cg_iterations,
               "viscous predictor");
    context->statistics.add("viscous iterations", report.iterations);
    v.zero_out_ghost_values();
    v.add(1., change);
    boundary->apply(v);
    space->interpolate(v, dim);
    return true;
  }



  template <int dim>
  void
  FractionalStep<dim>::normalize_pressure()
  {
    if (boundary->conditions().has_open_boundary())
      return;
    double sum[2] = {0, 0};
    for (unsigned int n = 0; n < nodal(p).locally_owned_size(); ++n)
      if (!space->is_dependent(n))
        {
          sum[0] += nodal(p).local_element(n);
          sum[1] += 1.;
        }
    dealii::Utilities::MPI::sum(sum, context->communicator, sum);
    nodal(p).zero_out_ghost_values();
    nodal(p).add(-sum[0] / sum[1]);
    space->interpolate(nodal(p), 1);
  }



  template <int dim>
  void
  FractionalStep<dim>::apply_open_boundary()
  {
    nodal(p).zero_out_ghost_values();
    pressure_system->apply_open_boundary(nodal(p));
    for (const auto &node : boundary->pressure_nodes())
      if (node.node < nodal(p).locally_owned_size())
        {
          dealii::Tensor<1, dim> velocity;
          for (unsigned int d = 0; d < dim; ++d)
            velocity[d] = v.local_element(dim * node.node + d);
          const double inward = std::min(velocity * node.normal, 0.);
          nodal(p).local_element(node.node) -=
            .5 * mass->density(node.node) * inward * inward;
        }
    space->interpolate(nodal(p), 1);
  }



  template <int dim>
  void
  FractionalStep<dim>::balance_forces(const Vector &rate, const double duration)
  {
    dealii::TimerOutput::Scope scope(context->timers, "pressure");
    // The last step's pressure is the initial guess.
    apply_open_boundary();
    star(p).zero_out_ghost_values();
    star(p) = 0.;
    if (forces->is_rotating())
      pressure_system->add_acceleration(1., deflected);
    const SolveReport report = pressure_system->correct(
      rate, true, p, pressure_tolerance, maximal_cg_iterations);
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
                                   maximal_cg_iterations); // (87c,d)
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
  FractionalStep<dim>::remove_divergence(const Vector &lead)
  {
    dealii::TimerOutput::Scope scope(context->timers, "divergence");
    v.zero_out_ghost_values();
    v.add(1., lead);
    space->interpolate(v, dim);
    const SolveReport report =
      cell_projection->project(v, divergence_tolerance, maximal_cg_iterations);
    v.zero_out_ghost_values();
    v.add(-1., lead);
    space->interpolate(v, dim);
    context->statistics.set("divergence iterations", report.iterations);
    context->statistics.set("divergence [1/s]", report.residual);
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
    {
      dealii::TimerOutput::Scope scope(context->timers, "assembly");
      mass->update();
      pressure_system->assemble();
      add_terms();
    }
    change.copy_locally_owned_data_from(v);
    v.copy_locally_owned_data_from(velocity_star);
    if (forces->is_rotating())
      deflect(lead, duration);
    boundary->apply(v);
    space->interpolate(v, dim);

    budget->begin(v);

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
    normalize_pressure();
    remove_divergence(lead);
    budget->record("divergence", v);
  }



  THALWEG_INSTANTIATE(FractionalStep)
  THALWEG_REGISTER(FluidSolver,
                   FractionalStep,
                   "fractional step",
                   "viscous predictor and enriched pressure correction, "
                   "repeated (Eq. 87)")
} // namespace Thalweg
