#include <thalweg/core/archive.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/interface/signed_distance.h>
#include <thalweg/simulation/simulation_parts.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// The initial level set as particles carry it: as it is, or its sign.
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
        const double phi = function.value(x, component);
        return sign_only ? (phi < 0 ? -1. : 1.) : phi;
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
  SimulationParts<dim>::SimulationParts(SimulationParameters<dim> &parameters,
                                        Context                   &context,
                                        Mesh<dim>                 &mesh)
    : parameters(parameters)
    , context(context)
    , mesh(mesh)
    , conditions(parameters.boundary_conditions, mesh)
    , population(mesh)
  {
    parameters.forces.initialize();
    parameters.population.level_set_is_sign =
      parameters.particles_carry == "sign";
    if (parameters.particles_carry == "distance")
      parameters.projection->band = parameters.distance_band;
  }



  template <int dim>
  SimulationParts<dim>::~SimulationParts() = default;



  template <int dim>
  double
  SimulationParts<dim>::find_carried_distance() const
  {
    if (parameters.particles_carry == "sign")
      return 1.;
    return parameters.distance_band *
           dealii::Utilities::MPI::min(mesh.graph().minimal_extent(),
                                       context.communicator);
  }



  template <int dim>
  std::map<dealii::types::boundary_id, WallKind>
  SimulationParts<dim>::walls() const
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
  std::map<dealii::types::boundary_id, double>
  SimulationParts<dim>::inflow() const
  {
    std::map<dealii::types::boundary_id, double> inflow;
    for (const auto &[id, kind] : walls())
      if (kind == WallKind::open)
        {
          const std::string &fluid = conditions.all().at(id).inflow_fluid;
          inflow[id] =
            carried_distance * Fluids::sign(fluid.empty()
                                              ? parameters.fluids.size() - 1
                                              : parameters.fluids.index(fluid));
        }
    return inflow;
  }



  template <int dim>
  void
  SimulationParts<dim>::build()
  {
    if (carried_distance == 0)
      carried_distance = find_carried_distance();
    const double target_volume = phase ? phase->target_volume : 0.;
    space                      = std::make_unique<NodeSpace<dim>>(mesh);
    boundary = std::make_unique<BoundaryNodes<dim>>(*space, conditions);
    convection =
      std::make_unique<StreamlineConvection<dim>>(mesh,
                                                  parameters.convection,
                                                  walls());
    paths   = std::make_unique<PathConvection<dim>>(mesh,
                                                  parameters.convection,
                                                  walls());
    control = std::make_unique<PopulationControl<dim>>(parameters.population,
                                                       *convection,
                                                       inflow());
    phase   = std::make_unique<PhaseField<dim>>(*space,
                                              parameters.fluids,
                                              parameters.interface);
    phase->target_volume = target_volume;
    parameters.fluid_solver->initialize(
      context, *space, *boundary, *phase, parameters.forces);
    parameters.method->attach({context,
                               mesh,
                               *space,
                               parameters.fluids,
                               parameters.forces,
                               conditions,
                               *boundary,
                               population,
                               *convection,
                               *control,
                               *parameters.projection,
                               *phase,
                               *parameters.fluid_solver,
                               *paths});
  }



  template <int dim>
  void
  SimulationParts<dim>::set_initial_state()
  {
    carried_distance = 0;
    phase.reset();
    build();
    const auto velocity = parse_expression<dim>(parameters.initial_velocity,
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
    population.handler().clear_particles();
    seed(population,
         parameters.seeding,
         *velocity,
         CarriedLevelSet<dim>(level_set, sign_only));
    if (parameters.fluids.size() == 2)
      phase->target_volume = sampled_negative_volume<dim>(mesh.graph(),
                                                          level_set,
                                                          context.communicator);

    Vector initial_velocity, initial_level_set;
    space->initialize_velocity(initial_velocity);
    space->initialize_scalar(initial_level_set);
    interpolate_function(*space, *velocity, initial_velocity);
    interpolate_function(*space, level_set, initial_level_set);
    boundary->apply(initial_velocity);
    space->interpolate(initial_velocity, dim);
    parameters.method->initialize(*velocity,
                                  initial_velocity,
                                  initial_level_set);
    if (phase->target_volume == 0)
      phase->target_volume = phase->volume();
  }



  template <int dim>
  void
  SimulationParts<dim>::keep_constants(const Archive &archive)
  {
    archive.value("carried distance", carried_distance);
  }



  template <int dim>
  void
  SimulationParts<dim>::keep(const State<dim> &state)
  {
    state.values().value("target volume", phase->target_volume);
    population.keep(state.values().enter("particles"));
    parameters.fluid_solver->keep(state.enter("fluid solver"));
    parameters.method->keep(state.enter("method"));
  }



  template <int dim>
  void
  SimulationParts<dim>::update()
  {
    parameters.method->update();
  }



  THALWEG_INSTANTIATE(SimulationParts)
} // namespace Thalweg
