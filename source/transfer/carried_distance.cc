// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/carried_distance.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Interpolation from dependences leaves round-off in a one.
    constexpr double almost_one = 1. - 1e-9;

    template <std::size_t n>
    bool
    is_cut(const std::array<double, n> &phi)
    {
      const auto [least, most] = std::minmax_element(phi.begin(), phi.end());
      return *least < 0 && *most >= 0;
    }
  } // namespace



  template <int dim>
  CarriedDistance<dim>::CarriedDistance(const NodeSpace<dim> &space)
    : space(space)
  {
    for (Vector *vector : {&distance, &rate, &is_known, &sum, &slopes, &count})
      space.initialize_scalar(*vector);
  }



  template <int dim>
  double
  CarriedDistance<dim>::normal_stretch(const unsigned int cell,
                                       const Vector      &phi,
                                       const Vector      &velocity) const
  {
    const auto &nodes = space.nodes(cell);
    const auto  point = Q1::middle<dim>(space.mesh().graph().cell(cell));
    dealii::Tensor<1, dim> normal;
    for (unsigned int v = 0; v < nodes.size(); ++v)
      normal += phi.local_element(nodes[v]) * point.gradients[v];
    const double square = normal.norm_square();
    if (square == 0.)
      return 0.;
    double stretch = 0.;
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        double along = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          along += normal[d] * velocity.local_element(dim * nodes[v] + d);
        stretch += along * (point.gradients[v] * normal);
      }
    return stretch / square;
  }



  template <int dim>
  void
  CarriedDistance<dim>::take_means()
  {
    // At a node that depends on others the cell speaks to those: of each as
    // far away as that one is.
    space.fold(sum, 1);
    space.fold(slopes, 1);
    space.fold(count, 1);
    rate.zero_out_ghost_values();
    is_known.zero_out_ghost_values();
    for (unsigned int n = 0; n < rate.locally_owned_size(); ++n)
      if (count.local_element(n) > 0 && is_known.local_element(n) == 0)
        {
          rate.local_element(n) =
            (sum.local_element(n) +
             slopes.local_element(n) * distance.local_element(n)) /
            count.local_element(n);
          is_known.local_element(n) = 1.;
        }
    space.interpolate(rate, 1);
    space.interpolate(is_known, 1);
  }



  template <int dim>
  void
  CarriedDistance<dim>::spread(const Vector &phi,
                               const Vector &velocity,
                               const bool    from_cut_cells)
  {
    sum    = 0.;
    slopes = 0.;
    count  = 0.;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        const auto &nodes   = space.nodes(c);
        const auto  values  = gather<dim>(phi, nodes);
        double      n_known = 0., sum_of_values = 0., sum_of_rates = 0.;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          if (is_known.local_element(nodes[v]) >= almost_one)
            {
              n_known += 1.;
              sum_of_values += values[v];
              sum_of_rates += rate.local_element(nodes[v]);
            }
        if (from_cut_cells ? !is_cut(values)
                           : n_known == 0. || n_known == nodes.size())
          continue;
        const double stretch = normal_stretch(c, phi, velocity);
        const double constant =
          n_known > 0. ? (sum_of_rates - stretch * sum_of_values) / n_known
                       : 0.;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          if (is_known.local_element(nodes[v]) < almost_one)
            {
              sum.local_element(nodes[v]) += constant;
              slopes.local_element(nodes[v]) += stretch;
              count.local_element(nodes[v]) += 1.;
            }
      }
    take_means();
  }



  template <int dim>
  void
  CarriedDistance<dim>::find_rates(const Vector &phi, const Vector &velocity)
  {
    distance.copy_locally_owned_data_from(phi);
    space.interpolate(distance, 1);
    rate     = 0.;
    is_known = 0.;
    spread(phi, velocity, true);
    spread(phi, velocity, false);
  }



  template <int dim>
  void
  CarriedDistance<dim>::apply(Population<dim> &population,
                              const double     dt) const
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &nodes = space.nodes(c);
        if (std::any_of(nodes.begin(), nodes.end(), [&](const auto node) {
              return is_known.local_element(node) < almost_one;
            }))
          continue;
        auto rates     = gather<dim>(rate, nodes);
        auto distances = gather<dim>(distance, nodes);
        for (unsigned int v = 0; v < nodes.size(); ++v)
          if (distances[v] < 0)
            {
              distances[v] = -distances[v];
              rates[v]     = -rates[v];
            }
        const double farthest =
          *std::max_element(distances.begin(), distances.end());
        for (auto &particle : population.in_cell(c))
          {
            const auto shape = Q1::values<dim>(particle.reference());
            double     r = 0., d = 0.;
            for (unsigned int v = 0; v < nodes.size(); ++v)
              {
                r += shape[v] * rates[v];
                d += shape[v] * distances[v];
              }
            double &own =
              particle.properties()[Population<dim>::level_set_offset];
            // What is much farther from its interface than from this one
            // belongs to another.
            if (d > 0 && (r < 0 || std::abs(own) <= 2. * farthest))
              own *= std::exp(dt * r / d);
          }
      }
  }



  template <int dim>
  void
  CarriedDistance<dim>::apply(Vector &level_set, const double dt) const
  {
    level_set.zero_out_ghost_values();
    for (unsigned int n = 0; n < level_set.locally_owned_size(); ++n)
      if (const double d = distance.local_element(n);
          is_known.local_element(n) >= almost_one && d != 0)
        level_set.local_element(n) *= std::exp(dt * rate.local_element(n) / d);
    space.interpolate(level_set, 1);
  }



  THALWEG_INSTANTIATE(CarriedDistance)
} // namespace Thalweg
