// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_interface_flow_h
#define thalweg_methods_interface_flow_h

#include <thalweg/methods/flow_parameters.h>
#include <thalweg/methods/method.h>
#include <thalweg/methods/parts.h>
#include <thalweg/methods/volume_watch.h>
#include <thalweg/particles/carried_population.h>

#include <deal.II/base/function.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace Thalweg
{
  /**
   * @brief One fluid or two with an interface, on particles and on the mesh:
   * all that methods of such flows play on, made anew for each mesh.
   */
  template <int dim>
  class InterfaceFlow
  {
  public:
    /// What a flow starts from.
    struct Start
    {
      std::unique_ptr<dealii::Function<dim>> velocity;        ///< m/s
      Vector                                 nodal_velocity;  ///< ghosted, m/s
      Vector                                 nodal_level_set; ///< ghosted, m
    };

    /// Both must outlive the object; the mesh exists.
    InterfaceFlow(FlowParameters<dim> &parameters, const Host<dim> &host);

    ~InterfaceFlow();

    /**
     * @brief Makes everything but the particles anew on the present mesh,
     * with zero fields. Collective.
     */
    void
    build();

    /// Lets particles, drops and bubbles carry one value more, see
    /// ParticleHost.
    unsigned int
    add_property(const std::string &name, const InflowValue<dim> &inflow);

    Population<dim> &
    particles()
    {
      return population;
    }

    /// What there is now; valid until the next build().
    Parts<dim>
    parts();

    /// Forgets what is known of an earlier mesh, before build() for another
    /// start.
    void
    forget();

    /// Removes all particles, drops and bubbles among them.
    void
    clear();

    /// Removes all particles, and seeds those of the start. Collective.
    Start
    seed();

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

    /// The columns of the statistics with which those of a flow begin.
    static std::vector<std::string>
    columns();

    /// Writes what there is of both fluids, on particles and on the mesh, at
    /// @p time into the statistics, and warns of what is lost. Collective.
    void
    record_volumes(const double time);

    /// Warns if a fluid is nowhere. Collective.
    void
    warn_at_start() const;

    /// Drops and bubbles; nullptr where there can be none.
    const Population<dim> *
    dispersed() const
    {
      return dispersed_phase ? &dispersed_ : nullptr;
    }

  private:
    /// What particles but drops and bubbles carry of both fluids in each owned
    /// cell, with what waits at boundaries for new ones, m^dim.
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

    FlowParameters<dim>                       &parameters;
    Context                                   &context;
    Mesh<dim>                                 &mesh;
    BodyForces<dim>                           &forces;
    FlowTerms<dim>                             terms;
    FluidViscosities<dim>                      viscosities;
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
    std::unique_ptr<DispersedPhase<dim>>       dispersed_phase;
    std::unique_ptr<PopulationControl<dim>>    control;
    std::unique_ptr<BoundaryExchange<dim>>     exchange;
    std::unique_ptr<PhaseField<dim>>           phase;
    VolumeWatch                                watch;
  };
} // namespace Thalweg

#endif
