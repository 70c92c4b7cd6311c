// SPDX-License-Identifier: LGPL-2.1-or-later
// How a scalar makes a step.
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
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
    diffusion->update(medium().phase, capacity, conductivity);
  }



  template <int dim>
  void
  Scalar<dim>::add_increment(const Vector &before)
  {
    const auto &space = view->space;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        const auto                    &nodes = space.nodes(c);
        std::array<double, (1 << dim)> increment;
        bool                           is_zero = true;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          {
            increment[v] = view->field.local_element(nodes[v]) -
                           before.local_element(nodes[v]);
            is_zero = is_zero && increment[v] == 0.;
          }
        if (is_zero)
          continue;
        for (const auto &particle : population->in_cell(c))
          particle.properties()[property] +=
            Q1::value<dim>(increment, particle.reference());
      }
  }



  template <int dim>
  void
  Scalar<dim>::fill_unknown(const Vector &field)
  {
    const auto &space = view->space;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      for (const auto &particle : population->in_cell(c))
        {
          double &value = particle.properties()[property];
          if (!std::isnan(value))
            continue;
          const auto shape = Q1::values<dim>(particle.reference());
          value            = 0.;
          for (unsigned int v = 0; v < shape.size(); ++v)
            value += shape[v] * field.local_element(space.nodes(c)[v]);
        }
  }



  template <int dim>
  Vector
  Scalar<dim>::field_for_new_particles() const
  {
    Vector field(view->field);
    field.zero_out_ghost_values();
    for (unsigned int n = 0; n < field.locally_owned_size(); ++n)
      field.local_element(n) = std::clamp(field.local_element(n),
                                          projection->lower().local_element(n),
                                          projection->upper().local_element(n));
    diffusion->set_given(field, end_of_step);
    return field;
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
    Vector                     before(view->field);
    before.update_ghost_values();
    iterations += diffusion->advance(view->field, time, dt, supply);
    const MPI_Comm communicator = host->context.communicator;
    const double   all =
      dealii::Utilities::MPI::sum(supply.total(), communicator);
    const double inside =
      dealii::Utilities::MPI::sum(supply.source, communicator);
    supplied += inside;
    through += all - inside;
    add_increment(before);
  }



  template <int dim>
  void
  Scalar<dim>::project()
  {
    dealii::TimerOutput::Scope scope(host->context.timers, "scalars");
    const double               before = diffusion->content(view->field);
    projection->project(*population, property, view->field);
    fill_unknown(field_for_new_particles());
    update_operator();
    correction = 0.;
    if (dealii::Utilities::MPI::sum(medium().boundary.passable_faces().size(),
                                    host->context.communicator) > 0)
      return;
    correction = before - diffusion->content(view->field);
    give_back();
  }



  template <int dim>
  void
  Scalar<dim>::give_back()
  {
    Vector room;
    view->space.initialize_scalar(room);
    const Vector &bound =
      correction > 0. ? projection->upper() : projection->lower();
    for (unsigned int n = 0; n < room.locally_owned_size(); ++n)
      {
        const double distance =
          bound.local_element(n) - view->field.local_element(n);
        room.local_element(n) =
          correction > 0. ? std::max(0., distance) : std::min(0., distance);
      }
    const double all = diffusion->content(room);
    if (all == 0.)
      return;
    view->field.zero_out_ghost_values();
    view->field.add(correction / all, room);
    view->space.interpolate(view->field, 1);
  }



  template <int dim>
  void
  Scalar<dim>::begin_step(const double time, const double dt)
  {
    end_of_step = time + dt;
    iterations  = 0;
    diffuse(time, .5 * dt);
  }



  template <int dim>
  void
  Scalar<dim>::advance(const double time, const double dt)
  {
    project();
    diffuse(time + .5 * dt, .5 * dt);
  }



#define THALWEG_INSTANTIATE_STEP(dim)                                   \
  template double Scalar<dim>::inflow(const dealii::types::boundary_id, \
                                      const dealii::Point<dim> &,       \
                                      const double) const;              \
  template void   Scalar<dim>::update_operator();                       \
  template void   Scalar<dim>::add_increment(const Vector &);           \
  template void   Scalar<dim>::fill_unknown(const Vector &);            \
  template Vector Scalar<dim>::field_for_new_particles() const;         \
  template void   Scalar<dim>::diffuse(const double, const double);     \
  template void   Scalar<dim>::project();                               \
  template void   Scalar<dim>::give_back();                             \
  template void   Scalar<dim>::begin_step(const double, const double);  \
  template void   Scalar<dim>::advance(const double, const double);
  THALWEG_INSTANTIATE_STEP(2)
  THALWEG_INSTANTIATE_STEP(3)
#undef THALWEG_INSTANTIATE_STEP
} // namespace Thalweg
