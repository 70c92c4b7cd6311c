// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/population_snapshot.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    ScatterCount
    scatter_of(const Population<dim> &population)
    {
      const auto  &graph = population.mesh().graph();
      ScatterCount scatter;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (const auto &particle :
             population.handler().particles_in_cell(graph.iterator(c)))
          scatter.add(particle.get_local_index());
      return scatter;
    }
  } // namespace


  template <int dim>
  void
  PopulationSnapshot<dim>::save(const Population<dim> &population)
  {
    const auto &graph   = population.mesh().graph();
    const auto &handler = population.handler();
    particles.clear();
    particles.reserve(handler.n_locally_owned_particles());
    begin_of_cell.clear();
    begin_of_cell.reserve(graph.n_owned_cells() + 1);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        begin_of_cell.push_back(particles.size());
        for (const auto &particle :
             handler.particles_in_cell(graph.iterator(c)))
          {
            particles.emplace_back();
            read(particle, particles.back());
          }
      }
    begin_of_cell.push_back(particles.size());
  }


  template <int dim>
  void
  PopulationSnapshot<dim>::restore(Population<dim> &population) const
  {
    const unsigned int n_cells = population.mesh().graph().n_owned_cells();
    AssertThrow(begin_of_cell.size() == n_cells + 1,
                dealii::ExcMessage(
                  "Particles can only be put back into the cells that they "
                  "were in: save them again after each change of the mesh."));
    prepare_storage(population, particles.size(), scatter_of(population));
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        const unsigned int begin = begin_of_cell[c];
        store_in_cell(population,
                      c,
                      begin_of_cell[c + 1] - begin,
                      [&](const unsigned int k) -> const ParticleRecord<dim> & {
                        return particles[begin + k];
                      });
      }
    population.handler().update_cached_numbers();
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::PopulationSnapshot)
