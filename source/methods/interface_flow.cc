// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/archive.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/flux_balance.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/interface/signed_distance.h>
#include <thalweg/methods/interface_flow.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// A level set as particles carry it: as it is, or its sign.
    double
    carried_level_set(const double value, const bool sign_only)
    {
      return sign_only ? (value < 0 ? -1. : 1.) : value;
    }

    /// The initial level set as particles carry it.
    template <int dim>
    class CarriedLevelSet : public dealii::Function<dim>
    {
    public:
      CarriedLevelSet(const dealii::Function<dim> &function,
                      const bool                   sign_only)
        : function(function)
        , sign_only(sign_only)
      {}

      double
      value(const dealii::Point<dim> &x,
            const unsigned int        component = 0) const override
      {
        return carried_level_set(function.value(x, component), sign_only);
      }

    private:
      const dealii::Function<dim> &function;
      const bool                   sign_only;
    };



    /// Whether the distance from where a function vanishes is anything else
    /// than the function, in the middle of any cell.
    template <int dim>
    bool
    is_no_distance(const SignedDistance<dim> &distance,
                   const CellGraph<dim>      &graph)
    {
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        if (!distance.is_function(Q1::center<dim>(graph.cell(c))))
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  InterfaceFlow<dim>::InterfaceFlow(FlowParameters<dim> &parameters,
                                    const Host<dim>     &host)
    : parameters(parameters)
    , context(host.context)
    , mesh(host.mesh)
    , forces(host.forces)
    , conditions(parameters.boundary_conditions, mesh)
    , population(mesh)
    , dispersed_(mesh)
    , carried_population(population)
    , carried_dispersed(dispersed_)
  {
    parameters.population.level_set_is_sign =
      parameters.particles_carry == "sign";
    if (parameters.particles_carry == "distance")
      {
        parameters.projection->band               = parameters.distance_band;
        parameters.projection->distances_are_kept = parameters.computes_flow;
      }
    parameters.population.carry_volume = parameters.fluids.size() == 2;
  }



  template <int dim>
  InterfaceFlow<dim>::~InterfaceFlow() = default;



  template <int dim>
  double
  InterfaceFlow<dim>::find_carried_distance() const
  {
    if (parameters.particles_carry == "sign")
      return 1.;
    return parameters.distance_band *
           dealii::Utilities::MPI::min(mesh.graph().minimal_extent(),
                                       context.communicator);
  }



  template <int dim>
  std::map<dealii::types::boundary_id, WallKind>
  InterfaceFlow<dim>::walls() const
  {
    std::map<dealii::types::boundary_id, WallKind> walls;
    for (const auto &[id, condition] : conditions.all())
      walls[id] = condition.kind == BoundaryKind::open ||
                      condition.kind == BoundaryKind::velocity
                    ? WallKind::open
                    : WallKind::wall;
    return walls;
  }



  template <int dim>
  InflowLevelSet<dim>
  InterfaceFlow<dim>::inflow() const
  {
    const bool          sign_only = parameters.particles_carry == "sign";
    const double        band      = carried_distance;
    InflowLevelSet<dim> inflow;
    for (const auto &[id, kind] : walls())
      if (kind == WallKind::open)
        {
          const auto &condition = conditions.all().at(id);
          if (const auto function = condition.inflow_level_set)
            inflow[id] = [=](const dealii::Point<dim> &x) {
              return carried_level_set(function->value(x), sign_only);
            };
          else
            {
              const std::string &fluid = condition.inflow_fluid;
              const double       value =
                band * Fluids::sign(fluid.empty()
                                      ? parameters.fluids.size() - 1
                                      : parameters.fluids.index(fluid));
              inflow[id] = [=](const dealii::Point<dim> &) { return value; };
            }
        }
    return inflow;
  }



  template <int dim>
  std::vector<FluidVolumes>
  InterfaceFlow<dim>::volumes_of_cells() const
  {
    auto volumes = population.volumes_of_cells();
    exchange->add_waiting(volumes);
    return volumes;
  }



  template <int dim>
  std::vector<FluidVolumes>
  InterfaceFlow<dim>::volumes_to_show() const
  {
    auto volumes = volumes_of_cells();
    if (!dispersed_phase)
      return volumes;
    const auto drops = dispersed_.volumes_of_cells();
    for (unsigned int c = 0; c < volumes.size(); ++c)
      volumes[c][1] += drops[c][0];
    return volumes;
  }



  template <int dim>
  void
  InterfaceFlow<dim>::build()
  {
    if (carried_distance == 0)
      carried_distance = find_carried_distance();
    space      = std::make_unique<NodeSpace<dim>>(mesh);
    boundary   = std::make_unique<BoundaryNodes<dim>>(*space, conditions);
    convection = std::make_unique<StreamlineConvection<dim>>(
      mesh,
      parameters.convection,
      walls(),
      parameters.computes_flow ? VelocityShape::evenly_divergent
                               : VelocityShape::multilinear);
    paths = std::make_unique<PathConvection<dim>>(mesh,
                                                  parameters.convection,
                                                  walls());
    if (parameters.has_spray())
      dispersed_phase =
        std::make_unique<DispersedPhase<dim>>(dispersed_,
                                              parameters.convection,
                                              walls());
    control  = std::make_unique<PopulationControl<dim>>(parameters.population,
                                                       *convection,
                                                       inflow());
    phase    = std::make_unique<PhaseField<dim>>(*space,
                                              parameters.fluids,
                                              parameters.interface);
    exchange = std::make_unique<BoundaryExchange<dim>>(
      *space,
      *boundary,
      inflow(),
      *convection,
      parameters.seeding.particles_per_direction);
    if (parameters.fluids.size() == 2)
      phase->carry([this]() { return volumes_to_show(); }, *boundary);
    parameters.interface_force->initialize(
      *space, conditions, *phase, parameters.interface.surface_tension);
    terms.attach(*space);
    viscosities.attach(*space, parameters.fluids);
    parameters.fluid_solver->initialize({context,
                                         *space,
                                         *boundary,
                                         *phase,
                                         forces,
                                         terms,
                                         viscosities,
                                         &*parameters.interface_force});
  }



  template <int dim>
  unsigned int
  InterfaceFlow<dim>::add_property(const std::string      &name,
                                   const InflowValue<dim> &inflow)
  {
    dispersed_.add_property(name);
    return population.add_property(name, inflow);
  }



  template <int dim>
  Parts<dim>
  InterfaceFlow<dim>::parts()
  {
    return {context,
            mesh,
            *space,
            parameters.fluids,
            forces,
            terms,
            viscosities,
            conditions,
            *boundary,
            population,
            *convection,
            *control,
            *parameters.projection,
            *phase,
            *parameters.fluid_solver,
            *paths,
            *exchange,
            dispersed_phase.get()};
  }



  template <int dim>
  std::function<double(const typename CellGraph<dim>::Cell &)>
  InterfaceFlow<dim>::negative_volume(
    const dealii::Function<dim> &level_set) const
  {
    if (parameters.fluids.size() == 1)
      return {};
    return [&level_set](const typename CellGraph<dim>::Cell &cell) {
      return sampled_negative_volume<dim>(cell, level_set);
    };
  }



  template <int dim>
  void
  InterfaceFlow<dim>::clear()
  {
    carried_population.clear();
    carried_dispersed.clear();
  }



  template <int dim>
  void
  InterfaceFlow<dim>::forget()
  {
    carried_distance = 0;
    phase.reset();
  }



  template <int dim>
  typename InterfaceFlow<dim>::Start
  InterfaceFlow<dim>::seed()
  {
    Start start;
    start.velocity = parse_expression<dim>(parameters.initial_velocity,
                                           dim,
                                           "Initial conditions/Velocity");
    const auto expression =
      parse_expression<dim>(parameters.initial_level_set,
                            1,
                            "Initial conditions/Level set");
    const SignedDistance<dim> distance(
      *expression,
      dealii::Utilities::MPI::min(mesh.graph().minimal_extent(),
                                  context.communicator));
    const bool sign_only = parameters.particles_carry == "sign";
    const bool searches  = parameters.particles_carry == "distance" &&
                          is_no_distance(distance, mesh.graph());
    const dealii::Function<dim> &level_set =
      dealii::Utilities::MPI::max<unsigned int>(searches, context.communicator)
        ? static_cast<const dealii::Function<dim> &>(distance)
        : *expression;
    clear();
    Thalweg::seed(population,
                  parameters.seeding,
                  *start.velocity,
                  CarriedLevelSet<dim>(level_set, sign_only),
                  negative_volume(level_set));
    exchange->open_books(population);

    space->initialize_velocity(start.nodal_velocity);
    space->initialize_scalar(start.nodal_level_set);
    interpolate_function(*space, *start.velocity, start.nodal_velocity);
    interpolate_function(*space, level_set, start.nodal_level_set);
    boundary->apply(start.nodal_velocity);
    space->interpolate(start.nodal_velocity, dim);
    return start;
  }



  template <int dim>
  void
  InterfaceFlow<dim>::check_flux_balance(const double time) const
  {
    if (parameters.computes_flow)
      Thalweg::check_flux_balance(conditions, mesh, time);
  }



  template <int dim>
  void
  InterfaceFlow<dim>::check_flux_balance_of_step(const double end) const
  {
    if (conditions.has_transient_velocity())
      check_flux_balance(end);
  }



  template <int dim>
  void
  InterfaceFlow<dim>::keep_constants(const Archive &archive)
  {
    archive.value("carried distance", carried_distance);
    AssertThrow(carried_distance >= 0. && std::isfinite(carried_distance),
                dealii::ExcMessage("the distance that its particles carry is "
                                   "damaged."));
  }



  template <int dim>
  void
  InterfaceFlow<dim>::keep(const State<dim> &state)
  {
    exchange->keep(state.values().enter("exchange"));
    population.keep(state.values().enter("particles"));
    state.carry("particles", carried_population);
    state.carry("drops and bubbles", carried_dispersed);
    parameters.fluid_solver->keep(state.enter("fluid solver"));
    watch.keep(state.values().enter("volume watch"));
  }



  THALWEG_INSTANTIATE(InterfaceFlow)
} // namespace Thalweg
