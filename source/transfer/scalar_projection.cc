// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/nodal_moments.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/negligible_weight.h>
#include <thalweg/transfer/scalar_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// A fit that leaves this part of the variance unexplained is none. That
    /// of a jump leaves a fifth; that of a wave of eight cells a thousandth.
    constexpr double misfit_of_jump = .02;

    /// How far a value may go beyond those of the particles, in parts of how
    /// far these lie apart: what the top of a wave needs; and what a plane does
    /// where all particles stand to one side, as beside a wall, two in each
    /// direction.
    constexpr double reach_of_waves = .1, reach_of_planes = .5;
  } // namespace



  template <int dim>
  ScalarProjection<dim>::ScalarProjection(const NodeSpace<dim> &space)
    : space(space)
    , length(dealii::Utilities::MPI::min(
        space.mesh().graph().minimal_extent(),
        space.mesh().triangulation().get_communicator()))
    , nodal(space.dependences().n_nodes())
  {
    for (Vector *vector : {&least, &greatest})
      space.initialize_scalar(*vector);
  }



  template <int dim>
  void
  ScalarProjection<dim>::add_cell(const Population<dim>     &population,
                                  const unsigned int         property,
                                  const unsigned int         cell,
                                  const Vector              &guess,
                                  const std::array<bool, 2> &fluids)
  {
    const auto  &monomials = Monomials<dim>::instance();
    const double inverse   = 1. / length;
    find_node_targets(space, cell, targets);
    for (const auto &particle : population.in_cell(cell))
      {
        const auto   row   = particle.properties();
        const double value = row[property];
        if (std::isnan(value) || !fluids[Population<dim>::fluid_of(row)])
          continue;
        const auto shape = Q1::values<dim>(particle.reference());
        for (const NodeTarget<dim> &target : targets)
          {
            const double weight = target.weight(shape);
            if (weight <= 0.)
              continue;
            const double difference = value - guess.local_element(target.node);
            double      &low        = least.local_element(target.node);
            double      &high       = greatest.local_element(target.node);
            low                     = std::min(low, difference);
            high                    = std::max(high, difference);
            nodal[target.node].add(weight,
                                   monomials.values(
                                     (particle.position() - target.position) *
                                     inverse),
                                   difference);
          }
      }
  }



  template <int dim>
  void
  ScalarProjection<dim>::join()
  {
    join_moments(space, nodal);
    using Operation = dealii::VectorOperation;
    space.dependences().join_copies(least, 1, Operation::min);
    space.dependences().join_copies(greatest, 1, Operation::max);
  }



  template <int dim>
  double
  ScalarProjection<dim>::change(const unsigned int node) const
  {
    double       misfit;
    const double fitted = nodal[node].fit(misfit);
    const double within = std::clamp(fitted,
                                     least.local_element(node),
                                     greatest.local_element(node));
    const double trust  = std::max(0., 1. - misfit / misfit_of_jump);
    const double reach =
      reach_of_waves + reach_of_planes * nodal[node].one_sidedness();
    const double beyond =
      trust * reach *
      (greatest.local_element(node) - least.local_element(node));
    return std::clamp(fitted, within - beyond, within + beyond);
  }



  template <int dim>
  void
  ScalarProjection<dim>::project(const Population<dim>     &population,
                                 const unsigned int         property,
                                 Vector                    &scalar,
                                 const std::array<bool, 2> &fluids)
  {
    std::fill(nodal.begin(), nodal.end(), QuadraticMoments<dim>());
    least.zero_out_ghost_values();
    greatest.zero_out_ghost_values();
    for (unsigned int node = 0; node < nodal.size(); ++node)
      {
        least.local_element(node)    = std::numeric_limits<double>::max();
        greatest.local_element(node) = std::numeric_limits<double>::lowest();
      }
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      add_cell(population, property, c, scalar, fluids);
    join();

    scalar.zero_out_ghost_values();
    for (unsigned int node = 0; node < space.n_owned_nodes(); ++node)
      {
        const bool is_reached = nodal[node].weight() > negligible_weight;
        double    &value      = scalar.local_element(node);
        double    &low        = least.local_element(node);
        double    &high       = greatest.local_element(node);
        if (is_reached)
          {
            const double guess = value;
            value += change(node);
            low += guess;
            high += guess;
          }
        else
          low = high = value;
      }
    for (Vector *vector : {&scalar, &least, &greatest})
      space.interpolate(*vector, 1);
  }



  THALWEG_INSTANTIATE(ScalarProjection)
} // namespace Thalweg
