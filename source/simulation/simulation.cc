// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/simulation/finite_state.h>
#include <thalweg/simulation/flow_quantities.h>
#include <thalweg/simulation/frame_record.h>
#include <thalweg/simulation/simulation.h>
#include <thalweg/simulation/statistics_columns.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  Simulation<dim>::Simulation(const MPI_Comm             communicator,
                              SimulationParameters<dim> &parameters,
                              Context                   &context,
                              const Settings            &settings)
    : parameters(parameters)
    , context(context)
    , settings(settings)
    , checkpoints(context)
    , mesh(communicator)
    , progress(context)
    , saved_at(std::chrono::steady_clock::now())
  {}



  template <int dim>
  Simulation<dim>::~Simulation() = default;



  template <int dim>
  void
  Simulation<dim>::make_adaptation()
  {
    adaptation = std::make_unique<MeshAdaptation<dim>>(
      parameters, context, mesh, *parts, postprocessors, [this]() {
        return view();
      });
  }



  template <int dim>
  void
  Simulation<dim>::start()
  {
    dealii::TimerOutput::Scope scope(context.timers, "setup");
    mesh.create(parameters.mesh);
    parts = std::make_unique<SimulationParts<dim>>(parameters, context, mesh);
    make_adaptation();
    parts->set_initial_state();
    adaptation->adapt_to_initial_state();
  }



  template <int dim>
  SolutionView<dim>
  Simulation<dim>::view() const
  {
    return {mesh,
            parts->nodes(),
            parameters.fluids,
            parts->particles(),
            parameters.fluid_solver->velocity(),
            parameters.fluid_solver->pressure(),
            parts->phases().level_set(),
            time,
            last_dt,
            parameters.method->velocity_time(time),
            step,
            parameters.time.end_time(),
            parameters.time.is_over(time, step),
            parameters.method->flow_fields(),
            parts->dispersed_phase() ? &parts->dispersed() : nullptr};
  }



  template <int dim>
  void
  Simulation<dim>::postprocess()
  {
    dealii::TimerOutput::Scope scope(context.timers, "postprocessing");
    for (Postprocessor<dim> *postprocessor : postprocessors)
      postprocessor->execute(context, view());
  }



  template <int dim>
  void
  Simulation<dim>::choose_step()
  {
    numbers = parameters.method->step_numbers();
    plan    = parameters.time.next_step(time, numbers, wanted_dt, last_dt);
    dt      = plan.size;
    check_courant_number();
  }



  template <int dim>
  void
  Simulation<dim>::begin(const CheckpointOutline &checkpoint)
  {
    context.statistics.declare(leading_columns());
    context.has_energy_budget = parameters.energy_budget;
    if (!context.output_directory.empty())
      on_root(context.communicator, [&]() {
        context.statistics.open(context.output_directory + "/statistics.csv",
                                context.resumed);
      });
    Archive values;
    if (context.resumed)
      values = load_mesh(checkpoint);
    else
      start();
    announce_frame(parameters.forces.frame(), context);
    postprocessors = parameters.postprocessors.chosen();
    for (Postprocessor<dim> *postprocessor : postprocessors)
      {
        postprocessor->check(
          {mesh, parameters.fluids, true, parameters.has_spray()});
        postprocessor->initialize(context, view());
      }
    if (context.resumed)
      load_state(checkpoint, values);
    parts->check_flux_balance(time);
    on_all(context.communicator, [&]() { check_finite(view()); });
    announce();
    if (!context.resumed)
      postprocess();
  }



  template <int dim>
  void
  Simulation<dim>::record()
  {
    auto                  &statistics = context.statistics;
    const PhaseField<dim> &phase      = parts->phases();
    statistics.set("step", step);
    statistics.set("time [s]", time);
    statistics.set("dt [s]", dt);
    for (const StepNumber &number : numbers)
      statistics.set(number.name, number.rate * dt);
    statistics.set("cells", mesh.triangulation().n_global_active_cells());
    statistics.set("dofs", parts->nodes().n_dofs());
    statistics.set("volume 1 before shift [m^d]", phase.volume_before_shift());
    statistics.set("volume 1 [m^d]", phase.volume());
    statistics.set("volume 2 [m^d]", phase.total_volume() - phase.volume());
    record_volumes();
    statistics.set("level set shift", phase.shift());
    statistics.set("velocity time [s]", parameters.method->velocity_time(time));
    for (const auto &[name, value] :
         flow_quantities(view(), phase, parameters.forces.gravity(time)))
      statistics.set(name, value);
    record_frame(parameters.forces.frame(), time, statistics);
    adaptation->record();
    for (const auto &[name, seconds] :
         context.timers.get_summary_data(dealii::TimerOutput::total_wall_time))
      {
        statistics.set("wall " + name + " [s]", seconds - timer_totals[name]);
        timer_totals[name] = seconds;
      }
  }



  THALWEG_INSTANTIATE(Simulation)
} // namespace Thalweg
