#ifndef thalweg_particles_particle_journeys_h
#define thalweg_particles_particle_journeys_h

#include <thalweg/particles/journey.h>
#include <thalweg/particles/population.h>
#include <thalweg/particles/streamline_walk.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /// What a particle takes along.
  template <int dim>
  struct Particle
  {
    dealii::types::particle_index                     id;
    std::array<double, Population<dim>::n_properties> properties;
  };

  /**
   * @brief Copies all particles out of the population, and lets each walk as
   * far as this rank reaches.
   * @param population stays as it is
   * @param walk through the velocity field
   * @param dt s
   * @param effort is added to
   */
  template <int dim>
  std::vector<Traveller<dim, Particle<dim>>>
  depart(const Population<dim>     &population,
         const StreamlineWalk<dim> &walk,
         const double               dt,
         WalkEffort                &effort);

  /**
   * @brief Makes those of the travellers that have arrived the population:
   * those of each cell by id, whatever happened before. So a resumed run,
   * whose particles come from a file, continues bit by bit like the straight
   * one.
   * @return how many have arrived
   */
  template <int dim>
  std::size_t
  arrive(Population<dim>                                  &population,
         const StreamlineWalk<dim>                        &walk,
         const std::vector<Traveller<dim, Particle<dim>>> &travellers);
} // namespace Thalweg

#endif
