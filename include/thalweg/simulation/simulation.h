// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_simulation_h
#define thalweg_simulation_simulation_h

#include <thalweg/fields/expression.h>
#include <thalweg/simulation/checkpoint_store.h>
#include <thalweg/simulation/mesh_adaptation.h>
#include <thalweg/simulation/progress.h>
#include <thalweg/simulation/simulation_parameters.h>
#include <thalweg/simulation/step_snapshot.h>
#include <thalweg/simulation/stop_signals.h>

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Builds the parts from the input and runs.
   */
  template <int dim>
  class Simulation
  {
  public:
    /// @param parameters checked; must outlive the simulation
    /// @param settings the same as text, to be compared with those of a
    ///   checkpoint
    Simulation(const MPI_Comm             communicator,
               SimulationParameters<dim> &parameters,
               Context                   &context,
               const Settings            &settings = {});

    ~Simulation();

    /// From the start, or from the last checkpoint, to the end time or a
    /// signal to stop.
    /// @param signals that are caught
    /// @return 0, or the number of the signal
    int
    run(StopSignals &signals);

    /// The same, with signals caught meanwhile.
    int
    run();

    /// The state as postprocessors see it.
    SolutionView<dim>
    view() const;

  private:
    /// All that comes before the first step.
    /// @param checkpoint to go on from, if the run is resumed
    void
    begin(const CheckpointOutline &checkpoint);

    /// Makes mesh and state at the start.
    void
    start();

    void
    make_adaptation();

    /// Lets methods and couplings know the mesh.
    void
    create_methods();

    /// Makes the mesh of a checkpoint and what stands on it, but not yet its
    /// state.
    /// @return the values of the checkpoint
    Archive
    load_mesh(const CheckpointOutline &checkpoint);

    /// Reads the state of a checkpoint whose mesh was loaded.
    /// @param values of the checkpoint
    void
    load_state(const CheckpointOutline &checkpoint, const Archive &values);

    /// @throws dealii::ExcMessage if @p checkpoint is of another mesh or for
    ///   other fluids or methods
    void
    check(const CheckpointOutline &checkpoint) const;

    /// Whether what was read of @p checkpoint can be.
    /// @throws dealii::ExcMessage if not
    void
    check_numbers(const CheckpointOutline &checkpoint) const;

    /// Writes a checkpoint; if that fails, warns. Collective.
    /// @return whether there is one
    bool
    save();

    /// Writes a checkpoint if it is time to. Collective.
    /// @param wish what a signal said
    /// @return whether one is due and could not be written
    bool
    save_if_due(const StopSignals::Wish wish);

    /// Names what the run must know to go on.
    void
    keep(const State<dim> &state);

    /// What the log says before the first step.
    void
    announce();

    /// The next step as the parameters want it, and what its size follows
    /// from.
    void
    choose_step();

    /// One step, or what is left of it after failures. @throws StepFailure
    void
    advance();

    /// Begins the row of the statistics for a step that is to be made.
    void
    begin_row();

    /// The methods are what they were before the step, while couplings keep
    /// what they carried. @param row of the statistics before the step
    void
    repeat_step(const Archive &row);

    /// Makes the state and the row of the statistics what they were before
    /// the step. @param row of the statistics before the step
    void
    undo_step(const Archive &row);

    /// Saves the state and throws. @param reason of the last failure
    [[noreturn]] void
    give_up(const std::string &reason);

    /// Saves the state and throws. @param reason why the run cannot go on from
    ///   it, a sentence
    [[noreturn]] void
    stop_before_step(const std::string &reason);

    /// Saves the state and throws if an expression was no finite number on
    /// any process.
    void
    stop_for(const ExpressionFaults &faults);

    /// Makes the step that is planned: adapts the mesh, advances, evaluates.
    /// @return what signals said meanwhile
    StopSignals::Wish
    do_step(StopSignals &signals);

    /// The state is what it was before the step, and the run ends, if anything
    /// in it is no number.
    /// @param row the statistics before the step
    /// @param faults of expressions during the step
    /// @throws dealii::ExcMessage on all processes
    void
    check_step(const Archive &row, const ExpressionFaults &faults);

    /// Says how the run ended.
    int
    finish(const StopSignals &signals, const bool is_saved);

    /// @throws dealii::ExcMessage if the statistics have what is no number
    void
    check_statistics() const;

    /// All postprocessors look at the solution.
    void
    postprocess();

    /// The Courant number of the next step; 0: the method has none.
    double
    courant_number() const;

    /// Stops a run that has diverged. @throws dealii::ExcMessage
    void
    check_courant_number() const;

    void
    record();

    SimulationParameters<dim>        &parameters;
    MethodList<dim>                  &methods;
    CouplingList<dim>                &couplings;
    Context                          &context;
    const Settings                    settings;
    CheckpointStore                   checkpoints;
    Mesh<dim>                         mesh;
    std::vector<Postprocessor<dim> *> postprocessors;
    double                            time    = 0.;
    double                            last_dt = 0.;
    /// As last_dt, but without what was cut off to hit a time; 0: none yet.
    double       wanted_dt = 0.;
    unsigned int step      = 0;
    /// The next step: as planned, and as it is after failures.
    TimeControl::Step plan{0., 0., 0.};
    double            dt = 0.;
    StepNumbers       numbers;
    Progress          progress;

    std::unique_ptr<MeshAdaptation<dim>>  adaptation;
    StepSnapshot<dim>                     before_step;
    std::map<std::string, double>         timer_totals;
    unsigned int                          saved_step = 0;
    std::chrono::steady_clock::time_point saved_at;
  };
} // namespace Thalweg

#endif
