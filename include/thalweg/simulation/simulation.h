#ifndef thalweg_simulation_simulation_h
#define thalweg_simulation_simulation_h

#include <thalweg/adaptation/adaptive_refinement.h>
#include <thalweg/adaptation/load_balance.h>
#include <thalweg/methods/method.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/simulation/progress.h>
#include <thalweg/simulation/time_control.h>

#include <memory>
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

    /// Appends every fault that can be found without running to @p faults:
    /// fluids, expressions, times, and on the coarse mesh boundary names and
    /// what the postprocessors look at.
    void
    check(std::vector<std::string> &faults) const;

    MeshParameters<dim>         mesh;
    AdaptiveRefinement<dim>     adaptive;
    LoadBalance<dim>            balance;
    TimeControl                 time;
    Fluids                      fluids;
    BodyForces<dim>             forces;
    BoundaryConditionParameters boundary_conditions;
    std::string initial_velocity  = dim == 2 ? "0; 0" : "0; 0; 0";
    std::string initial_level_set = "1";
    /// "sign" or "distance"
    std::string particles_carry = "distance";
    /// In smallest cell sizes: greater distances are cut off there.
    double                      distance_band = 1.;
    SeedingParameters           seeding;
    ConvectionParameters        convection;
    PopulationParameters<dim>   population;
    InterfaceParameters         interface;
    Choice<Projection<dim>>     projection;
    Choice<FluidSolver<dim>>    fluid_solver;
    Choice<Method<dim>>         method;
    Choices<Postprocessor<dim>> postprocessors;
  };

  /**
   * @brief Builds the parts from the input and runs.
   */
  template <int dim>
  class Simulation
  {
  public:
    /// @param parameters checked; must outlive the simulation
    Simulation(const MPI_Comm             communicator,
               SimulationParameters<dim> &parameters,
               Context                   &context);

    ~Simulation();

    /// From the start to the end time.
    void
    run();

    /// The state as postprocessors see it.
    SolutionView<dim>
    view() const;

  private:
    void
    initialize();

    /// The largest level set value that particles carry. Collective.
    double
    carried_distance() const;

    /// The Courant number of a step of one second, 1/s. Collective.
    double
    courant_rate(const Vector &velocity) const;

    /// Stops a run that has diverged. @throws dealii::ExcMessage
    void
    check_courant_number(const double courant_number) const;

    void
    record(const double dt);

    SimulationParameters<dim> &parameters;
    Context                   &context;
    Mesh<dim>                  mesh;
    double                     time    = 0.;
    double                     last_dt = 0.;
    unsigned int               step    = 0;
    Progress                   progress;

    std::unique_ptr<NodeSpace<dim>>            space;
    std::unique_ptr<BoundaryConditions<dim>>   conditions;
    std::unique_ptr<BoundaryNodes<dim>>        boundary;
    std::unique_ptr<Population<dim>>           population;
    std::unique_ptr<StreamlineConvection<dim>> convection;
    std::unique_ptr<PathConvection<dim>>       paths;
    std::unique_ptr<PopulationControl<dim>>    control;
    std::unique_ptr<PhaseField<dim>>           phase;
    std::map<std::string, double>              timer_totals;
  };
} // namespace Thalweg

#endif
