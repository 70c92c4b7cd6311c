// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps A to C of IncrementalStep; the fields of explicit forces are in
// incremental_step_explicit.cc.
#include <thalweg/core/registry.h>
#include <thalweg/fluid/incremental_step.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    typename OperatorSolver<dim>::Projector
    projector(const FlowBoundary<dim> &boundary)
    {
      return [&boundary](Vector &velocity) { boundary.project(velocity); };
    }
  } // namespace



  template <int dim>
  IncrementalStep<dim>::IncrementalStep(
    Context                          &context,
    const FlowOperators<dim>         &operators,
    const FlowBoundary<dim>          &boundary,
    const PressureStabilization<dim> &stabilization,
    const IncrementalStepParameters  &parameters,
    const double                      kinematic_viscosity)
    : context(context)
    , operators(operators)
    , boundary(boundary)
    , stabilization(stabilization)
    , parameters(parameters)
    , nu(kinematic_viscosity)
    , mass(operators.mass, dim)
    , slip_mass(operators.mass,
                dim,
                [&boundary](Vector &field) { boundary.project_slip(field); })
    , fixed_mass(operators.mass, dim, projector(boundary))
    , pressure_mass(operators.pressure_mass, 1)
    , extension(operators.velocity_space, boundary)
    , poisson(operators, boundary)
    , convection(operators)
    , stokes(operators, boundary, kinematic_viscosity)
  {
    for (Vector *vector : {&load, &change})
      operators.velocity_space.initialize(*vector, dim);
    for (Vector *vector :
         {&pressure_load, &increment, &divergence, &kept_divergence})
      operators.pressure_space.initialize(*vector, 1);
    operators.velocity_space.initialize(lumped_mass, dim);
    change = 1.;
    operators.velocity_space.interpolate(change, dim);
    operators.mass.add_product(change, lumped_mass, dim, 1.);
    operators.velocity_space.fold(lumped_mass, dim);
    tau.assign(operators.cell_lengths().size(), 0.);
    factors.assign(tau.size(), 1.);
  }



  template <int dim>
  SolveReport
  IncrementalStep<dim>::solve(const OperatorSolver<dim> &solver,
                              Vector                    &solution,
                              const std::string         &what,
                              const double               reference)
  {
    return solver.solve(solution,
                        load,
                        parameters.velocity_tolerance,
                        parameters.maximal_cg_iterations,
                        what,
                        reference);
  }



  template <int dim>
  void
  IncrementalStep<dim>::update_implicit(const double dt)
  {
    if (dt == implicit_dt)
      return;
    implicit_dt = dt;
    implicit_matrix.combine(1.,
                            operators.mass,
                            parameters.viscous_theta * nu * dt,
                            operators.stiffness);
    implicit = std::make_unique<OperatorSolver<dim>>(implicit_matrix, dim);
    fixed_implicit = std::make_unique<OperatorSolver<dim>>(implicit_matrix,
                                                           dim,
                                                           projector(boundary));
  }



  template <int dim>
  void
  IncrementalStep<dim>::find_stabilization(const Vector &velocity,
                                           const bool    stabilized,
                                           const double  dt)
  {
    std::fill(factors.begin(), factors.end(), 1.);
    is_stabilized = stabilized && stabilization.is_active();
    if (!is_stabilized)
      return;
    const auto &space = operators.velocity_space;
    for (unsigned int c = 0; c < tau.size(); ++c)
      {
        double square = 0;
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            square +=
              std::pow(velocity.local_element(dim * space.nodes(c)[i] + d), 2);
        tau[c] =
          stabilization.parameter(operators.cell_lengths()[c],
                                  nu,
                                  std::sqrt(square / space.n_nodes_per_cell()),
                                  dt);
        factors[c] = 1. + tau[c] / dt;
      }
  }



  template <int dim>
  void
  IncrementalStep<dim>::predict(const Vector   &velocity_star,
                                const Explicit &given,
                                const double    dt,
                                const Vector   &pressure,
                                Vector         &velocity)
  {
    const auto &space = operators.velocity_space;
    update_implicit(dt);
    velocity.zero_out_ghost_values();
    velocity.copy_locally_owned_data_from(velocity_star);
    boundary.apply(velocity);
    space.interpolate(velocity, dim);

    load = 0.;
    operators.mass.add_product(velocity_star, load, dim, 1.);
    space.fold(load, dim);
    const double momentum = load.l2_norm();
    load                  = 0.;
    operators.mass.add_product(velocity_star, load, dim, 1.);
    operators.mass.add_product(given.viscous,
                               load,
                               dim,
                               -parameters.viscous_theta * dt);
    implicit_matrix.add_product(velocity, load, dim, -1.);
    operators.add_gradient(given.pressure, load, dt);
    operators.add_gradient(pressure, load, -dt);
    space.fold(load, dim);
    change.zero_out_ghost_values();
    change = 0.;
    const SolveReport report =
      solve(*fixed_implicit, change, "viscous predictor", momentum);
    context.statistics.add("viscous iterations", report.iterations);
    velocity.zero_out_ghost_values();
    velocity.add(1., change);
    space.interpolate(velocity, dim);
  }



  template <int dim>
  SolveReport
  IncrementalStep<dim>::solve_poisson(Vector      &right_hand_side,
                                      const double tolerance)
  {
    const SolveReport report = poisson.solve(increment,
                                             right_hand_side,
                                             factors,
                                             tolerance,
                                             parameters.maximal_cg_iterations);
    context.statistics.add("pressure iterations", report.iterations);
    return report;
  }



  template <int dim>
  void
  IncrementalStep<dim>::find_divergence(const Vector &velocity)
  {
    divergence = 0.;
    operators.add_divergence(velocity, divergence, 1.);
    operators.pressure_space.fold(divergence, 1);
    if (keeps_divergence)
      divergence.add(-1., kept_divergence);
  }



  template <int dim>
  void
  IncrementalStep<dim>::keep_divergence(const Vector &velocity,
                                        const double  part)
  {
    keeps_divergence = part > 0.;
    if (!keeps_divergence)
      return;
    kept_divergence = 0.;
    operators.add_divergence(velocity, kept_divergence, part);
    operators.pressure_space.fold(kept_divergence, 1);
  }



  template <int dim>
  void
  IncrementalStep<dim>::subtract_gradient(Vector &velocity)
  {
    load = 0.;
    operators.add_gradient(increment, load, -1.);
    operators.velocity_space.fold(load, dim);
    change.zero_out_ghost_values();
    change = 0.;
    solve(fixed_mass, change, "velocity correction"); // (81d)
    velocity.zero_out_ghost_values();
    velocity.add(1., change);
    operators.velocity_space.interpolate(velocity, dim);
  }



  template <int dim>
  void
  IncrementalStep<dim>::remove_divergence(Vector &velocity)
  {
    dealii::TimerOutput::Scope scope(context.timers, "pressure");
    find_divergence(velocity);
    std::fill(factors.begin(), factors.end(), 1.);
    solve_poisson(divergence,
                  parameters.pressure_tolerance * divergence.l2_norm());
    subtract_gradient(velocity);
  }



  template <int dim>
  void
  IncrementalStep<dim>::correct(const Explicit &given,
                                const double    dt,
                                Vector         &velocity,
                                Vector         &pressure)
  {
    const auto &P = operators.pressure_space;

    find_divergence(velocity);
    pressure_load = divergence;
    if (is_stabilized)
      {
        operators.pressure_stiffness.add_product(
          pressure, pressure_load, 1, -1., tau.data());
        operators.add_weak_gradient(
          stabilization.balance(given.pressure_acceleration, given.forces),
          pressure_load,
          1.,
          tau.data());
        P.fold(pressure_load, 1);
      }
    const SolveReport report =
      solve_poisson(pressure_load,
                    parameters.pressure_tolerance *
                      pressure_load.l2_norm()); // (81c)
    context.statistics.set("pressure residual", report.residual);

    subtract_gradient(velocity);

    pressure.zero_out_ghost_values();
    pressure.add(1. / dt, increment);
    if (parameters.rotational && parameters.viscous_theta * nu > 0.)
      {
        increment.zero_out_ghost_values();
        increment = 0.;
        pressure_mass.solve(increment,
                            divergence,
                            parameters.pressure_tolerance,
                            parameters.maximal_cg_iterations,
                            "divergence");
        pressure.add(parameters.viscous_theta * nu, increment);
      }
    P.interpolate(pressure, 1);
    poisson.normalize(pressure);
  }



  template <int dim>
  void
  IncrementalStep<dim>::solve(const Vector   &velocity_star,
                              const Explicit &given,
                              const bool      stabilized,
                              const double    dt,
                              Vector         &velocity,
                              Vector         &pressure)
  {
    pressure.zero_out_ghost_values();
    pressure.copy_locally_owned_data_from(given.pressure);
    operators.pressure_space.interpolate(pressure, 1);
    find_stabilization(velocity_star, stabilized, dt);
    for (unsigned int i = 0; i < parameters.iterations; ++i)
      {
        {
          dealii::TimerOutput::Scope scope(context.timers, "viscosity");
          predict(velocity_star, given, dt, pressure, velocity); // (81b)
        }
        dealii::TimerOutput::Scope scope(context.timers, "pressure");
        correct(given, dt, velocity, pressure);
      }
  }



  THALWEG_INSTANTIATE(IncrementalStep)
} // namespace Thalweg
