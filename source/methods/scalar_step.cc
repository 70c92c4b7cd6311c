// SPDX-License-Identifier: LGPL-2.1-or-later
// How a scalar makes a step.
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/methods/scalar.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Thalweg
{
  namespace
  {
    /// Those particles of a fluid in a cell that know the scalar.
    class KnownOnes
    {
    public:
      /// @param misfit of its value from what the field says there
      void
      add(const double value, const double misfit, const double volume)
      {
        least    = std::min(least, value);
        greatest = std::max(greatest, value);
        weights += volume;
        misfits += volume * misfit;
      }

      /// What a new one has where the field says @p value: if it gets its
      /// volume from them, so much that nothing is lost.
      double
      of_new_one(const double value) const
      {
        return weights > 0.
                 ? std::clamp(value + misfits / weights, least, greatest)
                 : value;
      }

    private:
      double least    = std::numeric_limits<double>::max();
      double greatest = std::numeric_limits<double>::lowest();
      double weights = 0., misfits = 0.;
    };
  } // namespace



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
  double
  Scalar<dim>::content() const
  {
    if (medium().fluids.size() == 1)
      return diffusion->content(view->field);
    double sum = 0.;
    for (const Population<dim> *all :
         {static_cast<const Population<dim> *>(population),
          particles->dispersed()})
      if (all != nullptr)
        for (const auto &particle : all->particles())
          {
            const auto properties = particle.properties();
            if (!std::isnan(properties[property]))
              sum += properties[Population<dim>::volume_offset] *
                     capacity[Population<dim>::fluid_of(properties)] *
                     properties[property];
          }
    return dealii::Utilities::MPI::sum(sum, host->context.communicator);
  }



  template <int dim>
  template <typename Add>
  void
  Scalar<dim>::for_each_increment(const Vector &before, const Add &add)
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
          {
            const auto properties = particle.properties();
            add(properties[property],
                Q1::value<dim>(increment, particle.reference()),
                properties[Population<dim>::volume_offset] *
                  capacity[Population<dim>::fluid_of(properties)]);
          }
      }
  }



  template <int dim>
  void
  Scalar<dim>::add_increment(const Vector &before, const double supply)
  {
    if (medium().fluids.size() == 1)
      {
        for_each_increment(before,
                           [](double &value, const double increment, double) {
                             value += increment;
                           });
        return;
      }
    // The particles' volumes are no quadrature: where the increments are, they
    // get what is missing, too.
    std::array<double, 2> sums{};
    for_each_increment(
      before, [&](double &, const double increment, const double mass) {
        sums[0] += mass * increment;
        sums[1] += mass * std::abs(increment);
      });
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(sums.data(), 2),
                                host->context.communicator,
                                dealii::ArrayView<double>(sums.data(), 2));
    const double missing = supply - sums[0];
    const double part    = sums[1] > 0. ? missing / sums[1] : 0.;
    correction += missing;
    for_each_increment(before,
                       [&](double &value, const double increment, double) {
                         value += increment + part * std::abs(increment);
                       });
  }



  template <int dim>
  void
  Scalar<dim>::fill_unknown(const Vector &field)
  {
    const auto &space = view->space;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        const auto particles_here = population->in_cell(c);
        bool       is_missing     = false;
        for (const auto &particle : particles_here)
          is_missing =
            is_missing || std::isnan(particle.properties()[property]);
        if (!is_missing)
          continue;
        std::array<double, (1 << dim)> nodal;
        for (unsigned int v = 0; v < nodal.size(); ++v)
          nodal[v] = field.local_element(space.nodes(c)[v]);
        std::array<KnownOnes, 2> known;
        for (const auto &particle : particles_here)
          {
            const auto   properties = particle.properties();
            const double value      = properties[property];
            if (!std::isnan(value))
              known[Population<dim>::fluid_of(properties)].add(
                value,
                value - Q1::value<dim>(nodal, particle.reference()),
                properties[Population<dim>::volume_offset]);
          }
        for (const auto &particle : particles_here)
          {
            const auto properties = particle.properties();
            double    &value      = properties[property];
            if (std::isnan(value))
              value = known[Population<dim>::fluid_of(properties)].of_new_one(
                Q1::value<dim>(nodal, particle.reference()));
          }
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
    projection->project(*population, property, view->field);
    fill_unknown(field_for_new_particles());
    update_operator();
    // What particles beside a boundary have is theirs, whatever is given there.
    diffusion->set_given(view->field, end_of_step - half_step);
    if (medium().fluids.size() == 1 &&
        dealii::Utilities::MPI::sum(medium().boundary.passable_faces().size(),
                                    host->context.communicator) == 0)
      {
        correction = before_motion - diffusion->content(view->field);
        give_back();
      }
    with_flow += content() - before_motion;
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
    diffusion->clear_given(room);
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



#define THALWEG_INSTANTIATE_STEP(dim)                                       \
  template double Scalar<dim>::inflow(const dealii::types::boundary_id,     \
                                      const dealii::Point<dim> &,           \
                                      const double) const;                  \
  template void   Scalar<dim>::update_operator();                           \
  template void   Scalar<dim>::add_increment(const Vector &, const double); \
  template double Scalar<dim>::content() const;                             \
  template void   Scalar<dim>::fill_unknown(const Vector &);                \
  template Vector Scalar<dim>::field_for_new_particles() const;             \
  template void   Scalar<dim>::diffuse(const double, const double);         \
  template void   Scalar<dim>::project();                                   \
  template void   Scalar<dim>::give_back();                                 \
  template void   Scalar<dim>::begin_step(const double, const double);      \
  template void   Scalar<dim>::advance(const double, const double);
  THALWEG_INSTANTIATE_STEP(2)
  THALWEG_INSTANTIATE_STEP(3)
#undef THALWEG_INSTANTIATE_STEP
} // namespace Thalweg
