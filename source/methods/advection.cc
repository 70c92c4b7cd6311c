// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/expression.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/methods/advection.h>

namespace Thalweg
{
  template <int dim>
  Advection<dim>::Advection()
    : FlowMethod<dim>(/*computes_flow=*/false)
  {}



  template <int dim>
  void
  Advection<dim>::declare_parameters(const Section &section)
  {
    section.add("Velocity",
                expression,
                "m/s",
                "The velocity as a function of x, y, z and t, a semicolon "
                "between the components. It is interpolated at the nodes in "
                "the middle of each step.",
                dealii::Patterns::Anything());
  }



  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  Advection<dim>::parse() const
  {
    return parse_expression<dim>(expression, dim, "Method/advection/Velocity");
  }



  template <int dim>
  void
  Advection<dim>::check_parameters() const
  {
    parse();
  }



  template <int dim>
  void
  Advection<dim>::attach_fields()
  {
    numbers =
      std::make_unique<FlowStepNumbers<dim>>(parts->space, parts->fluids);
    function = parse();
    for (Vector *vector : {&convecting_velocity, &projected_velocity})
      parts->space.initialize_velocity(*vector);
    parts->space.initialize_scalar(level_set);
  }



  template <int dim>
  void
  Advection<dim>::initialize_fields(
    const typename InterfaceFlow<dim>::Start &start)
  {
    convecting_velocity = start.nodal_velocity;
    projected_velocity  = start.nodal_velocity;
    level_set           = start.nodal_level_set;
    parts->projection.project(parts->population,
                              parts->space,
                              parts->fluids,
                              projected_velocity,
                              level_set);
    parts->phase.rebuild(level_set);
    set_velocity(0.);
  }



  template <int dim>
  void
  Advection<dim>::keep_fields(const State<dim> &state)
  {
    state.field("convecting velocity", parts->space, convecting_velocity, dim);
    state.field("projected velocity", parts->space, projected_velocity, dim);
    state.field("level set", parts->space, level_set, 1);
  }



  template <int dim>
  void
  Advection<dim>::update()
  {
    parts->phase.rebuild(level_set);
  }



  template <int dim>
  void
  Advection<dim>::repopulate_cells()
  {
    repopulate_in_place(*parts, parts->space, projected_velocity, level_set);
  }



  template <int dim>
  void
  Advection<dim>::set_velocity(const double time)
  {
    function->set_time(time);
    interpolate_function(parts->space, *function, convecting_velocity);
    parts->space.copy_to_cells(convecting_velocity, cell_velocity);
    Vector &v = parts->flow.velocity();
    v.copy_locally_owned_data_from(convecting_velocity);
    parts->space.interpolate(v, dim);
  }



  template <int dim>
  void
  Advection<dim>::advance(const double time, const double dt)
  {
    auto &timers = parts->context.timers;
    set_velocity(time + .5 * dt);
    // New particles take the level set without the shift, as the others
    // carry it: else the shifts of all steps would add up in them.
    parts->space.copy_to_cells(level_set, cell_level_set);
    ConvectionReport report;
    unsigned int     n_added, n_removed;
    {
      dealii::TimerOutput::Scope scope(timers, "convection");
      report = parts->convection.move(parts->population, cell_velocity, dt);
    }
    {
      dealii::TimerOutput::Scope scope(timers, "population");
      n_added = pass_boundaries(
        *parts, report, convecting_velocity, cell_velocity, time + .5 * dt, dt);
      n_added += parts->control.fill_empty_cells(parts->population,
                                                 cell_velocity,
                                                 cell_level_set,
                                                 dt);
      n_removed = parts->control.limit(parts->population);
    }
    {
      dealii::TimerOutput::Scope scope(timers, "projection");
      parts->projection.project(parts->population,
                                parts->space,
                                parts->fluids,
                                projected_velocity,
                                level_set); // (69)
    }
    {
      dealii::TimerOutput::Scope scope(timers, "interface");
      parts->phase.rebuild(level_set);
    }
    record_particles(*parts, report, n_added, n_removed);
  }



  THALWEG_INSTANTIATE(Advection)
  THALWEG_REGISTER(Method,
                   Advection,
                   "advection",
                   "particles and interface move in a prescribed velocity")
} // namespace Thalweg
