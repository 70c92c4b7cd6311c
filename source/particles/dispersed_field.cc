// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/dispersed_field.h>
#include <thalweg/particles/streamline_walk.templates.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    template <std::size_t dim>
    double
    dot(const std::array<double, dim> &a, const std::array<double, dim> &b)
    {
      double sum = 0;
      for (unsigned int d = 0; d < dim; ++d)
        sum += a[d] * b[d];
      return sum;
    }
  } // namespace



  template <int dim>
  DispersedField<dim>::DispersedField(const CellGraph<dim>       &graph,
                                      const CellField<dim, 1>    &level_set,
                                      const CellVelocity<dim>    &velocity,
                                      const double                greatest_way,
                                      const DispersedMotion<dim> &motion)
    : graph(graph)
    , level_set(level_set)
    , flow(graph, velocity, greatest_way, 1.)
    , greatest_way(greatest_way)
    , motion(motion)
  {}



  template <int dim>
  void
  DispersedField<dim>::launch(WalkerType               &walker,
                              const dealii::Point<dim> &place,
                              const unsigned int        fluid,
                              const Coordinates        &velocity,
                              const double              volume) const
  {
    walker.is_bubble = fluid == 1;
    if (walker.is_bubble)
      walker.first_velocity = motion.rise(place, volume);
    else
      {
        walker.first_velocity = velocity;
        walker.acceleration   = motion.acceleration(place, velocity);
      }
  }



  template <int dim>
  double
  DispersedField<dim>::longest_substep(const WalkerType &walker) const
  {
    // |v| t + |a| t^2 / 2 is no longer than the way for this t.
    const double way    = greatest_way * graph.cell(walker.cell).edges().first;
    const Coordinates v = velocity_after(walker, 0.);
    const double      speed =
      std::sqrt(dot(v, v)) +
      std::sqrt(way * std::sqrt(dot(walker.acceleration, walker.acceleration)));
    double rate = speed / way;
    if (walker.is_bubble)
      rate += 1. / flow.longest_substep(walker);
    return rate > 0 ? 1. / rate : std::numeric_limits<double>::max();
  }



  template <int dim>
  void
  DispersedField<dim>::hit(WalkerType &walker, const Coordinates &normal) const
  {
    if (walker.is_bubble)
      return;
    const double part =
      dot(velocity_after(walker, 0.), normal) / dot(normal, normal);
    for (unsigned int d = 0; d < dim; ++d)
      walker.integral[d] -= part * normal[d];
  }



  template <int dim>
  bool
  DispersedField<dim>::lands(const WalkerType &walker) const
  {
    const double phi =
      Q1::value<dim>(level_set[walker.cell], walker.reference_point());
    return walker.is_bubble ? phi >= 0 : phi < 0;
  }



  THALWEG_INSTANTIATE(DispersedField)
  template class StreamlineWalk<2, DispersedField<2>>;
  template class StreamlineWalk<3, DispersedField<3>>;
} // namespace Thalweg
