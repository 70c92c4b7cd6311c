// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_carried_population_h
#define thalweg_particles_carried_population_h

#include <thalweg/fields/carried.h>
#include <thalweg/particles/population_snapshot.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Lets the particles of a population go along with their cells.
   *
   * Particles stay where they are, and each comes to the cell that covers its
   * place in the reference cell: none can get lost between two cells.
   */
  template <int dim>
  class CarriedPopulation : public Carried<dim>
  {
  public:
    using typename Carried<dim>::CellIterator;

    /// @param population must outlive the object
    explicit CarriedPopulation(Population<dim> &population)
      : population(population)
    {}

    void
    save() override;

    void
    restore() override;

    void
    clear() override;

    void
    pack(const CellIterator    &cell,
         const Compat::CellFate fate,
         std::vector<char>     &bytes) const override;

    void
    begin_to_unpack() override;

    void
    unpack(const CellIterator    &cell,
           const Compat::CellFate fate,
           PlainReader           &reader) override;

    void
    check_unpacked() const override;

    void
    end_to_unpack() override;

  private:
    /// The owned cell where a particle is that came with @p cell, with its
    /// place there.
    unsigned int
    find_cell(const CellIterator    &cell,
              const Compat::CellFate fate,
              ParticlePlace<dim>    &place) const;

    Population<dim>        &population;
    PopulationSnapshot<dim> saved;
    /// Those that have come, and the owned cell of each.
    ParticleRows<dim>         received{Population<dim>::n_properties};
    std::vector<unsigned int> cells;
  };
} // namespace Thalweg

#endif
