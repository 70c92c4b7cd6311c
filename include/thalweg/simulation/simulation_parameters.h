// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_simulation_parameters_h
#define thalweg_simulation_simulation_parameters_h

#include <thalweg/adaptation/adaptive_refinement.h>
#include <thalweg/adaptation/load_balance.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/simulation/checkpoint_parameters.h>
#include <thalweg/simulation/memory_estimate.h>
#include <thalweg/simulation/step_scheme.h>
#include <thalweg/simulation/time_control.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// Everything that the input file sets.
  template <int dim>
  struct SimulationParameters
  {
    /// Declares all sections.
    /// @param top the root of the input
    /// @param input says which methods are used: only these have sections
    void
    declare(const Section &top, const ParameterFile &input);

    /**
     * @brief Appends every fault that can be found without running to
     * @p faults: times, expressions, those of the method, whether there is
     * memory for the cells, and on the coarse mesh boundary names and what the
     * postprocessors look at. Collective.
     * @param communicator the processes of the run
     */
    void
    check(std::vector<std::string> &faults,
          const MPI_Comm            communicator = MPI_COMM_SELF) const;

    /// What memory the run may have. Collective.
    MemoryEstimate
    memory(const MPI_Comm communicator) const;

    /// What is suspicious in parameters without faults, without running: on
    /// the coarse mesh boundaries that lie on each other and, if
    /// @p before_run, what a run would see by itself.
    std::vector<std::string>
    warnings(const bool before_run) const;

    /// @throws dealii::ExcMessage in place of all other exceptions
    void
    make_coarse(Mesh<dim> &coarse) const;

    /// @throws dealii::ExcMessage if @p coarse, refined, has more cells than
    ///   there is @p memory for
    void
    check_size(const Mesh<dim> &coarse, const MemoryEstimate &memory) const;

    /// Appends the faults that are seen on the coarse mesh.
    void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const;

    /// @throws dealii::ExcMessage if the mesh is to change and cannot
    void
    check_change() const;

    /// That a tank that turns has no periodic boundaries around its axis.
    void
    check_turning(const Mesh<dim> &coarse) const;

    MeshParameters<dim>         mesh;
    AdaptiveRefinement<dim>     adaptive;
    LoadBalance<dim>            balance;
    CheckpointParameters        checkpoint;
    TimeControl                 time;
    BodyForces<dim>             forces;
    MethodList<dim>             methods;
    CouplingList<dim>           couplings;
    StepScheme<dim>             scheme{methods, couplings};
    Choices<Postprocessor<dim>> postprocessors;
  };
} // namespace Thalweg

#endif
