// What Simulation writes into checkpoints and reads from them.
#include <thalweg/core/errors.h>
#include <thalweg/simulation/run_directory.h>
#include <thalweg/simulation/simulation.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <sstream>

namespace Thalweg
{
  namespace
  {
    // The files of a checkpoint, beside those that deal.II calls mesh*.
    const std::string mesh_file   = "/mesh";
    const std::string values_file = "/values.cbor";

    std::string
    join(const std::vector<std::string> &sentences)
    {
      std::string text;
      for (const std::string &sentence : sentences)
        text += "\n  " + sentence;
      return text;
    }

    /// The values in the checkpoint in @p directory. Collective.
    Archive
    read_values(const MPI_Comm communicator, const std::string &directory)
    {
      std::string bytes;
      on_root(communicator,
              [&]() { bytes = read_file(directory + values_file); });
      return Archive::restore(
        dealii::Utilities::MPI::broadcast(communicator, bytes, 0));
    }
  } // namespace



  template <int dim>
  void
  Simulation<dim>::keep(const State<dim> &state)
  {
    const Archive &values = state.values();
    values.value("time", time);
    values.value("last step size", last_dt);
    values.value("wanted step size", wanted_dt);
    values.value("step", step);
    watch.keep(values.enter("volume watch"));
    context.statistics.keep(values.enter("statistics"), context.log);
    adaptation->keep(values.enter("adaptation"));
    parts->keep(state.enter("parts"));
    for (unsigned int i = 0; i < postprocessors.size(); ++i)
      {
        const std::string name =
          "postprocessor " + parameters.postprocessors.chosen_names()[i];
        if (!values.is_restoring() || values.has(name))
          postprocessors[i]->keep(state.enter(name));
        else
          context.log.warning("The " + name +
                              " was not used before the checkpoint: it starts "
                              "anew.");
      }
  }



  template <int dim>
  void
  Simulation<dim>::save()
  {
    if (context.output_directory.empty())
      return;
    dealii::TimerOutput::Scope scope(context.timers, "checkpoint");
    const std::string          directory = checkpoints.begin(step);
    const Archive              values;
    const State<dim>           state(values);
    parts->keep_constants(values.enter("constants"));
    keep(state);
    MeshTransfer<dim> transfer(mesh, parts->particles());
    transfer.pack(state, false);
    mesh.triangulation().save(directory + mesh_file);
    transfer.keep(values.enter("fields"));
    on_root(context.communicator,
            [&]() { write_file(directory + values_file, values.bytes()); });
    CheckpointOutline outline;
    outline.step        = step;
    outline.time        = time;
    outline.coarse_mesh = mesh.coarse_checksum();
    outline.cells_of_ranks =
      dealii::Utilities::MPI::all_gather(context.communicator,
                                         mesh.graph().n_owned_cells());
    outline.settings = settings;
    checkpoints.commit(outline);
    saved_step = step;
    saved_at   = std::chrono::steady_clock::now();
  }



  template <int dim>
  void
  Simulation<dim>::save_if_due(const StopSignals::Wish wish)
  {
    const auto &when    = parameters.checkpoint;
    const auto  elapsed = std::chrono::duration<double>(
      std::chrono::steady_clock::now() - saved_at);
    const bool is_due =
      wish != StopSignals::Wish::nothing ||
      (when.at_end && parameters.time.is_over(time, step)) ||
      (when.steps > 0 && step >= saved_step + when.steps) ||
      (when.minutes > 0 && elapsed.count() > 60. * when.minutes);
    // Clocks differ from process to process.
    if (dealii::Utilities::MPI::logical_or(is_due, context.communicator))
      save();
  }



  template <int dim>
  void
  Simulation<dim>::check(const CheckpointOutline &checkpoint) const
  {
    const SettingsDifference difference =
      compare(checkpoint.settings, settings);
    const std::string which = "The checkpoint '" + checkpoint.directory + "' ";
    AssertThrow(difference.critical.empty(),
                dealii::ExcMessage(
                  which + "is of a run with other parameters:" +
                  join(difference.critical) +
                  "\nGive them their old values, or start anew without "
                  "--resume."));
    AssertThrow(checkpoint.coarse_mesh == mesh.coarse_checksum(),
                dealii::ExcMessage(
                  which + "is of a run on another coarse mesh. Is a mesh file "
                          "another one now? Start anew without --resume."));
    if (!difference.others.empty())
      context.log.warning("Since the checkpoint these parameters have "
                          "changed:" +
                          join(difference.others));
  }



  template <int dim>
  Archive
  Simulation<dim>::load_mesh(const CheckpointOutline &checkpoint)
  {
    dealii::TimerOutput::Scope scope(context.timers, "setup");
    mesh.create_to_load(parameters.mesh);
    check(checkpoint);
    mesh.triangulation().load(checkpoint.directory + mesh_file);
    mesh.update();
    parts = std::make_unique<SimulationParts<dim>>(parameters, context, mesh);
    make_adaptation();
    const Archive values =
      read_values(context.communicator, checkpoint.directory);
    parts->keep_constants(values.enter("constants"));
    parts->build();
    return values;
  }



  template <int dim>
  void
  Simulation<dim>::load_state(const CheckpointOutline &checkpoint,
                              const Archive           &values)
  {
    dealii::TimerOutput::Scope scope(context.timers, "setup");
    const State<dim>           state(values);
    keep(state);
    MeshTransfer<dim> transfer(mesh, parts->particles());
    transfer.keep(values.enter("fields"));
    transfer.prepare_loaded();
    transfer.unpack(state);
    parts->update();
    saved_step = step;
    std::ostringstream message;
    message << "Going on from '" << checkpoint.directory << "', step " << step
            << ", t = " << time << " s";
    context.log.line(message.str());
  }



  template void
  Simulation<2>::keep(const State<2> &);
  template void
  Simulation<3>::keep(const State<3> &);
  template void
  Simulation<2>::save();
  template void
  Simulation<3>::save();
  template void
  Simulation<2>::save_if_due(const StopSignals::Wish);
  template void
  Simulation<3>::save_if_due(const StopSignals::Wish);
  template Archive
  Simulation<2>::load_mesh(const CheckpointOutline &);
  template Archive
  Simulation<3>::load_mesh(const CheckpointOutline &);
  template void
  Simulation<2>::load_state(const CheckpointOutline &, const Archive &);
  template void
  Simulation<3>::load_state(const CheckpointOutline &, const Archive &);
  template void
  Simulation<2>::check(const CheckpointOutline &) const;
  template void
  Simulation<3>::check(const CheckpointOutline &) const;
} // namespace Thalweg
