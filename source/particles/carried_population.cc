// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/carried_population.h>
#include <thalweg/particles/sub_cell.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    void
    append_particle(std::vector<char>         &bytes,
                    const ParticleRecord<dim> &particle)
    {
      append_plain(bytes, particle.id);
      append_plain(bytes, particle.position);
      append_plain(bytes, particle.reference);
      append_plain(bytes, particle.properties);
    }



    template <int dim>
    ParticleRecord<dim>
    read_particle(PlainReader &reader)
    {
      ParticleRecord<dim> particle;
      reader.read(particle.id);
      reader.read(particle.position);
      reader.read(particle.reference);
      reader.read(particle.properties);
      return particle;
    }



    /// Whether a particle is in the cell between two corners, or near it, and
    /// carries numbers.
    template <int dim>
    bool
    is_good(const ParticleRecord<dim> &particle,
            const dealii::Point<dim>  &first,
            const dealii::Point<dim>  &last)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (!(std::abs(particle.reference[d] - .5) <= 1.))
          return false;
      return particle.position.distance(first) <= 10. * first.distance(last) &&
             std::all_of(particle.properties.begin(),
                         particle.properties.end(),
                         [](const double value) {
                           return std::isfinite(value);
                         });
    }
  } // namespace



  template <int dim>
  void
  CarriedPopulation<dim>::save()
  {
    saved.save(population);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::restore()
  {
    saved.restore(population);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::clear()
  {
    population.handler().clear_particles();
  }



  template <int dim>
  void
  CarriedPopulation<dim>::pack(const CellIterator    &cell,
                               const Compat::CellFate fate,
                               std::vector<char>     &bytes) const
  {
    const CellGraph<dim> &graph        = population.mesh().graph();
    const bool            is_coarsened = fate == Compat::CellFate::is_coarsened;
    const unsigned int    n_sources    = is_coarsened ? cell->n_children() : 1u;
    const auto            source       = [&](const unsigned int c) {
      return saved.in_cell(graph.index(is_coarsened ? cell->child(c) : cell));
    };
    std::uint32_t n = 0;
    for (unsigned int c = 0; c < n_sources; ++c)
      n += source(c).size();
    append_plain(bytes, n);
    for (unsigned int c = 0; c < n_sources; ++c)
      for (ParticleRecord<dim> particle : source(c))
        {
          if (is_coarsened)
            particle.reference = to_parent<dim>(particle.reference, c);
          append_particle<dim>(bytes, particle);
        }
  }



  template <int dim>
  void
  CarriedPopulation<dim>::begin_to_unpack()
  {
    received.assign(population.mesh().graph().n_owned_cells(), {});
  }



  template <int dim>
  void
  CarriedPopulation<dim>::unpack(const CellIterator    &cell,
                                 const Compat::CellFate fate,
                                 PlainReader           &reader)
  {
    std::uint32_t n = 0;
    reader.read(n);
    for (std::uint32_t i = 0; i < n; ++i)
      receive(read_particle<dim>(reader), cell, fate);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::receive(ParticleRecord<dim>    particle,
                                  const CellIterator    &cell,
                                  const Compat::CellFate fate)
  {
    const CellGraph<dim> &graph  = population.mesh().graph();
    CellIterator          target = cell;
    if (fate == Compat::CellFate::is_refined)
      {
        const auto child   = sub_cell<dim>(particle.reference);
        target             = cell->child(child);
        particle.reference = from_parent<dim>(particle.reference, child);
      }
    // Where boundaries are curved, children do not lie in their parents.
    const unsigned int index = graph.index(target);
    if (fate != Compat::CellFate::persists && !graph.cell(index).axis_parallel)
      particle.position =
        Q1::position<dim>(graph.cell(index).vertices, particle.reference);
    received[index].push_back(particle);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::check_unpacked() const
  {
    for (unsigned int c = 0; c < received.size(); ++c)
      {
        const auto &vertices = population.mesh().graph().cell(c).vertices;
        for (const ParticleRecord<dim> &particle : received[c])
          AssertThrow(is_good(particle, vertices.front(), vertices.back()),
                      dealii::ExcMessage("it has particles that cannot be "
                                         "where it says."));
      }
  }



  template <int dim>
  void
  CarriedPopulation<dim>::end_to_unpack()
  {
    std::size_t n_particles = 0;
    for (const auto &cell : received)
      n_particles += cell.size();
    clear();
    population.handler().reserve(n_particles);
    for (unsigned int c = 0; c < received.size(); ++c)
      store_in_cell(population,
                    c,
                    received[c].size(),
                    [&](const unsigned int k) -> const ParticleRecord<dim> & {
                      return received[c][k];
                    });
    population.handler().update_cached_numbers();
    received.clear();
  }



  THALWEG_INSTANTIATE(CarriedPopulation)
} // namespace Thalweg
