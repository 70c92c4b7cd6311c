// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/pfem2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim>
  Pfem2<dim>::Pfem2()
    : FlowMethod<dim>(/*computes_flow=*/true, /*heeds_viscosities=*/true)
  {}



  template <int dim>
  void
  Pfem2<dim>::declare_parameters(const Section &section)
  {
    section.add(
      "Time integration",
      time_integration,
      "",
      "Particles follow the streamlines of the last velocity and are then "
      "accelerated for the whole step (`frozen`, first order); of the one "
      "extrapolated from the last two to the middle of the step "
      "(`extrapolated`: second order for positions, damps waves); velocities "
      "are those at the middle of the steps from the first step on "
      "(`staggered`, the leapfrog scheme: waves keep their amplitude); or "
      "half of the acceleration comes before the particles move and half "
      "after it (`trapezoidal`: second order in everything).",
      dealii::Patterns::Selection("frozen|extrapolated|staggered|trapezoidal"));
  }



  template <int dim>
  void
  Pfem2<dim>::attach_fields()
  {
    numbers = std::make_unique<FlowStepNumbers<dim>>(
      parts->space,
      parts->fluids,
      std::numeric_limits<double>::infinity(),
      parts->phase.surface_tension().coefficient);
    budget           = std::make_unique<ParticleBudget<dim>>(*parts);
    carried_distance = std::make_unique<CarriedDistance<dim>>(parts->space);
    if (time_integration == "staggered")
      convected_change = std::make_unique<ConvectedChange<dim>>(parts->space);
    for (Vector *vector :
         {&convecting_velocity, &old_velocity, &velocity_star, &rate, &lead})
      parts->space.initialize_velocity(*vector);
    parts->space.initialize_scalar(level_set);
    // The first way back along a streamline comes before the first step.
    parts->space.copy_to_cells(level_set, cell_level_set);
  }



  template <int dim>
  void
  Pfem2<dim>::initialize_fields(const typename InterfaceFlow<dim>::Start &start)
  {
    convecting_velocity = start.nodal_velocity;
    old_velocity        = start.nodal_velocity;
    velocity_star       = start.nodal_velocity;
    level_set           = start.nodal_level_set;
    convecting_velocity.update_ghost_values();
    velocity_star.update_ghost_values();
    project_particles();
    parts->phase.rebuild(level_set);
    Vector &v = parts->flow.velocity();
    v.copy_locally_owned_data_from(start.nodal_velocity);
    parts->space.interpolate(v, dim);
  }



  template <int dim>
  void
  Pfem2<dim>::keep_fields(const State<dim> &state)
  {
    state.values().value("flow time", flow_time);
    state.values().value("old flow time", old_flow_time);
    state.values().value("acceleration time", acceleration_time);
    state.field("convecting velocity", parts->space, convecting_velocity, dim);
    state.field("old velocity", parts->space, old_velocity, dim);
    state.field("convected velocity", parts->space, velocity_star, dim);
    state.field("lead", parts->space, lead, dim);
    state.field("level set", parts->space, level_set, 1);
  }



  template <int dim>
  void
  Pfem2<dim>::update()
  {
    parts->phase.rebuild(level_set);
  }



  template <int dim>
  void
  Pfem2<dim>::repopulate_cells()
  {
    repopulate_in_place(*parts,
                        parts->space,
                        parts->flow.velocity(),
                        level_set);
  }



  template <int dim>
  void
  Pfem2<dim>::accelerate_before_convection(const double time, const double dt)
  {
    if (acceleration_time == 0)
      {
        rate = 0.; // nothing has moved yet
        if (time_integration == "staggered" ||
            time_integration == "trapezoidal")
          accelerate(.5 * dt, time + .5 * dt, .5 * dt);
      }
    else if (time_integration == "trapezoidal")
      accelerate_particles(.5 * dt / acceleration_time); // (66), (81a)
  }



  template <int dim>
  void
  Pfem2<dim>::accelerate_particles(const double factor)
  {
    dealii::TimerOutput::Scope scope(parts->context.timers, "increment");
    add_increment(parts->population,
                  parts->space,
                  parts->flow.velocity(),
                  velocity_star,
                  factor);
    budget->record("increment");
  }



  template <int dim>
  double
  Pfem2<dim>::end_of_acceleration(const double time, const double dt) const
  {
    if (time_integration != "staggered")
      return time;
    // A step that was cut short does not pull the velocity back in time.
    return std::max(time, flow_time) + .5 * dt;
  }



  template <int dim>
  void
  Pfem2<dim>::choose_convecting_velocity(const double time)
  {
    const Vector &v = parts->flow.velocity();
    convecting_velocity.zero_out_ghost_values();
    convecting_velocity.copy_locally_owned_data_from(v);
    if (time_integration != "frozen" && flow_time > old_flow_time)
      {
        const double factor = (time - flow_time) / (flow_time - old_flow_time);
        convecting_velocity.add(factor, v);
        convecting_velocity.add(-factor, old_velocity);
      }
    convecting_velocity.add(1., lead);
    parts->space.interpolate(convecting_velocity, dim);
    parts->space.copy_to_cells(convecting_velocity, cell_velocity);
  }



  template <int dim>
  bool
  Pfem2<dim>::carries_distances() const
  {
    return parts->phase.is_distance() && parts->projection.takes_distances();
  }



  template <int dim>
  void
  Pfem2<dim>::project_particles()
  {
    parts->projection.project(
      parts->population, parts->space, parts->fluids, velocity_star, level_set);
    obey_slip_walls(velocity_star);
  }



  template <int dim>
  void
  Pfem2<dim>::obey_slip_walls(Vector &velocity) const
  {
    // The particles around a node of a wall stand to one side of it, and their
    // mean has a normal component. If the solver took that away the particles
    // would be given the change, a blow each step that grows as steps shrink.
    velocity.zero_out_ghost_values();
    parts->boundary.project_slip(velocity);
    parts->space.interpolate(velocity, dim);
  }



  template <int dim>
  void
  Pfem2<dim>::project_before_convection()
  {
    dealii::TimerOutput::Scope scope(parts->context.timers, "projection");
    rate.zero_out_ghost_values();
    rate.copy_locally_owned_data_from(velocity_star);
    project_momentum(parts->population, parts->space, parts->fluids, rate);
    obey_slip_walls(rate);
  }



  template <int dim>
  void
  Pfem2<dim>::find_rate(const double dt)
  {
    rate.zero_out_ghost_values();
    rate.sadd(-1., 1., velocity_star);
    parts->boundary.project(rate);
    // Where velocities are given: the new ones less the old ones.
    Vector given, old;
    parts->space.initialize_velocity(given);
    old.reinit(given);
    old.copy_locally_owned_data_from(parts->flow.velocity());
    given.copy_locally_owned_data_from(parts->flow.velocity());
    parts->boundary.project(given);
    old.add(-1., given);
    given = 0.;
    parts->boundary.apply(given);
    rate.add(1., given, -1., old);
    rate *= 1. / dt;
    parts->space.interpolate(rate, dim);
  }



  template <int dim>
  void
  Pfem2<dim>::find_lead(const double time)
  {
    if (convected_change == nullptr)
      return;
    dealii::TimerOutput::Scope scope(parts->context.timers, "convection");
    convected_change->find(
      parts->convection, velocity_star, cell_level_set, time, lead);
    parts->boundary.project(lead);
    parts->space.interpolate(lead, dim);
  }



  template <int dim>
  double
  Pfem2<dim>::time_of_forces(const double duration, const double time) const
  {
    if (time_integration != "trapezoidal")
      return time - .5 * duration;
    // The half after the motion has the forces of its end, that before the
    // first motion those of the start.
    return acceleration_time == 0. ? time - duration : time;
  }



  template <int dim>
  void
  Pfem2<dim>::accelerate(const double duration,
                         const double time,
                         const double half_step)
  {
    parts->conditions.set_time(time);
    parts->forces.set_time(time_of_forces(duration, time));
    parts->terms.set_time(time_of_forces(duration, time));
    acceleration_time = duration;
    old_flow_time     = flow_time;
    flow_time         = time;
    old_velocity.copy_locally_owned_data_from(parts->flow.velocity());
    find_lead(half_step);
    // (87b) to (87e)
    parts->flow.solve(velocity_star, rate, lead, acceleration_time);
    accelerate_particles(1.); // (87) 3
  }



  template <int dim>
  void
  Pfem2<dim>::advance(const double time, const double dt)
  {
    auto &[context,
           mesh,
           space,
           fluids,
           forces,
           terms,
           viscosities,
           conditions,
           boundary,
           population,
           convection,
           control,
           projection,
           phase,
           flow,
           paths,
           exchange,
           dispersed] = *parts;

    ConvectionReport report;
    unsigned int     n_added, n_removed;
    budget->begin(time);
    accelerate_before_convection(time, dt);
    choose_convecting_velocity(time + .5 * dt);
    keep_distance(dt);
    project_before_convection();
    {
      dealii::TimerOutput::Scope scope(context.timers, "convection");
      report = move_particles(time, dt); // (87a)
    }
    budget->record("motion");
    {
      dealii::TimerOutput::Scope scope(context.timers, "population");
      n_added = pass_boundaries(
        *parts, report, convecting_velocity, cell_velocity, time + .5 * dt, dt);
      n_added +=
        control.fill_empty_cells(population, cell_velocity, cell_level_set, dt);
    }
    budget->record("boundaries");
    {
      dealii::TimerOutput::Scope scope(context.timers, "projection");
      project_particles(); // (69)
    }
    {
      dealii::TimerOutput::Scope scope(context.timers, "interface");
      phase.find_distance(level_set);
    }
    disperse(time, dt);
    budget->record("dispersal");
    {
      dealii::TimerOutput::Scope scope(context.timers, "interface");
      phase.hold_volume();
      keep_shift();
    }
    const double end = end_of_acceleration(time + dt, dt);
    conditions.set_time(end);
    find_rate(dt);
    accelerate(time_integration == "trapezoidal" ? .5 * dt : end - flow_time,
               end,
               .5 * dt); // (87b) to (87e), (87) 3
    {
      dealii::TimerOutput::Scope scope(context.timers, "population");
      n_removed = control.limit(population);
      if (dispersed != nullptr)
        dispersed->limit(control);
    }
    budget->record("limit");
    budget->end();
    record_particles(*parts, report, n_added, n_removed);
  }



  THALWEG_INSTANTIATE(Pfem2)
  THALWEG_REGISTER(Method,
                   Pfem2,
                   "pfem2",
                   "particles convect, the mesh solves for pressure and "
                   "viscosity, the particles take the increment (Eq. 87)")
} // namespace Thalweg
