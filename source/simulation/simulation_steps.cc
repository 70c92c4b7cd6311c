// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of a run, and how they end.
#include <thalweg/core/errors.h>
#include <thalweg/simulation/finite_state.h>
#include <thalweg/simulation/simulation.h>

#include <sstream>

namespace Thalweg
{
  template <int dim>
  void
  Simulation<dim>::give_up(const std::string &reason)
  {
    const std::string advice =
      save() ? " The state before the step is saved: change what may be the "
               "cause, the tolerance or the number of iterations of the "
               "solver or 'Time/Courant number', and go on with --resume."
             : "";
    std::ostringstream message;
    message << "Step " << step + 1 << " (t = " << time
            << " s) failed again and again, at last with a size of " << dt
            << " s: " << reason << advice;
    throw StepFailure(message.str());
  }



  template <int dim>
  void
  Simulation<dim>::stop_before_step(const std::string &reason)
  {
    throw dealii::ExcMessage(
      reason +
      (save() ? " The state before that, after step " + std::to_string(step) +
                  ", is saved: change what may be the cause, and go "
                  "on with --resume."
              : ""));
  }



  template <int dim>
  void
  Simulation<dim>::stop_for(const ExpressionFaults &faults)
  {
    try
      {
        on_all(context.communicator, [&]() { faults.check(); });
      }
    catch (const dealii::ExcMessage &failure)
      {
        stop_before_step(message_of(failure));
      }
  }



  template <int dim>
  void
  Simulation<dim>::begin_row()
  {
    // For warnings during the step.
    context.statistics.set("step", step + 1);
    context.statistics.set("time [s]", time);
  }



  template <int dim>
  void
  Simulation<dim>::repeat_step(const Archive &row)
  {
    before_step.restore([&](const State<dim> &state) { methods.keep(state); });
    methods.update();
    // What the last pass counted is not of the next one.
    context.statistics.keep(row.reader(), context.log);
    begin_row();
  }



  template <int dim>
  void
  Simulation<dim>::undo_step(const Archive &row)
  {
    before_step.restore([&](const State<dim> &state) {
      methods.keep(state);
      couplings.keep(state);
    });
    methods.update();
    couplings.update();
    // What the failed attempt counted is not of the step.
    context.statistics.keep(row.reader(), context.log);
  }



  template <int dim>
  void
  Simulation<dim>::advance()
  {
    constexpr unsigned int most_halvings = 4;
    const ExpressionFaults faults;
    try
      {
        methods.check_conditions_of_step(time + dt);
      }
    catch (const dealii::ExcMessage &failure)
      {
        // It may be that a velocity was none, and counted as zero.
        stop_for(faults);
        stop_before_step(message_of(failure));
      }
    before_step.save([&](const State<dim> &state) {
      methods.keep(state);
      couplings.keep(state);
    });
    const Archive row;
    context.statistics.keep(row, context.log);
    for (unsigned int n_halvings = 0;; ++n_halvings)
      try
        {
          begin_row();
          parameters.scheme.advance(time, dt, context.statistics, [&]() {
            repeat_step(row);
          });
          break;
        }
      catch (const StepFailure &failure)
        {
          undo_step(row);
          stop_for(faults);
          if (n_halvings == most_halvings)
            give_up(failure.what());
          dt *= .5;
          std::ostringstream message;
          message << "Step " << step + 1 << " (t = " << time
                  << " s) failed: " << failure.what()
                  << " It is repeated with half the size, " << dt << " s.";
          context.log.warning(message.str());
        }
    check_step(row, faults);
  }



  template <int dim>
  void
  Simulation<dim>::check_step(const Archive          &row,
                              const ExpressionFaults &faults)
  {
    const double old_time = time, old_dt = last_dt, old_wanted = wanted_dt;
    const unsigned int old_step = step;
    last_dt                     = dt;
    wanted_dt                   = dt == plan.size ? plan.wanted : dt;
    time                        = dt == plan.size ? plan.end : time + dt;
    ++step;
    try
      {
        on_all(context.communicator, [&]() {
          faults.check();
          check_finite(view());
        });
      }
    catch (const dealii::ExcMessage &failure)
      {
        time      = old_time;
        last_dt   = old_dt;
        wanted_dt = old_wanted;
        step      = old_step;
        undo_step(row);
        stop_before_step(message_of(failure));
      }
  }



  template <int dim>
  int
  Simulation<dim>::run()
  {
    StopSignals signals(context.communicator);
    return run(signals);
  }



  template <int dim>
  int
  Simulation<dim>::run(StopSignals &signals)
  {
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
    signals.begin_steps();
    StopSignals::Wish wish     = StopSignals::Wish::nothing;
    bool              is_saved = true;
    while (!parameters.time.is_over(time, step) &&
           wish != StopSignals::Wish::stop)
      {
        wish     = do_step(signals);
        is_saved = !save_if_due(wish);
      }
    return finish(signals, is_saved);
  }



  template <int dim>
  StopSignals::Wish
  Simulation<dim>::do_step(StopSignals &signals)
  {
    try
      {
        choose_step();
        if (adaptation->before_step(step, dt))
          choose_step();
      }
    catch (const StepRefused &failure)
      {
        stop_before_step(message_of(failure));
      }
    advance();
    const StopSignals::Wish wish = signals.wish(context.communicator);
    record();
    check_statistics();
    postprocess();
    progress.report(step,
                    time,
                    parameters.time.end_time(),
                    dt,
                    courant_number(),
                    methods.headline(),
                    parameters.time.is_over(time, step));
    on_all(context.communicator, [&]() {
      if (context.lock != nullptr)
        context.lock->expect_directory();
      context.statistics.end_row();
    });
    return wish;
  }



  template <int dim>
  int
  Simulation<dim>::finish(const StopSignals &signals, const bool is_saved)
  {
    progress.summarize(step);
    if (signals.stopped_by() == 0)
      return 0;
    context.log.warning(
      std::string("Stopped by ") + signals.name() + " after step " +
      std::to_string(step) + ". " +
      (is_saved ? "To go on, run again with --resume."
                : "What was done since the last checkpoint is lost."));
    return signals.stopped_by();
  }



  template <int dim>
  void
  Simulation<dim>::check_statistics() const
  {
    on_all(context.communicator, [&]() {
      const std::string  column = context.statistics.column_without_number();
      std::ostringstream message;
      message << "After step " << step << " (t = " << time << " s) '" << column
              << "' in the statistics is no finite number. The run stops, "
                 "since nothing that follows would mean anything; with "
                 "--resume it goes on from the last checkpoint.";
      AssertThrow(column.empty(), dealii::ExcMessage(message.str()));
    });
  }



  template int
  Simulation<2>::run();
  template int
  Simulation<2>::run(StopSignals &);
  template void
  Simulation<2>::advance();
  template int
  Simulation<3>::run();
  template int
  Simulation<3>::run(StopSignals &);
  template void
  Simulation<3>::advance();
} // namespace Thalweg
