// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_simulation_parameters_h
#define thalweg_simulation_simulation_parameters_h

#include <thalweg/adaptation/adaptive_refinement.h>
#include <thalweg/adaptation/load_balance.h>
#include <thalweg/methods/method.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/simulation/checkpoint_parameters.h>
#include <thalweg/simulation/memory_estimate.h>
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
    void
    declare(const Section &root);

    /**
     * @brief Appends every fault that can be found without running to
     * @p faults: fluids, expressions, times, whether there is memory for the
     * cells, and on the coarse mesh boundary names and what the postprocessors
     * look at. Collective.
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
    /// @p before_run, fluids that are nowhere; a run sees that itself.
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

    /// @throws dealii::ExcMessage if the particles carry no fluid
    void
    check_distance_band() const;

    /// @throws dealii::ExcMessage if the mesh is to change and cannot
    void
    check_change() const;

    void
    declare_particles(const Section &section);

    /// Whether what the mesh does not see moves by itself.
    bool
    has_spray() const;

    /// That a tank that turns has no periodic boundaries around its axis.
    void
    check_turning(const Mesh<dim> &coarse) const;

    MeshParameters<dim>         mesh;
    AdaptiveRefinement<dim>     adaptive;
    LoadBalance<dim>            balance;
    CheckpointParameters        checkpoint;
    TimeControl                 time;
    Fluids                      fluids;
    BodyForces<dim>             forces;
    BoundaryConditionParameters boundary_conditions;
    std::string initial_velocity  = dim == 2 ? "0; 0" : "0; 0; 0";
    std::string initial_level_set = "1";
    /// "sign" or "distance"
    std::string particles_carry = "distance";
    /// In smallest cell sizes: greater distances are cut off there.
    double                    distance_band = 1.;
    SeedingParameters         seeding;
    ConvectionParameters      convection;
    PopulationParameters<dim> population;
    /// "automatic", "ballistic" or "none"
    std::string                 spray = "automatic";
    InterfaceParameters         interface;
    Choice<Projection<dim>>     projection;
    Choice<FluidSolver<dim>>    fluid_solver;
    Choice<Method<dim>>         method;
    Choices<Postprocessor<dim>> postprocessors;
    bool                        energy_budget = false;
  };
} // namespace Thalweg

#endif
