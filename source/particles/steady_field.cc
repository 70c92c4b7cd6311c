// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/particles/steady_field.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  using namespace CellPolynomial;


  namespace
  {
    template <int dim>
    std::array<double, dim>
    vertex(const unsigned int v)
    {
      std::array<double, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = (v >> d) & 1;
      return result;
    }


    /// The divergence at the vertices, of rates in a cell that is
    /// axis-parallel.
    template <int dim>
    std::array<double, (1 << dim)>
    divergence_of_rates(const std::array<double, dim *(1 << dim)> &nodal_rates)
    {
      std::array<double, (1 << dim)> divergence{};
      for (unsigned int v = 0; v < divergence.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          divergence[v] += nodal_rates[(v | (1 << d)) * dim + d] -
                           nodal_rates[(v & ~(1 << d)) * dim + d];
      return divergence;
    }


    /// The divergence at the vertices, in the reference cell, of the flux of
    /// the Piola transform. It is multilinear in quadrilaterals and
    /// parallelepipeds.
    template <int dim>
    std::array<double, (1 << dim)>
    divergence_of_flux(
      const std::array<dealii::Tensor<2, dim>, (1 << dim)> &jacobians,
      const std::array<double, dim *(1 << dim)>            &nodal_velocity)
    {
      auto velocity = nodal_velocity;
      to_polynomial<dim>(velocity);
      std::array<double, (1 << dim)> divergence;
      for (unsigned int v = 0; v < divergence.size(); ++v)
        {
          const auto rise = gradient<dim>(velocity, vertex<dim>(v));
          divergence[v] =
            determinant(jacobians[v]) * trace(rise * invert(jacobians[v]));
        }
      return divergence;
    }
  } // namespace


  template <int dim>
  SteadyField<dim>::SteadyField(const CellGraph<dim>    &graph,
                                const CellVelocity<dim> &velocity,
                                const double             greatest_way,
                                const double             direction,
                                const VelocityShape      shape)
  {
    AssertDimension(velocity.size(), graph.n_cells());
    flow.reserve(graph.n_cells());
    for (unsigned int i = 0; i < graph.n_cells(); ++i)
      flow.push_back(
        prepare(graph.cell(i), velocity[i], greatest_way, direction, shape));
  }


  template <int dim>
  typename SteadyField<dim>::Bubbles
  SteadyField<dim>::bubbles_of(const std::array<double, n_vertices> &divergence)
  {
    // The part of it that is odd in some of the directions, at vertex 1,1,(1).
    const auto odd_part = [&divergence](const unsigned int directions) {
      double sum = 0;
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          const unsigned int low      = directions & ~v;
          const bool         negative = ((low >> 2) ^ (low >> 1) ^ low) & 1;
          sum += negative ? -divergence[v] : divergence[v];
        }
      return sum / n_vertices;
    };
    Bubbles result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = odd_part(1 << d);
    if constexpr (dim == 3)
      for (unsigned int d = 0; d < dim; ++d)
        result[3 + d] = odd_part(7 ^ (1 << d));
    return result;
  }


  template <int dim>
  double
  SteadyField<dim>::fastest_bubble(const Bubbles &bubbles)
  {
    double greatest = 0, mixed = 0;
    for (unsigned int i = 0; i < bubbles.size(); ++i)
      if (i < dim)
        greatest = std::max(greatest, std::abs(bubbles[i]));
      else
        mixed += .5 * std::abs(bubbles[i]);
    return .25 * (greatest + mixed);
  }


  template <int dim>
  typename SteadyField<dim>::Flow
  SteadyField<dim>::prepare(const typename CellGraph<dim>::Cell &geometry,
                            const Polynomial                    &nodal_velocity,
                            const double                         greatest_way,
                            const double                         direction,
                            const VelocityShape                  shape)
  {
    Jacobians jacobians;
    double    least_stretch = 1;
    if (!geometry.axis_parallel)
      {
        const Polynomial map = CellMaps<dim>::shape_of(geometry);
        least_stretch        = std::numeric_limits<double>::max();
        for (unsigned int v = 0; v < n_vertices; ++v)
          {
            jacobians[v]  = gradient<dim>(map, vertex<dim>(v));
            least_stretch = std::min(least_stretch, determinant(jacobians[v]));
          }
      }
    Flow   result{};
    double fastest = 0;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        Coordinates velocity;
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] = direction * nodal_velocity[v * dim + d];
        Coordinates rate;
        if (geometry.axis_parallel)
          {
            for (unsigned int d = 0; d < dim; ++d)
              rate[d] = velocity[d] * geometry.inverse_extent[d];
            velocity = rate;
          }
        else
          rate = solve<dim>(jacobians[v], velocity);
        for (unsigned int d = 0; d < dim; ++d)
          {
            result.velocity[v * dim + d] = velocity[d];
            fastest                      = std::max(fastest, std::abs(rate[d]));
          }
      }
    if (shape == VelocityShape::evenly_divergent)
      {
        result.bubbles =
          bubbles_of(geometry.axis_parallel
                       ? divergence_of_rates<dim>(result.velocity)
                       : divergence_of_flux<dim>(jacobians, result.velocity));
        fastest += fastest_bubble(result.bubbles) / least_stretch;
      }
    to_polynomial<dim>(result.velocity);
    result.longest_substep =
      fastest > 0 ? greatest_way / fastest : std::numeric_limits<double>::max();
    return result;
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::SteadyField)
