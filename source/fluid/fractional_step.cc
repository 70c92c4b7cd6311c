#include <thalweg/fluid/fractional_step.h>

namespace Thalweg
{
  namespace
  {
    /// To this part each solve but the last reduces its residual: the
    /// iterations of (87c) to (87e) only halve their error, and what one solve
    /// leaves, the next one finds.
    constexpr double intermediate_reduction = .05;
  } // namespace



  template <int dim>
  void
  FractionalStep<dim>::declare_parameters(const Section &section)
  {
    section.add("Iterations",
                iterations,
                "",
                "At most so many repetitions of the steps B to D after the "
                "first pressure solve (Eq. 87); with large time steps too few "
                "of them lose volume.",
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
    section.add("Maximal linear iterations",
                maximal_cg_iterations,
                "",
                "A linear solver that needs more fails, and the step is "
                "repeated with half the size.",
                dealii::Patterns::Integer(1));
  }



  template <int dim>
  void
  FractionalStep<dim>::initialize(Context                  &context_,
                                  const NodeSpace<dim>     &space_,
                                  const BoundaryNodes<dim> &boundary_,
                                  const PhaseField<dim>    &phase_,
                                  const BodyForces<dim>    &forces_)
  {
    context  = &context_;
    space    = &space_;
    boundary = &boundary_;
    phase    = &phase_;
    forces   = &forces_;
    pressure_system =
      std::make_unique<PressureSystem<dim>>(*space, *boundary, *phase, *forces);
    viscous = std::make_unique<ViscousOperator<dim>>(*space, *boundary, *phase);
    space->initialize_scalar(mass);
    space->initialize_scalar(p.nodal);
    space->initialize_scalar(dp.nodal);
    space->initialize_velocity(force);
    space->initialize_velocity(change);
    space->initialize_velocity(v);
  }



  template <int dim>
  void
  FractionalStep<dim>::assemble_mass()
  {
    const CellGraph<dim> &graph = space->mesh().graph();
    mass                        = 0.;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const int cut_index = phase->cut_index(c);
        auto      local = cut_index < 0 ? integrals.node_measures(graph.cell(c))
                                        : phase->cut_cells()[cut_index].mass;
        if (cut_index < 0)
          for (double &value : local)
            value *= phase->fluid(c).density;
        for (unsigned int i = 0; i < local.size(); ++i)
          mass.local_element(space->nodes(c)[i]) += local[i];
      }
    space->fold(mass, 1);
  }



  template <int dim>
  void
  FractionalStep<dim>::accelerate(const EnrichedPressure &pressure,
                                  const bool              with_forces,
                                  const double            dt)
  {
    force = 0.;
    pressure_system->subtract_gradient(pressure, force);
    if (with_forces && forces->has_density())
      {
        const CellGraph<dim> &graph = space->mesh().graph();
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          {
            const auto measures = integrals.node_measures(graph.cell(c));
            const auto f = forces->density(Q1::center<dim>(graph.cell(c)));
            for (unsigned int i = 0; i < measures.size(); ++i)
              for (unsigned int d = 0; d < dim; ++d)
                force.local_element(dim * space->nodes(c)[i] + d) +=
                  measures[i] * f[d];
          }
      }
    space->fold(force, dim);
    const Vector                 &field   = pressure_system->acceleration();
    const dealii::Tensor<1, dim> &uniform = forces->uniform_acceleration();
    v.zero_out_ghost_values();
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      if (!space->is_dependent(n))
        {
          dealii::Tensor<1, dim> a;
          for (unsigned int d = 0; d < dim; ++d)
            a[d] = force.local_element(dim * n + d) / mass.local_element(n) +
                   (with_forces ? uniform[d] + field.local_element(dim * n + d)
                                : 0.);
          if (forces->is_rotating())
            a = deflection * a;
          for (unsigned int d = 0; d < dim; ++d)
            v.local_element(dim * n + d) += dt * a[d];
        }
    boundary->apply(v);
    space->interpolate(v, dim);
  }



  template <int dim>
  void
  FractionalStep<dim>::deflect(const Vector &velocity_star, const double dt)
  {
    const dealii::Tensor<2, dim> spin = dt * forces->spin();
    deflection = dealii::invert(dealii::unit_symmetric_tensor<dim>() + spin);
    v.zero_out_ghost_values();
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      {
        dealii::Tensor<1, dim> old, star;
        for (unsigned int d = 0; d < dim; ++d)
          {
            old[d]  = v.local_element(dim * n + d);
            star[d] = velocity_star.local_element(dim * n + d);
          }
        star = deflection * (star - spin * old);
        for (unsigned int d = 0; d < dim; ++d)
          v.local_element(dim * n + d) = star[d];
      }
  }



  template <int dim>
  void
  FractionalStep<dim>::predict(const double dt)
  {
    force = 0.;
    viscous->subtract_viscous_force(v, force);
    space->fold(force, dim);
    boundary->project(force);
    if (force.linfty_norm() == 0.)
      return;
    viscous->update(mass, dt);
    change.zero_out_ghost_values();
    double momentum = 0;
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        momentum +=
          std::pow(mass.local_element(n) / dt * v.local_element(dim * n + d),
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
  }



  template <int dim>
  void
  FractionalStep<dim>::normalize_pressure()
  {
    if (boundary->conditions().has_open_boundary())
      return;
    double sum[2] = {0, 0};
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      if (!space->is_dependent(n))
        {
          sum[0] += p.nodal.local_element(n);
          sum[1] += 1.;
        }
    dealii::Utilities::MPI::sum(sum, context->communicator, sum);
    p.nodal.zero_out_ghost_values();
    p.nodal.add(-sum[0] / sum[1]);
    space->interpolate(p.nodal, 1);
  }



  template <int dim>
  void
  FractionalStep<dim>::solve(const Vector &velocity_star, const double dt)
  {
    auto &statistics = context->statistics;
    for (const char *column : {"pressure iterations", "viscous iterations"})
      statistics.set(column, 0);
    {
      dealii::TimerOutput::Scope scope(context->timers, "assembly");
      assemble_mass();
      pressure_system->assemble();
    }

    if (forces->is_rotating())
      deflect(velocity_star, dt);
    else
      v.copy_locally_owned_data_from(velocity_star);
    boundary->apply(v);
    space->interpolate(v, dim);

    // The pressure that balances the forces on the convected velocity; the
    // last step's is the initial guess.
    SolveReport report;
    {
      dealii::TimerOutput::Scope scope(context->timers, "pressure");
      p.nodal.zero_out_ghost_values();
      pressure_system->apply_open_boundary(p.nodal);
      space->interpolate(p.nodal, 1);
      p.star.assign(phase->cut_cells().size(), 0.);
      report = pressure_system->correct(
        v, dt, true, p, pressure_tolerance, maximal_cg_iterations);
      statistics.add("pressure iterations", report.iterations);
      accelerate(p, true, dt);
    }
    {
      dealii::TimerOutput::Scope scope(context->timers, "viscosity");
      predict(dt); // (87b)
    }

    dealii::TimerOutput::Scope scope(context->timers, "pressure");
    unsigned int               i          = 0;
    double                     difference = 1.;
    for (; i < iterations && difference > iteration_tolerance; ++i)
      {
        dp.nodal = 0.;
        dp.star.assign(phase->cut_cells().size(), 0.);
        report =
          pressure_system->correct(v,
                                   dt,
                                   false,
                                   dp,
                                   pressure_tolerance,
                                   maximal_cg_iterations,
                                   i + 1 < iterations ? intermediate_reduction
                                                      : 0.); // (87c,d)
        statistics.add("pressure iterations", report.iterations);
        change.copy_locally_owned_data_from(v);
        accelerate(dp, false, dt); // (87e)
        change.add(-1., v);
        const double norm = v.l2_norm();
        difference        = norm > 0 ? change.l2_norm() / norm : 0.;
        p.nodal.zero_out_ghost_values();
        p.nodal.add(1., dp.nodal);
        space->interpolate(p.nodal, 1);
        for (unsigned int k = 0; k < p.star.size(); ++k)
          p.star[k] += dp.star[k];
      }
    normalize_pressure();
    statistics.set("fractional step iterations", i);
    statistics.set("pressure residual", report.residual);
    statistics.set("velocity change", difference);
  }



  THALWEG_INSTANTIATE(FractionalStep)
  THALWEG_REGISTER(FluidSolver,
                   FractionalStep,
                   "fractional step",
                   "viscous predictor and enriched pressure correction, "
                   "repeated (Eq. 87)")
} // namespace Thalweg
