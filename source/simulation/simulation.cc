// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/simulation/finite_state.h>
#include <thalweg/simulation/frame_record.h>
#include <thalweg/simulation/simulation.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  Simulation<dim>::Simulation(const MPI_Comm             communicator,
                              SimulationParameters<dim> &parameters,
                              Context                   &context,
                              const Settings            &settings)
    : parameters(parameters)
    , methods(parameters.methods)
    , couplings(parameters.couplings)
    , context(context)
    , settings(settings)
    , checkpoints(context)
    , mesh(communicator)
    , progress(context)
    , saved_at(std::chrono::steady_clock::now())
  {}



  template <int dim>
  Simulation<dim>::~Simulation()
  {
    // Methods belong to the parameters, and the mesh goes before these.
    couplings.release();
    methods.release();
  }



  template <int dim>
  void
  Simulation<dim>::make_adaptation()
  {
    adaptation = std::make_unique<MeshAdaptation<dim>>(
      parameters, context, mesh, postprocessors, [this]() { return view(); });
  }



  template <int dim>
  void
  Simulation<dim>::create_methods()
  {
    parameters.forces.initialize(parameters.time.end_time());
    methods.create(context, mesh, parameters.forces);
    couplings.create(context, mesh, parameters.forces, methods.offers());
  }



  template <int dim>
  void
  Simulation<dim>::start()
  {
    dealii::TimerOutput::Scope scope(context.timers, "setup");
    mesh.create(parameters.mesh);
    create_methods();
    make_adaptation();
    methods.initialize();
    adaptation->adapt_to_initial_state();
    couplings.initialize();
  }



  template <int dim>
  SolutionView<dim>
  Simulation<dim>::view() const
  {
    return methods.view(mesh,
                        {time,
                         last_dt,
                         step,
                         parameters.time.end_time(),
                         parameters.time.is_over(time, step)});
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
    numbers = parameters.scheme.step_numbers();
    plan    = parameters.time.next_step(time, numbers, wanted_dt, last_dt);
    dt      = plan.size;
    check_courant_number();
  }



  template <int dim>
  void
  Simulation<dim>::begin(const CheckpointOutline &checkpoint)
  {
    std::vector<std::string> columns{"step", "time [s]", "dt [s]"};
    for (const auto &all : {methods.columns(), couplings.columns()})
      columns.insert(columns.end(), all.begin(), all.end());
    context.statistics.declare(columns);
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
        postprocessor->check(methods.outline(mesh, true));
        postprocessor->initialize(context, view());
      }
    if (context.resumed)
      load_state(checkpoint, values);
    methods.check_conditions(time);
    on_all(context.communicator, [&]() { check_finite(view()); });
    announce();
    if (!context.resumed)
      postprocess();
  }



  template <int dim>
  void
  Simulation<dim>::record()
  {
    auto &statistics = context.statistics;
    statistics.set("step", step);
    statistics.set("time [s]", time);
    statistics.set("dt [s]", dt);
    for (const StepNumber &number : numbers)
      statistics.set(number.title(), number.rate * dt);
    statistics.set("cells", mesh.triangulation().n_global_active_cells());
    methods.record(time);
    couplings.record(time);
    parameters.scheme.record(statistics);
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
