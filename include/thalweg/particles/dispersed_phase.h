// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_dispersed_phase_h
#define thalweg_particles_dispersed_phase_h

#include <thalweg/particles/dispersed_field.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/population_control.h>

#include <array>
#include <map>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What is finer than the mesh: drops of the first fluid where the
   * mesh shows the second, and bubbles of the second where it shows the first
   * (seed 000, 7.7).
   *
   * A particle becomes one of them farther from the interface than half of
   * its cell's shortest edge, on the wrong side. It then takes no part in the
   * projections and nothing from the mesh, but moves as DispersedMotion says
   * until it is back in its own fluid, or in a cell that it and its like
   * fill. Walls take the normal velocity from drops.
   *
   * A drop's velocity is that at the time of its place.
   */
  template <int dim>
  class DispersedPhase
  {
  public:
    /**
     * @param population of drops and bubbles; must outlive the object
     * @param parameters, walls as those of StreamlineConvection
     */
    DispersedPhase(Population<dim>            &population,
                   const ConvectionParameters &parameters,
                   const std::map<dealii::types::boundary_id, WallKind> &walls);

    /// All drops and bubbles.
    const Population<dim> &
    particles() const
    {
      return population;
    }

    /**
     * @brief Lets drops and bubbles go on for the time @p dt. Collective.
     * @param level_set cell by cell at the start: the distance from the
     *   interface, negative in the first fluid
     * @param velocity of the mesh cell by cell, m/s
     * @param motion of them
     * @param velocity_ahead by what the velocities of particles are ahead of
     *   the start, in s
     * @param landed gets those that have met their own fluid, with the
     *   velocity of particles and the time that they have left
     */
    ConvectionReport
    move(const CellField<dim, 1>       &level_set,
         const CellVelocity<dim>       &velocity,
         const DispersedMotion<dim>    &motion,
         const double                   dt,
         const double                   velocity_ahead,
         std::vector<NewParticle<dim>> &landed);

    /**
     * @brief Takes those particles that the mesh does not see, and gives back
     * drops and bubbles that fill their cells. Collective.
     * @param particles whose velocities are ahead of their places by
     *   @p velocity_ahead, in s
     * @param level_set the same where they are now
     * @param motion of drops
     */
    void
    exchange(Population<dim>            &particles,
             const CellField<dim, 1>    &level_set,
             const DispersedMotion<dim> &motion,
             const double                velocity_ahead);

    /// Whether there are neither drops nor bubbles. Collective.
    bool
    is_empty() const;

    /// Merges those that are too many in a cell. Collective.
    void
    limit(const PopulationControl<dim> &control);

    /// What is dispersed of both fluids, m^dim. Collective.
    std::array<double, 2>
    volumes() const;

  private:
    /// Particles of one population that go to the other.
    struct Migration
    {
      explicit Migration(const Population<dim> &from)
        : rows(from.row_length())
      {}

      void
      add(const unsigned int particle, const unsigned int cell)
      {
        particles.push_back(particle);
        cells.push_back(cell);
      }

      void
      clear()
      {
        particles.clear();
        cells.clear();
      }

      std::vector<unsigned int> particles; ///< places in the population
      std::vector<unsigned int> cells;
      ParticleRows<dim>         rows; ///< when they are taken out
    };

    /// Those of the particles of an owned cell that the mesh does not see.
    void
    find_unseen(const Population<dim>   &particles,
                const unsigned int       cell,
                const CellField<dim, 1> &level_set,
                Migration               &migration) const;

    /// Of which fluids particles, drops and bubbles fill a cell.
    std::array<bool, 2>
    fill(const Population<dim> &particles, const unsigned int cell) const;

    /// Takes particles out of their population. @param ahead is added to the
    /// time of the velocities of drops, s
    static void
    take(Population<dim>            &population,
         Migration                  &migration,
         const DispersedMotion<dim> &motion,
         const double                ahead);

    Population<dim>   &population;
    const WalkSettings settings;
  };
} // namespace Thalweg

#endif
