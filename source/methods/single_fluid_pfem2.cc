// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/vertex_values.h>
#include <thalweg/methods/single_fluid_pfem2.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  SingleFluidPfem2<dim>::SingleFluidPfem2()
    : FlowMethod<dim>(/*computes_flow=*/true)
  {}



  template <int dim>
  void
  SingleFluidPfem2<dim>::declare_parameters(const Section &section)
  {
    flow_parameters.declare_parameters(section);
    section.add("Corrector iterations",
                corrector_iterations,
                "",
                "How often a step is made again from its beginning, with the "
                "velocity and pressure found for its end (Eq. 63 with theta = "
                "1/2); 0: these are extrapolated from the last steps. Each "
                "costs as much as a step. Steps of second order whose `Viscous "
                "theta` is below 1 have at least one.",
                dealii::Patterns::Integer(0));
    section.add("Corrector tolerance",
                corrector_tolerance,
                "",
                "A step is made again as long as the velocity found for its "
                "end differs at some node from the one it was made with by "
                "more than this part of the largest velocity, but no more "
                "often than `Maximal corrector iterations` says.",
                dealii::Patterns::Double(0));
    section.add("Maximal corrector iterations",
                maximal_corrections,
                "",
                "How often a step is made again for the sake of `Corrector "
                "tolerance`. 0: never.",
                dealii::Patterns::Integer(0));
    section.add("First corrections",
                first_corrections,
                "",
                "The same at least for the first step, before which there is "
                "nothing to extrapolate from.",
                dealii::Patterns::Integer(0));
    section.add("Increment blend",
                blend,
                "",
                "The part of the particles' velocity that is replaced by the "
                "mesh's each step, which damps what the mesh does not see. 0: "
                "they take the increment only (Eq. 81e); 1: they take the "
                "mesh's velocity.",
                dealii::Patterns::Double(0, 1));
    projection.declare_parameters(section.enter("Projection"),
                                  "l2",
                                  "projection of the particles' velocity");
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::check_parameters() const
  {
    flow_parameters.check();
  }



  template <int dim>
  double
  SingleFluidPfem2<dim>::fourier_limit() const
  {
    const double theta = flow_parameters.step.viscous_theta;
    if (theta >= .5)
      return std::numeric_limits<double>::infinity();
    // (65) with the greatest eigenvalue of M^{-1} K on squares and cubes.
    const double eigenvalue = flow_parameters.velocity_degree == 2 ? 60.
                              : flow_parameters.is_lumped()        ? 4.
                                                                   : 12.;
    return 2. / (eigenvalue * dim * (1. - 2. * theta));
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::attach_fields()
  {
    AssertThrow(parts->fluids.size() == 1,
                dealii::ExcMessage(
                  "The method 'single fluid pfem2' is for one fluid: set "
                  "'Fluids/Number' to 1, or 'Method/Model' to 'pfem2'."));
    numbers = std::make_unique<FlowStepNumbers<dim>>(parts->space,
                                                     parts->fluids,
                                                     fourier_limit());
    flow    = std::make_unique<SingleFluidFlow<dim>>(parts->context,
                                                  parts->mesh,
                                                  flow_parameters,
                                                  parts->fluids[0],
                                                  parts->forces,
                                                  parts->terms,
                                                  parts->conditions);
    for (Vector *vector :
         {&begin_acceleration, &end_acceleration, &velocity_star})
      flow->space().initialize(*vector, dim);
    has_begun = false;
    parts->space.initialize_velocity(begin_velocity);
    parts->space.initialize_scalar(level_set);
    path.degree = flow->space().degree();
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::initialize_fields(
    const typename InterfaceFlow<dim>::Start &start)
  {
    level_set.copy_locally_owned_data_from(start.nodal_level_set);
    flow->initialize(*start.velocity);
    update();
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::keep_fields(const State<dim> &state)
  {
    flow->keep(state.enter("flow"));
    state.field("level set", parts->space, level_set, 1);
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::update()
  {
    parts->phase.rebuild(level_set);
    show_at_vertices();
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::repopulate_cells()
  {
    repopulate_in_place(*parts, flow->space(), flow->velocity(), level_set);
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::show_at_vertices()
  {
    copy_to_vertices(flow->space(),
                     flow->velocity(),
                     parts->space,
                     parts->flow.velocity(),
                     dim);
    copy_to_vertices(flow->space_of_pressure(),
                     flow->fields().pressure,
                     parts->space,
                     parts->flow.pressure(),
                     1);
  }



  template <int dim>
  const CellVelocity<dim> &
  SingleFluidPfem2<dim>::convecting_velocity_of_cells() const
  {
    mean_velocity.clear();
    if (!has_begun)
      return mean_velocity;
    Vector mean(begin_velocity);
    mean.zero_out_ghost_values();
    mean.sadd(.5, .5, parts->flow.velocity());
    parts->space.interpolate(mean, dim);
    parts->space.copy_to_cells(mean, mean_velocity);
    return mean_velocity;
  }



  template <int dim>
  unsigned int
  SingleFluidPfem2<dim>::n_given_corrections() const
  {
    // Viscosity below theta = 1 turns rough fields over from step to step;
    // extrapolation triples them with the wrong sign.
    const bool turns_over = flow_parameters.order == "second order" &&
                            flow_parameters.step.viscous_theta < 1.;
    unsigned int corrections =
      std::max(corrector_iterations, turns_over ? 1u : 0u);
    if (flow->is_at_start())
      corrections = std::max(corrections, first_corrections);
    return corrections;
  }



  template <int dim>
  bool
  SingleFluidPfem2<dim>::is_another_needed(const unsigned int n_passes) const
  {
    if (n_passes <= n_given_corrections())
      return true;
    return n_passes <= maximal_corrections &&
           flow->prediction_error() > corrector_tolerance;
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::move_particles(const double dt)
  {
    const LagrangeSpace<dim> &nodes = flow->space();
    nodes.copy_to_cells(flow->velocity(), path.begin_velocity);
    nodes.copy_to_cells(flow->convecting_velocity_at_end(), path.end_velocity);
    nodes.copy_to_cells(begin_acceleration, path.begin_acceleration);
    nodes.copy_to_cells(end_acceleration, path.end_acceleration);
    {
      dealii::TimerOutput::Scope scope(parts->context.timers, "convection");
      report = parts->paths.move(parts->population, path, dt);
    }
    dealii::TimerOutput::Scope scope(parts->context.timers, "population");
    n_added = parts->control.fill_empty_cells(
      parts->population, [&](const auto &cells, const auto &points) {
        return parts->paths.trace_back(cells, points, path, dt);
      });
  }



  template <int dim>
  void
  SingleFluidPfem2<dim>::advance(const double time, const double dt)
  {
    auto &timers = parts->context.timers;
    parts->forces.set_time(time + .5 * dt);
    parts->terms.set_time(time + .5 * dt);
    for (const char *column : {"pressure iterations", "viscous iterations"})
      parts->context.statistics.set(column, 0);
    begin_velocity.copy_locally_owned_data_from(parts->flow.velocity());
    has_begun = true;
    flow->start_step(time, dt);
    if (n_given_corrections() + maximal_corrections > 0)
      particles_at_start.save(parts->population);
    unsigned int n_passes = 0;
    for (; is_another_needed(n_passes); ++n_passes)
      {
        if (n_passes > 0)
          particles_at_start.restore(parts->population);
        {
          dealii::TimerOutput::Scope scope(timers, "accelerations");
          flow->find_accelerations(begin_acceleration,
                                   end_acceleration); // (77) to (80)
        }
        move_particles(dt); // (81a)
        {
          dealii::TimerOutput::Scope scope(timers, "projection");
          velocity_star.zero_out_ghost_values();
          velocity_star.copy_locally_owned_data_from(flow->velocity_at_end());
          flow->space().interpolate(velocity_star, dim);
          parts->context.statistics.set(
            "projection iterations",
            projection->project(parts->population,
                                flow->space(),
                                velocity_star)); // 1)
        }
        flow->solve(velocity_star); // (81b) to (81d)
      }
    parts->context.statistics.set("passes", n_passes);
    parts->context.statistics.set("prediction error", flow->prediction_error());
    {
      dealii::TimerOutput::Scope scope(timers, "increment");
      add_increment(parts->population,
                    flow->space(),
                    flow->velocity_at_end(),
                    velocity_star,
                    blend); // (81e)
    }
    unsigned int n_removed;
    {
      dealii::TimerOutput::Scope scope(timers, "population");
      n_removed = parts->control.limit(parts->population);
    }
    flow->end_step();
    show_at_vertices();
    record_particles(*parts, report, n_added, n_removed);
  }



  THALWEG_INSTANTIATE(SingleFluidPfem2)
  THALWEG_REGISTER(Method,
                   SingleFluidPfem2,
                   "single fluid pfem2",
                   "one fluid: explicit forces along the streamlines, an "
                   "incremental fractional step, second order (Eq. 81)")
} // namespace Thalweg
