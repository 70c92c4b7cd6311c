// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_population_snapshot_h
#define thalweg_particles_population_snapshot_h

#include <thalweg/particles/population.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief All particles of this rank as they were at one time, for steps
   * that move the particles again from where they began.
   *
   * Memory is kept from one save() to the next.
   */
  template <int dim>
  class PopulationSnapshot
  {
  public:
    /// Remembers all particles of this rank.
    void
    save(const Population<dim> &population);

    /**
     * @brief Makes the population what it was at the last save(): ids,
     * positions, properties and the order in each cell.
     *
     * Ids that were given in the meantime are not given again.
     *
     * @param population the one that was saved; its mesh must not have
     *   changed since then
     */
    void
    restore(Population<dim> &population) const;

    /// The particles that were in the owned cell @p cell.
    typename Population<dim>::ConstRange
    in_cell(const unsigned int cell) const
    {
      return rows.range(begin_of_cell[cell], begin_of_cell[cell + 1]);
    }

    unsigned int
    n_in_cell(const unsigned int cell) const
    {
      return begin_of_cell[cell + 1] - begin_of_cell[cell];
    }

  private:
    ParticleRows<dim> rows{Population<dim>::n_properties};
    /// The number of the first particle of each owned cell, and of all.
    std::vector<unsigned int> begin_of_cell;
  };
} // namespace Thalweg

#endif
