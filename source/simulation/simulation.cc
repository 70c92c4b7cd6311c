#include <thalweg/fields/expression.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/simulation/flow_quantities.h>
#include <thalweg/simulation/simulation.h>

#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// How the statistics begin; behind these stand the columns of the solver
    /// and the wall times.
    const std::vector<std::string> leading_columns{
      "step",
      "time [s]",
      "dt [s]",
      "Courant number",
      "Fourier number",
      "cells",
      "dofs",
      "particles",
      "particles added",
      "particles removed",
      "particles left",
      "particles lost",
      "volume 1 before shift [m^d]",
      "volume 1 [m^d]",
      "volume 2 [m^d]",
      "target volume 1 [m^d]",
      "level set shift",
      "velocity time [s]",
      "kinetic energy [J]",
      "potential energy [J]",
      "momentum x [kg m/s]",
      "momentum y [kg m/s]",
      "momentum z [kg m/s]",
      "max velocity 1 [m/s]",
      "max velocity 2 [m/s]"};



    /// The initial level set as particles carry it: cut off at a distance,
    /// or with that distance wherever it is not zero.
    template <int dim>
    class CarriedLevelSet : public dealii::Function<dim>
    {
    public:
      CarriedLevelSet(const dealii::Function<dim> &function,
                      const bool                   sign_only,
                      const double                 band)
        : function(function)
        , sign_only(sign_only)
        , band(band)
      {}

      double
      value(const dealii::Point<dim> &x,
            const unsigned int        component = 0) const override
      {
        const double phi = function.value(x, component);
        if (sign_only)
          return phi < 0 ? -1. : 1.;
        return std::max(-band, std::min(band, phi));
      }

    private:
      const dealii::Function<dim> &function;
      const bool                   sign_only;
      const double                 band;
    };
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const MPI_Comm             communicator,
                              SimulationParameters<dim> &parameters,
                              Context                   &context)
    : parameters(parameters)
    , context(context)
    , mesh(communicator)
    , progress(context)
  {}



  template <int dim>
  Simulation<dim>::~Simulation() = default;



  template <int dim>
  double
  Simulation<dim>::carried_distance() const
  {
    if (parameters.particles_carry == "sign")
      return 1.;
    return parameters.distance_band *
           dealii::Utilities::MPI::min(mesh.graph().minimal_extent(),
                                       context.communicator);
  }



  template <int dim>
  void
  Simulation<dim>::initialize()
  {
    mesh.create(parameters.mesh);
    parameters.forces.initialize();
    space = std::make_unique<NodeSpace<dim>>(mesh);
    conditions =
      std::make_unique<BoundaryConditions<dim>>(parameters.boundary_conditions,
                                                mesh);
    boundary   = std::make_unique<BoundaryNodes<dim>>(*space, *conditions);
    population = std::make_unique<Population<dim>>(mesh);

    std::map<dealii::types::boundary_id, WallKind> walls;
    std::map<dealii::types::boundary_id, double>   inflow;
    for (const auto &[id, condition] : conditions->all())
      {
        const bool passable = condition.kind == BoundaryKind::open ||
                              condition.kind == BoundaryKind::velocity;
        walls[id] = passable ? WallKind::open : WallKind::wall;
        if (passable)
          inflow[id] =
            carried_distance() *
            Fluids::sign(condition.inflow_fluid.empty()
                           ? parameters.fluids.size() - 1
                           : parameters.fluids.index(condition.inflow_fluid));
      }
    convection =
      std::make_unique<StreamlineConvection<dim>>(mesh,
                                                  parameters.convection,
                                                  walls);
    paths = std::make_unique<PathConvection<dim>>(mesh,
                                                  parameters.convection,
                                                  walls);
    parameters.population.level_set_is_sign =
      parameters.particles_carry == "sign";
    control = std::make_unique<PopulationControl<dim>>(parameters.population,
                                                       *convection,
                                                       inflow);
    phase   = std::make_unique<PhaseField<dim>>(*space,
                                              parameters.fluids,
                                              parameters.interface);
    parameters.fluid_solver->initialize(
      context, *space, *boundary, *phase, parameters.forces);

    const auto velocity = parse_expression<dim>(parameters.initial_velocity,
                                                dim,
                                                "Initial conditions/Velocity");
    const auto level_set =
      parse_expression<dim>(parameters.initial_level_set,
                            1,
                            "Initial conditions/Level set");
    seed(*population,
         parameters.seeding,
         *velocity,
         CarriedLevelSet<dim>(*level_set,
                              parameters.particles_carry == "sign",
                              carried_distance()));

    if (parameters.fluids.size() == 2)
      phase->target_volume = sampled_negative_volume<dim>(mesh.graph(),
                                                          *level_set,
                                                          context.communicator);

    Vector initial_velocity, initial_level_set;
    space->initialize_velocity(initial_velocity);
    space->initialize_scalar(initial_level_set);
    interpolate_function(*space, *velocity, initial_velocity);
    interpolate_function(*space,
                         static_cast<const dealii::Function<dim> &>(*level_set),
                         initial_level_set);
    boundary->apply(initial_velocity);
    space->interpolate(initial_velocity, dim);
    parameters.method->initialize({context,
                                   mesh,
                                   *space,
                                   parameters.fluids,
                                   parameters.forces,
                                   *conditions,
                                   *boundary,
                                   *population,
                                   *convection,
                                   *control,
                                   *parameters.projection,
                                   *phase,
                                   *parameters.fluid_solver,
                                   *paths,
                                   velocity.get()},
                                  initial_velocity,
                                  initial_level_set);
    if (phase->target_volume == 0)
      phase->target_volume = phase->volume();
  }



  template <int dim>
  SolutionView<dim>
  Simulation<dim>::view() const
  {
    return {mesh,
            *space,
            parameters.fluids,
            *population,
            parameters.fluid_solver->velocity(),
            parameters.fluid_solver->pressure(),
            phase->level_set(),
            time,
            last_dt,
            parameters.method->velocity_time(time),
            step,
            parameters.time.end_time(),
            parameters.time.is_over(time, step),
            parameters.method->flow_fields()};
  }



  template <int dim>
  double
  Simulation<dim>::courant_rate(const Vector &velocity) const
  {
    double                rate  = 0;
    const CellGraph<dim> &graph = mesh.graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        double shortest = graph.cell(c).extent.norm();
        if (!graph.cell(c).axis_parallel)
          shortest = graph.iterator(c)->minimum_vertex_distance();
        for (unsigned int v = 0; v < graph.n_vertices; ++v)
          {
            double sum = 0, squares = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double u =
                  velocity.local_element(dim * space->nodes(c)[v] + d);
                sum =
                  std::max(sum, std::abs(u) * graph.cell(c).inverse_extent[d]);
                squares += u * u;
              }
            rate = std::max(rate,
                            graph.cell(c).axis_parallel
                              ? sum
                              : std::sqrt(squares) / shortest);
          }
      }
    return dealii::Utilities::MPI::max(rate, context.communicator);
  }



  template <int dim>
  void
  Simulation<dim>::run()
  {
    context.statistics.declare(leading_columns);
    if (context.is_root && !context.output_directory.empty())
      context.statistics.open(context.output_directory + "/statistics.csv");
    {
      dealii::TimerOutput::Scope scope(context.timers, "setup");
      initialize();
    }
    context.log.line(
      std::to_string(mesh.triangulation().n_global_active_cells()) +
      " cells, " + std::to_string(space->n_dofs()) + " degrees of freedom, " +
      std::to_string(population->n_global_particles()) + " particles on " +
      std::to_string(
        dealii::Utilities::MPI::n_mpi_processes(context.communicator)) +
      " processes");
    const TimeControl::Viscous viscous{fourier_rate(parameters.fluids, mesh),
                                       parameters.method->fourier_limit()};
    const std::string          warning = parameters.time.warning(viscous);
    if (!warning.empty())
      context.log.warning(warning);
    const auto postprocessors = parameters.postprocessors.chosen();
    for (Postprocessor<dim> *postprocessor : postprocessors)
      {
        postprocessor->check({mesh, parameters.fluids});
        postprocessor->initialize(context, view());
      }
    {
      dealii::TimerOutput::Scope scope(context.timers, "postprocessing");
      for (Postprocessor<dim> *postprocessor : postprocessors)
        postprocessor->execute(context, view());
    }

    double old_dt = 0.; // none yet
    while (!parameters.time.is_over(time, step))
      {
        const double rate = courant_rate(parameters.method->velocity());
        const double dt =
          parameters.time.next_step(time, rate, old_dt, viscous);
        check_courant_number(rate * dt);
        parameters.method->advance(time, dt);
        time += dt;
        last_dt = dt;
        // A step cut short to hit a time does not hold back the next one.
        old_dt = std::max(dt, old_dt / 2.);
        ++step;
        context.statistics.set("Courant number", rate * dt);
        context.statistics.set("Fourier number", viscous.rate * dt);
        record(dt);
        {
          dealii::TimerOutput::Scope scope(context.timers, "postprocessing");
          for (Postprocessor<dim> *postprocessor : postprocessors)
            postprocessor->execute(context, view());
        }
        progress.report(step,
                        time,
                        parameters.time.end_time(),
                        dt,
                        rate * dt,
                        context.statistics.get("particles"),
                        parameters.time.is_over(time, step));
        context.statistics.end_row();
      }
    progress.summarize(step);
  }



  template <int dim>
  void
  Simulation<dim>::check_courant_number(const double courant_number) const
  {
    constexpr double largest = 1e4;
    if (std::isfinite(courant_number) && courant_number < largest)
      return;
    std::ostringstream message;
    message << "In step " << step + 1 << " (t = " << time
            << " s) the Courant number is " << courant_number
            << ": either the solution diverges, or the step is far too long. "
               "Reduce 'Time/Courant number' or 'Time/Time step', and check "
               "velocities and units in the input.";
    AssertThrow(false, dealii::ExcMessage(message.str()));
  }



  template <int dim>
  void
  Simulation<dim>::record(const double dt)
  {
    auto &statistics = context.statistics;
    statistics.set("step", step);
    statistics.set("time [s]", time);
    statistics.set("dt [s]", dt);
    statistics.set("cells", mesh.triangulation().n_global_active_cells());
    statistics.set("dofs", space->n_dofs());
    statistics.set("volume 1 before shift [m^d]", phase->volume_before_shift());
    statistics.set("volume 1 [m^d]", phase->volume());
    statistics.set("volume 2 [m^d]", phase->total_volume() - phase->volume());
    statistics.set("target volume 1 [m^d]", phase->target_volume);
    statistics.set("level set shift", phase->shift());
    statistics.set("velocity time [s]", parameters.method->velocity_time(time));
    for (const auto &[name, value] :
         flow_quantities(view(), *phase, parameters.forces.gravity()))
      statistics.set(name, value);
    for (const auto &[name, seconds] :
         context.timers.get_summary_data(dealii::TimerOutput::total_wall_time))
      {
        statistics.set("wall " + name + " [s]", seconds - timer_totals[name]);
        timer_totals[name] = seconds;
      }
  }



  THALWEG_INSTANTIATE(Simulation)
} // namespace Thalweg
