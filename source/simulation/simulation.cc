#include <thalweg/linear_algebra/krylov.h>
#include <thalweg/simulation/finite_state.h>
#include <thalweg/simulation/flow_quantities.h>
#include <thalweg/simulation/frame_record.h>
#include <thalweg/simulation/simulation.h>
#include <thalweg/simulation/statistics_columns.h>

#include <cmath>
#include <csignal>
#include <sstream>

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
            parameters.method->flow_fields()};
  }



  template <int dim>
  double
  Simulation<dim>::courant_rate(const Vector &velocity) const
  {
    double                rate  = 0;
    const CellGraph<dim> &graph = mesh.graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        double shortest = graph.cell(c).extent.norm();
        if (!graph.cell(c).axis_parallel)
          shortest = graph.iterator(c)->minimum_vertex_distance();
        for (unsigned int v = 0; v < graph.n_vertices; ++v)
          {
            double sum = 0, squares = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double u =
                  velocity.local_element(dim * parts->nodes().nodes(c)[v] + d);
                sum =
                  std::max(sum, std::abs(u) * graph.cell(c).inverse_extent[d]);
                squares += u * u;
              }
            rate = std::max(rate,
                            graph.cell(c).axis_parallel
                              ? sum
                              : std::sqrt(squares) / shortest);
          }
      }
    return dealii::Utilities::MPI::max(rate, context.communicator);
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
  Simulation<dim>::find_viscous_limit()
  {
    viscous = {fourier_rate(parameters.fluids, mesh),
               parameters.method->fourier_limit()};
  }



  template <int dim>
  void
  Simulation<dim>::choose_step()
  {
    rate = courant_rate(parameters.method->velocity());
    plan = parameters.time.next_step(time, rate, wanted_dt, viscous, last_dt);
    dt   = plan.size;
    check_courant_number(rate * dt);
  }



  template <int dim>
  void
  Simulation<dim>::give_up(const std::string &reason)
  {
    std::string advice;
    if (!context.output_directory.empty())
      {
        save();
        advice = " The state before the step is saved: change what may be the "
                 "cause, the tolerance or the number of iterations of the "
                 "solver or 'Time/Courant number', and go on with --resume.";
      }
    std::ostringstream message;
    message << "Step " << step + 1 << " (t = " << time
            << " s) failed again and again, at last with a size of " << dt
            << " s: " << reason << advice;
    throw SolverFailure(message.str());
  }



  template <int dim>
  void
  Simulation<dim>::advance()
  {
    constexpr unsigned int most_halvings = 4;
    parts->check_flux_balance_of_step(time + dt);
    before_step.save(*parts);
    const Archive row;
    context.statistics.keep(row, context.log);
    for (unsigned int n_halvings = 0;; ++n_halvings)
      try
        {
          // For warnings during the step.
          context.statistics.set("step", step + 1);
          context.statistics.set("time [s]", time);
          parameters.method->advance(time, dt);
          break;
        }
      catch (const SolverFailure &failure)
        {
          before_step.restore(*parts);
          // What the failed attempt counted is not of the step.
          context.statistics.keep(row.reader(), context.log);
          if (n_halvings == most_halvings)
            give_up(failure.what());
          dt *= .5;
          std::ostringstream message;
          message << "Step " << step + 1 << " (t = " << time
                  << " s) failed: " << failure.what()
                  << " It is repeated with half the size, " << dt << " s.";
          context.log.warning(message.str());
        }
    last_dt   = dt;
    wanted_dt = dt == plan.size ? plan.wanted : dt;
    time      = dt == plan.size ? plan.end : time + dt;
    ++step;
  }



  template <int dim>
  void
  Simulation<dim>::begin(const CheckpointOutline &checkpoint)
  {
    context.statistics.declare(leading_columns());
    if (context.is_root && !context.output_directory.empty())
      context.statistics.open(context.output_directory + "/statistics.csv",
                              context.resumed);
    Archive values;
    if (context.resumed)
      values = load_mesh(checkpoint);
    else
      {
        checkpoints.set_aside();
        start();
      }
    announce_frame(parameters.forces.frame(), context);
    postprocessors = parameters.postprocessors.chosen();
    for (Postprocessor<dim> *postprocessor : postprocessors)
      {
        postprocessor->check({mesh, parameters.fluids});
        postprocessor->initialize(context, view());
      }
    if (context.resumed)
      load_state(checkpoint, values);
    find_viscous_limit();
    parts->check_flux_balance(time);
    check_finite(view());
    announce();
    if (!context.resumed)
      postprocess();
  }



  template <int dim>
  int
  Simulation<dim>::run()
  {
    StopSignals       signals;
    StopSignals::Wish wish = StopSignals::Wish::nothing;
    CheckpointOutline checkpoint;
    if (context.resumed)
      {
        checkpoint = checkpoints.find_newest();
        if (parameters.time.is_over(checkpoint.time, checkpoint.step))
          {
            context.log.warning("The run has ended already. To go on, write a "
                                "later 'Time/End time'.");
            return 0;
          }
      }
    begin(checkpoint);
    while (!parameters.time.is_over(time, step) &&
           wish != StopSignals::Wish::stop)
      {
        choose_step();
        if (adaptation->before_step(step, dt))
          {
            find_viscous_limit();
            choose_step();
          }
        advance();
        check_finite(view());
        wish = signals.wish(context.communicator);
        record();
        postprocess();
        progress.report(step,
                        time,
                        parameters.time.end_time(),
                        dt,
                        rate * dt,
                        context.statistics.get("particles"),
                        parameters.time.is_over(time, step));
        context.statistics.end_row();
        save_if_due(wish);
      }
    progress.summarize(step);
    if (wish != StopSignals::Wish::stop)
      return 0;
    context.log.warning("Stopped by SIGTERM after step " +
                        std::to_string(step) +
                        ". To go on, run again with --resume.");
    return SIGTERM;
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
    statistics.set("Courant number", rate * dt);
    statistics.set("Fourier number", viscous.rate * dt);
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
