// SPDX-License-Identifier: LGPL-2.1-or-later
// What Simulation writes into checkpoints and reads from them.
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/simulation/finite_state.h>
#include <thalweg/simulation/simulation.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace Thalweg
{
  namespace
  {
    std::string
    join(const std::vector<std::string> &sentences)
    {
      std::string text;
      for (const std::string &sentence : sentences)
        text += "\n  " + sentence;
      return text;
    }

    /// The values of @p checkpoint. Collective.
    Archive
    read_values(const MPI_Comm           communicator,
                const CheckpointOutline &checkpoint)
    {
      std::string bytes;
      on_root(communicator, [&]() {
        bytes = read_file(checkpoint.directory + "/" + CheckpointNames::values);
      });
      return Archive::restore(
        dealii::Utilities::MPI::broadcast(communicator, bytes, 0));
    }



    /// Which cells of @p checkpoint come to this rank.
    SavedCells
    saved_cells(const MPI_Comm           communicator,
                const CheckpointOutline &checkpoint)
    {
      namespace MPI = dealii::Utilities::MPI;
      SavedCells saved;
      saved.place           = checkpoint.directory;
      saved.n_old_ranks     = checkpoint.cells.size();
      saved.n_ranks         = MPI::n_mpi_processes(communicator);
      std::uint64_t n_cells = 0;
      for (const CheckpointFile &file : checkpoint.cells)
        n_cells += file.n_cells;
      saved.first_of_rank.push_back(0);
      for (unsigned int r = 0; r < saved.n_ranks; ++r)
        saved.first_of_rank.push_back(saved.n_ranks == saved.n_old_ranks
                                        ? saved.first_of_rank.back() +
                                            checkpoint.cells[r].n_cells
                                        : n_cells * (r + 1) / saved.n_ranks);
      const auto rank = MPI::this_mpi_process(communicator);
      on_all(communicator, [&]() {
        saved.own = read_curve_cells(checkpoint,
                                     saved.first_of_rank[rank],
                                     saved.first_of_rank[rank + 1]);
      });
      return saved;
    }



    /// The numbers of the first cell of this rank among those of all, and of
    /// the first one behind.
    template <int dim>
    std::pair<std::uint64_t, std::uint64_t>
    cells_of_rank(const Mesh<dim> &mesh)
    {
      const std::uint64_t n     = mesh.graph().n_owned_cells();
      std::uint64_t       begin = 0;
      MPI_Exscan(&n,
                 &begin,
                 1,
                 MPI_UINT64_T,
                 MPI_SUM,
                 mesh.triangulation().get_communicator());
      return {begin, begin + n};
    }



    /// Does @p work, and lets its exceptions name @p checkpoint.
    template <typename Work>
    void
    with_name_of(const CheckpointOutline &checkpoint, const Work &work)
    {
      try
        {
          work();
        }
      catch (const dealii::ExcMessage &failure)
        {
          throw dealii::ExcMessage("The checkpoint '" + checkpoint.directory +
                                   "' cannot be used: " + message_of(failure));
        }
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
    context.statistics.keep(values.enter("statistics"), context.log);
    adaptation->keep(values.enter("adaptation"));
    methods.keep(state);
    couplings.keep(state);
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
  bool
  Simulation<dim>::save()
  {
    if (context.output_directory.empty())
      return false;
    dealii::TimerOutput::Scope scope(context.timers, "checkpoint");
    // Also where it fails: the next one is due as long after.
    saved_step = step;
    saved_at   = std::chrono::steady_clock::now();
    const Archive    values;
    const State<dim> state(values);
    methods.keep_constants(values.enter("constants"));
    keep(state);
    MeshTransfer<dim> transfer(mesh);
    CheckpointContent content;
    content.cells  = mesh.cells_on_curve();
    content.packed = transfer.pack_to_save(state);
    transfer.keep(values.enter("cells"));
    content.values = values.bytes();
    CheckpointOutline outline;
    outline.step              = step;
    outline.time              = time;
    outline.coarse_mesh       = mesh.coarse_checksum();
    outline.settings          = settings;
    const std::string failure = checkpoints.write(outline, content);
    if (!failure.empty())
      context.log.warning("The state after step " + std::to_string(step) +
                          " is not saved: " + failure +
                          " Checkpoints that are there remain.");
    return failure.empty();
  }



  template <int dim>
  bool
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
    return dealii::Utilities::MPI::logical_or(is_due, context.communicator) &&
           !save();
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
    mesh.load(parameters.mesh, saved_cells(context.communicator, checkpoint));
    create_methods();
    make_adaptation();
    Archive values;
    with_name_of(checkpoint, [&]() {
      values = read_values(context.communicator, checkpoint);
      methods.keep_constants(values.enter("constants"));
    });
    methods.attach();
    couplings.attach();
    return values;
  }



  template <int dim>
  void
  Simulation<dim>::check_numbers(const CheckpointOutline &checkpoint) const
  {
    const bool is_good = time == checkpoint.time && step == checkpoint.step &&
                         std::isfinite(last_dt) && last_dt >= 0. &&
                         std::isfinite(wanted_dt) && wanted_dt >= 0.;
    AssertThrow(is_good,
                dealii::ExcMessage("time or steps in its " +
                                   std::string(CheckpointNames::values) +
                                   " are wrong."));
  }



  template <int dim>
  void
  Simulation<dim>::load_state(const CheckpointOutline &checkpoint,
                              const Archive           &values)
  {
    dealii::TimerOutput::Scope scope(context.timers, "setup");
    const State<dim>           state(values);
    MeshTransfer<dim>          transfer(mesh);
    with_name_of(checkpoint, [&]() {
      keep(state);
      transfer.keep(values.enter("cells"));
      on_all(context.communicator, [&]() { check_numbers(checkpoint); });
    });
    const auto  own = cells_of_rank(mesh);
    PackedCells cells;
    on_all(context.communicator, [&]() {
      cells = read_packed_cells(checkpoint, own.first, own.second);
    });
    with_name_of(checkpoint, [&]() { transfer.unpack_saved(state, cells); });
    methods.update();
    couplings.update();
    with_name_of(checkpoint, [&]() {
      on_all(context.communicator, [&]() { check_finite(view()); });
    });
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
  template bool
  Simulation<2>::save();
  template bool
  Simulation<3>::save();
  template bool
  Simulation<2>::save_if_due(const StopSignals::Wish);
  template bool
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
