// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/interpolation.h>
#include <thalweg/fields/owned_values.h>
#include <thalweg/fluid/single_fluid_flow.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Curved cells, whose manifolds are asked only once.
    template <int dim>
    std::unique_ptr<dealii::MappingQCache<dim>>
    curved_mapping(const Mesh<dim> &mesh)
    {
      auto mapping = std::make_unique<dealii::MappingQCache<dim>>(2);
      mapping->initialize(dealii::MappingQ<dim>(2), mesh.triangulation());
      return mapping;
    }
  } // namespace



  template <int dim>
  SingleFluidFlow<dim>::SingleFluidFlow(
    Context                              &context,
    const Mesh<dim>                      &mesh,
    const SingleFluidFlowParameters<dim> &parameters,
    const Fluid                          &fluid,
    const BodyForces<dim>                &forces,
    const FlowTerms<dim>                 &terms,
    BoundaryConditions<dim>              &conditions)
    : context(context)
    , parameters(parameters)
    , fluid(fluid)
    , forces(forces)
    , terms(terms)
    , conditions(conditions)
    , second_order(parameters.order == "second order")
    , mapping(curved_mapping(mesh))
    , velocity_space(
        std::make_unique<LagrangeSpace<dim>>(mesh,
                                             parameters.velocity_degree,
                                             *mapping))
    , pressure_space(
        std::make_unique<LagrangeSpace<dim>>(mesh,
                                             parameters.pressure_degree,
                                             *mapping))
    , boundary(std::make_unique<FlowBoundary<dim>>(*velocity_space,
                                                   *pressure_space,
                                                   conditions))
    , operators(std::make_unique<FlowOperators<dim>>(*velocity_space,
                                                     *pressure_space,
                                                     *boundary,
                                                     parameters.is_lumped()))
    , step(
        std::make_unique<IncrementalStep<dim>>(context,
                                               *operators,
                                               *boundary,
                                               *parameters.stabilization,
                                               parameters.step,
                                               fluid.viscosity / fluid.density))
    , boundary_reaction(
        std::make_unique<BoundaryReaction<dim>>(*operators,
                                                *boundary,
                                                fluid.viscosity /
                                                  fluid.density))
    , view{*mapping,
           velocity_space->velocity(),
           pressure_space->scalar(),
           begin_velocity,
           physical_pressure,
           &reaction,
           &traction,
           fluid.density,
           fluid.viscosity,
           0.}
  {
    for (Vector *vector : {&begin_velocity,
                           &end_velocity,
                           &old_velocity,
                           &force_impulse,
                           &mean_force,
                           &body_force,
                           &with_coriolis,
                           &viscous,
                           &begin_viscous,
                           &end_viscous,
                           &end_smooth,
                           &start,
                           &boundary_acceleration,
                           &begin_gradient,
                           &end_gradient,
                           &pressure_gradient,
                           &force,
                           &reaction,
                           &traction})
      velocity_space->initialize(*vector, dim);
    make_explicit_space();
    for (Vector *vector : {&older_begin_pressure,
                           &old_begin_pressure,
                           &begin_pressure,
                           &end_pressure})
      explicit_space->initialize(*vector, 1);
    for (Vector *vector : {&old_pressure,
                           &pressure_impulse,
                           &mean_pressure,
                           &pressure,
                           &new_pressure,
                           &pressure_rate,
                           &physical_pressure})
      pressure_space->initialize(*vector, 1);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::initialize(const dealii::Function<dim> &velocity)
  {
    conditions.set_time(0.);
    interpolate_function(*velocity_space, velocity, begin_velocity);
    boundary->apply(begin_velocity);
    velocity_space->interpolate(begin_velocity, dim);
    old_velocity = begin_velocity;
    end_velocity = begin_velocity;
    end_velocity.update_ghost_values();
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_viscous(const Vector &velocity,
                                     Vector       &g,
                                     Vector       &smoothed)
  {
    step->viscous_acceleration(velocity, g); // (78)
    step->smooth(g, dt, smoothed);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::start_step(const double time_, const double dt_)
  {
    time = time_;
    dt   = dt_;
    conditions.set_time(time + dt);
    find_body_force();
    find_viscous(begin_velocity, viscous, begin_viscous);
    if (is_within_reach(known_span) && second_order)
      extrapolate_owned(begin_velocity,
                        old_velocity,
                        dt / known_span,
                        end_velocity);
    else
      copy_owned(end_velocity, begin_velocity);
    boundary->apply(end_velocity);
    velocity_space->interpolate(end_velocity, dim);
    guess_pressures();
    has_solution = false;
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_accelerations(Vector &begin, Vector &end)
  {
    const double theta = parameters.step.viscous_theta;
    if (second_order)
      find_viscous(end_velocity, end_viscous, end_smooth);
    find_pressure_gradients();
    add_coriolis(begin_velocity);
    copy_owned(begin, with_coriolis);
    add_coriolis(convecting_velocity_at_end());
    copy_owned(end, with_coriolis);
    begin.add(-1., begin_gradient);
    end.add(-1., end_gradient);
    if (second_order)
      {
        begin.add(1., begin_viscous);
        end.add(1., end_smooth);
      }
    else
      {
        begin.add(1. - theta, viscous);
        end.add(1. - theta, viscous);
      }
    for (Vector *vector : {&begin, &end})
      {
        boundary->project_acceleration(*vector);
        velocity_space->interpolate(*vector, dim);
      }
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_start(const Vector &velocity_star)
  {
    copy_owned(start, velocity_star);
    const double part = (1. - parameters.step.viscous_theta) * dt;
    if (second_order && part > 0.)
      {
        start.add(part, viscous);
        start.add(-part, begin_viscous);
      }
    velocity_space->interpolate(start, dim);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::solve(const Vector &velocity_star)
  {
    find_start(velocity_star);
    const Vector predicted = end_velocity;
    copy_owned(force, body_force);
    force.add(1., viscous);
    velocity_space->interpolate(force, dim);
    const double kept = is_short() ? 1. - dt / usual_dt : 0.;
    step->keep_divergence(begin_velocity, kept);
    step->solve(start,
                {pressure, pressure_gradient, end_smooth, force},
                !is_consistent(),
                dt,
                end_velocity,
                new_pressure);
    if (own_explicit_step)
      {
        own_explicit_step->keep_divergence(begin_velocity, kept);
        own_explicit_step->remove_divergence(end_velocity);
      }
    has_solution = true;
    find_prediction_error(predicted);
    if (is_consistent())
      return;
    // What a repetition of the step, or the next one, knows.
    if (second_order && mean_span > 0. && !is_short())
      {
        copy_owned(pressure_rate, new_pressure);
        pressure_rate.add(-1., old_pressure);
        pressure_rate *= 2. / (dt + mean_span);
      }
    copy_owned(pressure, new_pressure);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_prediction_error(const Vector &predicted)
  {
    double largest[2] = {0., 0.};
    for (unsigned int n = 0; n < velocity_space->n_owned_nodes(); ++n)
      {
        double squares[2] = {0., 0.};
        for (unsigned int i = dim * n; i < dim * (n + 1); ++i)
          {
            const double found = end_velocity.local_element(i);
            squares[0] += std::pow(found - predicted.local_element(i), 2);
            squares[1] += std::pow(found, 2);
          }
        for (unsigned int k = 0; k < 2; ++k)
          largest[k] = std::max(largest[k], std::sqrt(squares[k]));
      }
    dealii::Utilities::MPI::max(largest, context.communicator, largest);
    error_of_prediction = largest[1] > 0. ? largest[0] / largest[1] : 0.;
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_means()
  {
    Vector middle = begin_velocity;
    middle.sadd(.5, .5, end_velocity);
    add_coriolis(middle);
    mean_span = dt;
    copy_owned(mean_pressure, new_pressure);
    copy_owned(mean_force, with_coriolis);
    if (!is_short())
      {
        copy_owned(pressure_impulse, new_pressure);
        copy_owned(force_impulse, with_coriolis);
        pressure_impulse *= dt;
        force_impulse *= dt;
      }
    else
      {
        mean_span         = known_span + dt;
        const auto extend = [&](Vector &impulse, Vector &mean) {
          impulse.add(dt, mean);
          copy_owned(mean, impulse);
          mean *= 1. / mean_span;
        };
        extend(pressure_impulse, mean_pressure);
        extend(force_impulse, mean_force);
      }
    pressure_space->interpolate(mean_pressure, 1);
    velocity_space->interpolate(mean_force, dim);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::end_step()
  {
    was_short = is_short();
    find_means();
    boundary_reaction->find(was_short ? old_velocity : begin_velocity,
                            end_velocity,
                            mean_pressure,
                            mean_force,
                            mean_span,
                            fluid.density,
                            reaction);
    boundary_reaction->find_traction(reaction,
                                     mean_pressure,
                                     fluid.density,
                                     traction);
    if (was_short)
      known_span += dt;
    else
      {
        copy_owned(old_velocity, begin_velocity);
        known_span = usual_dt = dt;
      }
    copy_owned(begin_velocity, end_velocity);
    velocity_space->interpolate(begin_velocity, dim);
    copy_owned(old_pressure, mean_pressure);
    // What splitting leaves is part of the forces, but not as exact a
    // pressure as that of the velocity.
    copy_owned(physical_pressure, is_consistent() ? pressure : mean_pressure);
    physical_pressure *= fluid.density;
    pressure_space->interpolate(physical_pressure, 1);
    view.pressure_time = time + dt - .5 * (is_consistent() ? dt : mean_span);
    last_dt            = dt;
  }



  THALWEG_INSTANTIATE(SingleFluidFlow)
} // namespace Thalweg
