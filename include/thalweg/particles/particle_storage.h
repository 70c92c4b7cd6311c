// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_particle_storage_h
#define thalweg_particles_particle_storage_h

#include <thalweg/particles/population.h>

#include <algorithm>
#include <array>

namespace Thalweg
{
  /// All that is known of a particle but its cell.
  template <int dim>
  struct ParticleRecord
  {
    dealii::types::particle_index                     id;
    dealii::Point<dim>                                position;
    dealii::Point<dim>                                reference;
    std::array<double, Population<dim>::n_properties> properties;
  };

  /// Reads a particle.
  template <int dim>
  inline void
  read(const dealii::Particles::ParticleAccessor<dim> &particle,
       ParticleRecord<dim>                            &record)
  {
    record.id             = particle.get_id();
    record.position       = particle.get_location();
    record.reference      = particle.get_reference_location();
    const auto properties = particle.get_properties();
    for (unsigned int k = 0; k < record.properties.size(); ++k)
      record.properties[k] = properties[k];
  }

  template <int dim>
  inline ParticleRecord<dim>
  record_of(const dealii::Particles::ParticleAccessor<dim> &particle)
  {
    ParticleRecord<dim> record;
    read(particle, record);
    return record;
  }

  /// Writes a particle over another one of the same cell.
  template <int dim>
  inline void
  overwrite(dealii::Particles::ParticleAccessor<dim> &place,
            const ParticleRecord<dim>                &record)
  {
    place.set_location(record.position);
    place.set_reference_location(record.reference);
    place.set_id(record.id);
    std::copy(record.properties.begin(),
              record.properties.end(),
              place.get_properties().begin());
  }

  /// Sees in a loop over all particles whether they lie about in memory, so
  /// that loops have to wait: many were inserted where others had been removed.
  class ScatterCount
  {
  public:
    /// @param local_index of the next particle
    void
    add(const unsigned int local_index)
    {
      ++n_particles;
      n_jumps += local_index == next ? 0 : 1;
      next = local_index + 1;
    }

    bool
    are_scattered() const
    {
      return 4 * n_jumps > n_particles;
    }

  private:
    std::size_t  n_particles = 0, n_jumps = 0;
    unsigned int next = 0;
  };

  /**
   * @brief Makes room for @p n_particles that are going to be stored in place
   * of those that are there, if these were better stored anew.
   */
  template <int dim>
  void
  prepare_storage(Population<dim>    &population,
                  const std::size_t   n_particles,
                  const ScatterCount &scatter)
  {
    if (!scatter.are_scattered())
      return;
    population.handler().clear_particles();
    population.handler().reserve(n_particles);
  }

  /**
   * @brief Puts @p n_new particles in a cell in place of those that are there:
   * only the difference in number is inserted or removed, which costs several
   * times more.
   *
   * Afterwards the handler's numbers are to be updated.
   *
   * @param population the particles
   * @param cell number of an owned cell in the CellGraph
   * @param n_new how many
   * @param record called as `record(k)` for the ParticleRecord of the k-th
   */
  template <int dim, typename Record>
  void
  store_in_cell(Population<dim>   &population,
                const unsigned int cell,
                const unsigned int n_new,
                const Record      &record)
  {
    auto              &handler = population.handler();
    const auto        &where   = population.mesh().graph().iterator(cell);
    const unsigned int n_old   = handler.n_particles_in_cell(where);

    auto place = handler.particles_in_cell(where).begin();
    for (unsigned int k = 0; k < n_new; ++k)
      {
        const ParticleRecord<dim> particle = record(k);
        if (k < n_old)
          {
            overwrite(*place, particle);
            ++place;
          }
        else
          handler.insert_particle(
            particle.position,
            particle.reference,
            particle.id,
            where,
            dealii::ArrayView<const double>(particle.properties.data(),
                                            particle.properties.size()));
      }
    for (unsigned int k = n_old; k > n_new; --k)
      {
        auto last = handler.particles_in_cell(where).begin();
        for (unsigned int i = 1; i < k; ++i)
          ++last;
        handler.remove_particle(last);
      }
  }
} // namespace Thalweg

#endif
