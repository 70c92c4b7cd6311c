// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/negligible_weight.h>
#include <thalweg/transfer/projection.h>

namespace Thalweg
{
  namespace
  {
    /// Sums over the particles around each node.
    struct Sums
    {
      Vector weight;   ///< N_i
      Vector mass;     ///< N_i rho_p
      Vector momentum; ///< N_i rho_p (V_p - N V), with V the first mean
    };



    /// Adds the particles of a cell.
    /// @tparam is_first without a mean that would be known
    template <int dim, bool is_first>
    void
    add_cell(const Population<dim>       &population,
             const NodeSpace<dim>        &space,
             const std::array<double, 2> &densities,
             const unsigned int           cell,
             const Vector                &mean,
             Sums                        &sums)
    {
      constexpr unsigned int      n     = 1 << dim;
      const auto                 &nodes = space.nodes(cell);
      std::array<double, dim * n> known{}, momentum{};
      std::array<double, n>       weight{}, mass{};
      if constexpr (!is_first)
        known = gather_velocity<dim>(mean, nodes);
      for (const auto &particle : population.in_cell(cell))
        {
          const auto   shape      = Q1::values<dim>(particle.reference());
          const auto   properties = particle.properties();
          const double density =
            densities[Population<dim>::fluid_of(properties)];
          for (unsigned int d = 0; d < dim; ++d)
            {
              double left = properties[Population<dim>::velocity_offset + d];
              if constexpr (!is_first)
                for (unsigned int v = 0; v < n; ++v)
                  left -= shape[v] * known[dim * v + d];
              left *= density;
              for (unsigned int v = 0; v < n; ++v)
                momentum[dim * v + d] += shape[v] * left;
            }
          if constexpr (is_first)
            for (unsigned int v = 0; v < n; ++v)
              {
                weight[v] += shape[v];
                mass[v] += shape[v] * density;
              }
        }
      for (unsigned int v = 0; v < n; ++v)
        {
          for (unsigned int d = 0; d < dim; ++d)
            sums.momentum.local_element(dim * nodes[v] + d) +=
              momentum[dim * v + d];
          if constexpr (is_first)
            {
              sums.weight.local_element(nodes[v]) += weight[v];
              sums.mass.local_element(nodes[v]) += mass[v];
            }
        }
    }



    /// One pass over all particles, the second with the mean of the first.
    template <int dim, bool is_first>
    void
    add_cells(const Population<dim>       &population,
              const NodeSpace<dim>        &space,
              const std::array<double, 2> &densities,
              const Vector                &mean,
              Sums                        &sums)
    {
      sums.momentum = 0.;
      for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
        add_cell<dim, is_first>(population, space, densities, c, mean, sums);
      space.fold(sums.momentum, dim);
      if constexpr (is_first)
        {
          space.fold(sums.weight, 1);
          space.fold(sums.mass, 1);
        }
    }
  } // namespace



  template <int dim>
  void
  project_momentum(const Population<dim> &population,
                   const NodeSpace<dim>  &space,
                   const Fluids          &fluids,
                   Vector                &velocity)
  {
    Sums sums;
    space.initialize_scalar(sums.weight);
    space.initialize_scalar(sums.mass);
    space.initialize_velocity(sums.momentum);
    const std::array<double, 2> densities{
      {fluids.of_particle(0).density, fluids.of_particle(1).density}};
    for (const bool is_first : {true, false})
      {
        if (is_first)
          add_cells<dim, true>(population, space, densities, velocity, sums);
        else
          add_cells<dim, false>(population, space, densities, velocity, sums);
        velocity.zero_out_ghost_values();
        for (unsigned int n = 0; n < sums.weight.locally_owned_size(); ++n)
          if (sums.weight.local_element(n) > negligible_weight)
            for (unsigned int d = 0; d < dim; ++d)
              {
                double &value = velocity.local_element(dim * n + d);
                value         = (is_first ? 0. : value) +
                        sums.momentum.local_element(dim * n + d) /
                          sums.mass.local_element(n);
              }
        space.interpolate(velocity, dim);
      }
  }



  template void
  project_momentum<2>(const Population<2> &,
                      const NodeSpace<2> &,
                      const Fluids &,
                      Vector &);
  template void
  project_momentum<3>(const Population<3> &,
                      const NodeSpace<3> &,
                      const Fluids &,
                      Vector &);
} // namespace Thalweg
