// SPDX-License-Identifier: LGPL-2.1-or-later
// The explicit pressures of SingleFluidFlow, and its state; its steps are in
// single_fluid_flow.cc.
#include <thalweg/fields/owned_values.h>
#include <thalweg/fields/vertex_values.h>
#include <thalweg/fluid/single_fluid_flow.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  SingleFluidFlow<dim>::make_explicit_space()
  {
    explicit_space    = pressure_space.get();
    explicit_boundary = boundary.get();
    explicit_step     = step.get();
    if (!is_consistent() ||
        parameters.pressure_degree == parameters.velocity_degree)
      return;
    own_explicit_space =
      std::make_unique<LagrangeSpace<dim>>(velocity_space->mesh(),
                                           parameters.velocity_degree,
                                           *mapping);
    own_explicit_boundary =
      std::make_unique<FlowBoundary<dim>>(*velocity_space,
                                          *own_explicit_space,
                                          conditions);
    own_explicit_operators =
      std::make_unique<FlowOperators<dim>>(*velocity_space,
                                           *own_explicit_space,
                                           *own_explicit_boundary,
                                           parameters.is_lumped());
    own_explicit_step =
      std::make_unique<IncrementalStep<dim>>(context,
                                             *own_explicit_operators,
                                             *own_explicit_boundary,
                                             *parameters.stabilization,
                                             parameters.step,
                                             fluid.viscosity / fluid.density);
    explicit_space    = own_explicit_space.get();
    explicit_boundary = own_explicit_boundary.get();
    explicit_step     = own_explicit_step.get();
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_pressure(const Vector &velocity,
                                      const Vector &g,
                                      const double  at,
                                      Vector       &result)
  {
    // dV_D/dt by a difference that no expression notices, but that the
    // rounding of the time does not reach.
    const double tick = std::max(1e-3 * dt, 1e-8 * std::abs(at));
    force.zero_out_ghost_values();
    force = 0.;
    conditions.set_time(at - tick);
    boundary->apply(force);
    boundary_acceleration.zero_out_ghost_values();
    boundary_acceleration = 0.;
    conditions.set_time(at + tick);
    boundary->apply(boundary_acceleration);
    boundary_acceleration.add(-1., force);
    boundary_acceleration *= .5 / tick;
    velocity_space->interpolate(boundary_acceleration, dim);

    conditions.set_time(at);
    result.zero_out_ghost_values();
    explicit_boundary->apply_open(result, 1. / fluid.density);
    explicit_space->interpolate(result, 1);
    add_coriolis(velocity);
    explicit_step->find_pressure(
      velocity, with_coriolis, g, boundary_acceleration, result);
    conditions.set_time(time + dt);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::guess_pressures()
  {
    if (is_consistent())
      {
        remember_begin_pressure();
        find_pressure(begin_velocity, viscous, time, begin_pressure);
        extrapolate_pressure();
      }
    else
      {
        copy_owned(pressure, old_pressure);
        if (is_within_reach(mean_span) && second_order)
          pressure.add(.5 * (dt + mean_span), pressure_rate);
      }
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::remember_begin_pressure()
  {
    if (was_short)
      {
        // That of the short step's beginning is too near.
        pressure_span += last_dt;
        if (older_pressure_span > 0.)
          older_pressure_span += last_dt;
        return;
      }
    copy_owned(older_begin_pressure, old_begin_pressure);
    copy_owned(old_begin_pressure, begin_pressure);
    older_pressure_span = pressure_span > 0. ? pressure_span + last_dt : 0.;
    pressure_span       = last_dt;
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::extrapolate_pressure()
  {
    copy_owned(end_pressure, begin_pressure);
    if (!is_within_reach(pressure_span) || !second_order)
      return;
    // The slope over the last two steps does not see what alternates from
    // step to step; that over the last one would return it three times as
    // large.
    const bool    two     = older_pressure_span > 0.;
    const Vector &earlier = two ? older_begin_pressure : old_begin_pressure;
    const double  ratio   = dt / (two ? older_pressure_span : pressure_span);
    end_pressure.add(ratio, begin_pressure);
    end_pressure.add(-ratio, earlier);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::find_pressure_gradients()
  {
    if (is_consistent() && has_solution)
      find_pressure(end_velocity, end_viscous, time + dt, end_pressure);
    if (!is_consistent())
      {
        if (parameters.step.pressure_gamma == 0)
          {
            pressure      = 0.;
            pressure_rate = 0.;
          }
        copy_owned(begin_pressure, pressure);
        copy_owned(end_pressure, pressure);
        begin_pressure.add(-.5 * dt, pressure_rate);
        end_pressure.add(.5 * dt, pressure_rate);
      }
    for (Vector *p : {&begin_pressure, &end_pressure})
      {
        if (parameters.step.pressure_gamma == 1)
          explicit_boundary->apply_open(*p, 1. / fluid.density);
        explicit_space->interpolate(*p, 1);
      }
    explicit_step->pressure_acceleration(begin_pressure,
                                         begin_gradient); // (79)
    explicit_step->pressure_acceleration(end_pressure, end_gradient);
    copy_owned(pressure_gradient, begin_gradient);
    pressure_gradient.add(1., end_gradient);
    pressure_gradient *= .5;
    velocity_space->interpolate(pressure_gradient, dim);

    Vector mean = begin_pressure;
    mean.add(1., end_pressure);
    mean *= .5;
    explicit_space->interpolate(mean, 1);
    if (explicit_space == pressure_space.get())
      copy_owned(pressure, mean);
    else
      copy_to_vertices(*explicit_space, mean, *pressure_space, pressure, 1);
    pressure_space->interpolate(pressure, 1);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::keep(const State<dim> &state)
  {
    state.values().value("time", time);
    state.values().value("last step", last_dt);
    state.values().value("last step was short", was_short);
    state.values().value("usual step", usual_dt);
    state.values().value("span of the old velocity", known_span);
    state.values().value("span of the old pressure", pressure_span);
    state.values().value("span of the older pressure", older_pressure_span);
    state.values().value("span of the mean pressure", mean_span);
    state.values().value("pressure time", view.pressure_time);
    const LagrangeSpace<dim> &V = *velocity_space;
    state.field("velocity", V, begin_velocity, dim);
    state.field("velocity at end", V, end_velocity, dim);
    state.field("old velocity", V, old_velocity, dim);
    state.field("viscous acceleration", V, viscous, dim);
    state.field("viscous acceleration at end", V, end_viscous, dim);
    state.field("smooth acceleration at end", V, end_smooth, dim);
    state.field("pressure gradient at begin", V, begin_gradient, dim);
    state.field("pressure gradient at end", V, end_gradient, dim);
    state.field("reaction", V, reaction, dim);
    state.field("traction", V, traction, dim);
    state.field("older explicit pressure",
                *explicit_space,
                older_begin_pressure,
                1);
    state.field("old explicit pressure",
                *explicit_space,
                old_begin_pressure,
                1);
    state.field("explicit pressure at begin",
                *explicit_space,
                begin_pressure,
                1);
    state.field("explicit pressure at end", *explicit_space, end_pressure, 1);
    state.field("explicit pressure", *pressure_space, pressure, 1);
    state.field("pressure", *pressure_space, new_pressure, 1);
    state.field("old pressure", *pressure_space, old_pressure, 1);
    state.field("pressure rate", *pressure_space, pressure_rate, 1);
    state.field("impulse of the pressure",
                *pressure_space,
                pressure_impulse,
                1);
    state.field("impulse of the forces", V, force_impulse, dim);
    state.field("physical pressure", *pressure_space, physical_pressure, 1);
  }



  template void
  SingleFluidFlow<2>::keep(const State<2> &);
  template void
  SingleFluidFlow<3>::keep(const State<3> &);
  template void
  SingleFluidFlow<2>::make_explicit_space();
  template void
  SingleFluidFlow<3>::make_explicit_space();
  template void
  SingleFluidFlow<2>::guess_pressures();
  template void
  SingleFluidFlow<3>::guess_pressures();
  template void
  SingleFluidFlow<2>::remember_begin_pressure();
  template void
  SingleFluidFlow<2>::extrapolate_pressure();
  template void
  SingleFluidFlow<3>::remember_begin_pressure();
  template void
  SingleFluidFlow<3>::extrapolate_pressure();
  template void
  SingleFluidFlow<2>::find_pressure_gradients();
  template void
  SingleFluidFlow<3>::find_pressure_gradients();
} // namespace Thalweg
