// SPDX-License-Identifier: LGPL-2.1-or-later
// What a scalar does with the particles that carry it.
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
  typename Scalar<dim>::Fields
  Scalar<dim>::fields() const
  {
    Fields copy{view->field, view->molten};
    copy.value.update_ghost_values();
    if (parameters.melts())
      copy.molten.update_ghost_values();
    return copy;
  }



  template <int dim>
  template <typename Add>
  void
  Scalar<dim>::for_each_increment(const Fields &before, const Add &add)
  {
    using Nodal       = std::array<double, (1 << dim)>;
    const auto &space = view->space;
    const bool  melts = parameters.melts();
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        const auto &nodes   = space.nodes(c);
        bool        is_zero = true;
        const auto  change  = [&](const Vector &now, const Vector &then) {
          Nodal increment;
          for (unsigned int v = 0; v < nodes.size(); ++v)
            {
              increment[v] =
                now.local_element(nodes[v]) - then.local_element(nodes[v]);
              is_zero = is_zero && increment[v] == 0.;
            }
          return increment;
        };
        const Nodal value = change(view->field, before.value);
        Nodal       molten{};
        if (melts)
          molten = change(view->molten, before.molten);
        if (is_zero)
          continue;
        for (const auto &particle : population->in_cell(c))
          {
            const auto         row   = particle.properties();
            const unsigned int fluid = Population<dim>::fluid_of(row);
            const double in_value = Q1::value<dim>(value, particle.reference());
            const double in_molten =
              heat.melts(fluid) ? Q1::value<dim>(molten, particle.reference())
                                : 0.;
            add(row,
                in_value,
                in_molten,
                in_value + heat.laws[fluid].latent * in_molten,
                row[Population<dim>::volume_offset] * capacity[fluid]);
          }
      }
  }



  template <int dim>
  void
  Scalar<dim>::add_increment(const Fields &before, const double supply)
  {
    double part = 0.;
    if (medium().fluids.size() > 1)
      {
        // The particles' volumes are no quadrature: where the increments are,
        // they get what is missing, too.
        std::array<double, 2> sums{};
        for_each_increment(before,
                           [&](auto &,
                               double,
                               double,
                               const double increment,
                               const double mass) {
                             sums[0] += mass * increment;
                             sums[1] += mass * std::abs(increment);
                           });
        dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(sums.data(),
                                                                    2),
                                    host->context.communicator,
                                    dealii::ArrayView<double>(sums.data(), 2));
        const double missing = supply - sums[0];
        part                 = sums[1] > 0. ? missing / sums[1] : 0.;
        correction += missing;
      }
    const bool melts = parameters.melts();
    for_each_increment(before,
                       [&](auto        &row,
                           const double in_value,
                           const double in_molten,
                           const double increment,
                           double) {
                         row[heat.value] +=
                           in_value + part * std::abs(increment);
                         if (melts)
                           row[heat.molten] += in_molten;
                       });
  }



  template <int dim>
  void
  Scalar<dim>::fill_unknown(const unsigned int property, const Vector &field)
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
  Scalar<dim>::within_bounds(const Vector                &field,
                             const ScalarProjection<dim> &projection)
  {
    Vector bounded(field);
    bounded.zero_out_ghost_values();
    for (unsigned int n = 0; n < bounded.locally_owned_size(); ++n)
      bounded.local_element(n) =
        std::clamp(bounded.local_element(n),
                   projection.lower().local_element(n),
                   projection.upper().local_element(n));
    return bounded;
  }



  template <int dim>
  void
  Scalar<dim>::project_particles()
  {
    projection->project(*population, heat.value, view->field);
    Vector field = within_bounds(view->field, *projection);
    diffusion->set_given(field, end_of_step);
    fill_unknown(heat.value, field);
    if (!parameters.melts())
      return;
    molten_projection->project(*population,
                               heat.molten,
                               view->molten,
                               {{heat.melts(0), heat.melts(1)}});
    field = within_bounds(view->molten, *molten_projection);
    view->space.interpolate(field, 1);
    fill_unknown(heat.molten, field);
  }



#define THALWEG_INSTANTIATE_PARTICLES(dim)                                     \
  template Scalar<dim>::Fields Scalar<dim>::fields() const;                    \
  template void Scalar<dim>::add_increment(const Fields &, const double);      \
  template void Scalar<dim>::fill_unknown(const unsigned int, const Vector &); \
  template void Scalar<dim>::project_particles();
  THALWEG_INSTANTIATE_PARTICLES(2)
  THALWEG_INSTANTIATE_PARTICLES(3)
#undef THALWEG_INSTANTIATE_PARTICLES
} // namespace Thalweg
