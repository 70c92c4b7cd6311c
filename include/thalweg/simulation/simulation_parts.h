// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_simulation_parts_h
#define thalweg_simulation_simulation_parts_h

#include <thalweg/particles/carried_population.h>
#include <thalweg/simulation/simulation_parameters.h>

#include <deal.II/base/function.h>

#include <memory>

namespace Thalweg
{
  /**
   * @brief All that stands on the mesh: made anew for each mesh, with the
   * same state.
   */
  template <int dim>
  class SimulationParts
  {
  public:
    /// All arguments must outlive the object; the mesh exists.
    SimulationParts(SimulationParameters<dim> &parameters,
                    Context                   &context,
                    Mesh<dim>                 &mesh);

    ~SimulationParts();

    /**
     * @brief Makes everything but the particles anew on the present mesh,
     * with zero fields. Collective.
     */
    void
    build();

    /// Removes all particles, drops and bubbles among them.
    void
    clear_particles();

    /// Builds, removes all particles, seeds new ones, and sets the state at
    /// the start. Collective.
    void
    set_initial_state();

    /// Refuses given velocities that do not suit an incompressible fluid at
    /// @p time. Collective. @throws dealii::ExcMessage
    void
    check_flux_balance(const double time) const;

    /// The same for the end of a step, if it can differ from that at the
    /// start.
    void
    check_flux_balance_of_step(const double end) const;

    /// Names what build() must know of the first mesh.
    void
    keep_constants(const Archive &archive);

    /// Names what the next step starts from.
    void
    keep(const State<dim> &state);

    /// Finds what follows from the state. Collective.
    void
    update();

    Population<dim> &
    particles()
    {
      return population;
    }

    /// Drops and bubbles, of which there may be none.
    Population<dim> &
    dispersed()
    {
      return dispersed_;
    }

    /// What moves them; nullptr where there can be none.
    const DispersedPhase<dim> *
    dispersed_phase() const
    {
      return dispersed_phase_.get();
    }

    const NodeSpace<dim> &
    nodes() const
    {
      return *space;
    }

    const PhaseField<dim> &
    phases() const
    {
      return *phase;
    }

    /// What of each fluid came in and went out.
    const VolumeBooks &
    books() const
    {
      return exchange->books();
    }

    /// What particles but drops and bubbles carry of both fluids, with what
    /// waits at boundaries for new ones, m^dim. Collective.
    FluidVolumes
    carried_volumes() const;

    /// What drops and bubbles carry, m^dim. Collective.
    FluidVolumes
    dispersed_volumes() const;

  private:
    /// The same as carried_volumes() in each owned cell.
    std::vector<FluidVolumes>
    volumes_of_cells() const;

    /// What the mesh ought to show of both fluids in each owned cell: drops
    /// are a part of the second.
    std::vector<FluidVolumes>
    volumes_to_show() const;

    /// The largest level set value that particles carry, m. Collective.
    double
    find_carried_distance() const;

    std::map<dealii::types::boundary_id, WallKind>
    walls() const;

    /// The level set of what comes in through a boundary.
    InflowLevelSet<dim>
    inflow() const;

    /// The volume of the first fluid in a cell at the start, m^dim; nothing
    /// for a single fluid.
    std::function<double(const typename CellGraph<dim>::Cell &)>
    negative_volume(const dealii::Function<dim> &level_set) const;

    SimulationParameters<dim>                 &parameters;
    Context                                   &context;
    Mesh<dim>                                 &mesh;
    BoundaryConditions<dim>                    conditions;
    Population<dim>                            population;
    Population<dim>                            dispersed_;
    CarriedPopulation<dim>                     carried_population;
    CarriedPopulation<dim>                     carried_dispersed;
    double                                     carried_distance = 0;
    std::unique_ptr<NodeSpace<dim>>            space;
    std::unique_ptr<BoundaryNodes<dim>>        boundary;
    std::unique_ptr<StreamlineConvection<dim>> convection;
    std::unique_ptr<PathConvection<dim>>       paths;
    std::unique_ptr<DispersedPhase<dim>>       dispersed_phase_;
    std::unique_ptr<PopulationControl<dim>>    control;
    std::unique_ptr<BoundaryExchange<dim>>     exchange;
    std::unique_ptr<PhaseField<dim>>           phase;
  };
} // namespace Thalweg

#endif
