// SPDX-License-Identifier: LGPL-2.1-or-later
// How a scalar makes a step.
#include <thalweg/core/registry.h>
#include <thalweg/methods/scalar.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  template <int dim>
  double
  Scalar<dim>::inflow(const dealii::types::boundary_id id,
                      const dealii::Point<dim>        &place,
                      const double                     before_end) const
  {
    const auto &condition = conditions->at(id);
    if (condition.kind != ScalarBoundary::value)
      return Population<dim>::unknown;
    condition.function->set_time(end_of_step - before_end);
    return condition.function->value(place);
  }



  template <int dim>
  void
  Scalar<dim>::update_operator()
  {
    diffusion->update(medium().phase, capacity, conductivity, latent_heat);
  }



  template <int dim>
  Vector
  Scalar<dim>::heat_at_nodes(const Vector &value, const Vector &molten) const
  {
    Vector joined(value);
    if (parameters.melts())
      diffusion->melting().join(value, molten, joined);
    return joined;
  }



  template <int dim>
  template <typename Action>
  void
  Scalar<dim>::change_heat(const Action &action)
  {
    if (!parameters.melts())
      {
        action(view->field);
        return;
      }
    Vector heats = heat_at_nodes(view->field, view->molten);
    action(heats);
    diffusion->melting().find_value(heats, view->field);
    diffusion->melting().find_molten(heats, view->molten);
  }



  template <int dim>
  void
  Scalar<dim>::divide_heat()
  {
    change_heat([](Vector &) {});
  }



  template <int dim>
  double
  Scalar<dim>::content() const
  {
    if (medium().fluids.size() == 1 && !parameters.melts())
      return diffusion->content(view->field);
    if (medium().fluids.size() == 1)
      return diffusion->content(heat_at_nodes(view->field, view->molten));
    double sum = 0.;
    for (const Population<dim> *all :
         {static_cast<const Population<dim> *>(population),
          particles->dispersed()})
      if (all != nullptr)
        for (const auto &particle : all->particles())
          {
            const auto         row   = particle.properties();
            const unsigned int fluid = Population<dim>::fluid_of(row);
            if (!std::isnan(row[heat.value]))
              sum += row[Population<dim>::volume_offset] * capacity[fluid] *
                     heat.of(fluid, row);
          }
    return dealii::Utilities::MPI::sum(sum, host->context.communicator);
  }



  template <int dim>
  void
  Scalar<dim>::diffuse(const double time, const double dt)
  {
    const bool is_still = conductivity[0] == 0. && conductivity[1] == 0. &&
                          source == nullptr && conditions->all().empty();
    if (is_still)
      return;
    dealii::TimerOutput::Scope scope(host->context.timers, "scalars");
    ScalarSupply               supply;
    const Fields               before = fields();
    change_heat([&](Vector &heats) {
      iterations += diffusion->advance(heats, time, dt, supply);
    });
    const MPI_Comm communicator = host->context.communicator;
    supply.through = dealii::Utilities::MPI::sum(supply.through, communicator);
    supply.source  = dealii::Utilities::MPI::sum(supply.source, communicator);
    through += supply.through;
    supplied += supply.source;
    add_increment(before, supply.total());
  }



  template <int dim>
  void
  Scalar<dim>::project()
  {
    dealii::TimerOutput::Scope scope(host->context.timers, "scalars");
    project_particles();
    update_operator();
    if (parameters.melts())
      balance();
    // What particles beside a boundary have is theirs, whatever is given there.
    const bool is_closed =
      medium().fluids.size() == 1 &&
      dealii::Utilities::MPI::sum(medium().boundary.passable_faces().size(),
                                  host->context.communicator) == 0;
    change_heat([&](Vector &heats) {
      diffusion->set_given_heat(heats, end_of_step - half_step);
      if (is_closed)
        give_back(heats);
    });
    with_flow += content() - before_motion;
  }



  template <int dim>
  void
  Scalar<dim>::balance()
  {
    const Fields before = fields();
    divide_heat();
    add_increment(before, 0.);
  }



  template <int dim>
  void
  Scalar<dim>::give_back(Vector &heats)
  {
    correction = before_motion - diffusion->content(heats);
    const auto bound_of =
      [&](const ScalarProjection<dim> &bounds) -> const Vector & {
      return correction > 0. ? bounds.upper() : bounds.lower();
    };
    Vector room =
      heat_at_nodes(bound_of(*projection),
                    parameters.melts() ? bound_of(*molten_projection)
                                       : view->molten);
    for (unsigned int n = 0; n < room.locally_owned_size(); ++n)
      {
        const double distance = room.local_element(n) - heats.local_element(n);
        room.local_element(n) =
          correction > 0. ? std::max(0., distance) : std::min(0., distance);
      }
    room.zero_out_ghost_values();
    diffusion->clear_given(room);
    const double all = diffusion->content(room);
    if (all == 0.)
      return;
    heats.zero_out_ghost_values();
    heats.add(correction / all, room);
    view->space.interpolate(heats, 1);
  }



  template <int dim>
  void
  Scalar<dim>::begin_step(const double time, const double dt)
  {
    end_of_step = time + dt;
    half_step   = .5 * dt;
    iterations  = 0;
    correction  = 0.;
    diffuse(time, half_step);
    before_motion = content();
  }



  template <int dim>
  void
  Scalar<dim>::advance(const double time, const double dt)
  {
    project();
    diffuse(time + .5 * dt, .5 * dt);
  }



#define THALWEG_INSTANTIATE_STEP(dim)                                        \
  template double Scalar<dim>::inflow(const dealii::types::boundary_id,      \
                                      const dealii::Point<dim> &,            \
                                      const double) const;                   \
  template void   Scalar<dim>::divide_heat();                                \
  template void   Scalar<dim>::update_operator();                            \
  template Vector Scalar<dim>::heat_at_nodes(const Vector &, const Vector &) \
    const;                                                                   \
  template double Scalar<dim>::content() const;                              \
  template void   Scalar<dim>::diffuse(const double, const double);          \
  template void   Scalar<dim>::project();                                    \
  template void   Scalar<dim>::balance();                                    \
  template void   Scalar<dim>::give_back(Vector &);                          \
  template void   Scalar<dim>::begin_step(const double, const double);       \
  template void   Scalar<dim>::advance(const double, const double);
  THALWEG_INSTANTIATE_STEP(2)
  THALWEG_INSTANTIATE_STEP(3)
#undef THALWEG_INSTANTIATE_STEP
} // namespace Thalweg
