// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_particle_journeys_h
#define thalweg_particles_particle_journeys_h

#include <thalweg/particles/dispersed_field.h>
#include <thalweg/particles/population.h>
#include <thalweg/particles/streamline_convection.h>
#include <thalweg/particles/streamline_walk.h>

namespace Thalweg
{
  /// What @p parameters and @p walls say to a walk.
  /// @throws dealii::ExcMessage for parameters that make no sense
  WalkSettings
  walk_settings(const ConvectionParameters &parameters,
                const std::map<dealii::types::boundary_id, WallKind> &walls);

  /**
   * @brief Lets all particles of the population walk for the time @p dt, on
   * other ranks too, and adds to their velocity what the walk says. Collective.
   *
   * Afterwards the particles of each cell are ordered by id, whatever happened
   * before. So a resumed run, whose particles come from a file, continues bit
   * by bit like the straight one.
   *
   * @param population its particles are those of locally owned cells
   * @param walk through the fields
   * @param dt s
   * @return what became of them, on this rank
   */
  template <int dim, typename Field>
  ConvectionReport
  move_along(Population<dim>                  &population,
             const StreamlineWalk<dim, Field> &walk,
             const double                      dt);

  /// What became of drops and bubbles.
  template <int dim>
  struct Dispersal
  {
    ConvectionReport report;
    /// Those that met their own fluid on this rank, with the velocity and the
    /// time left that they had then.
    std::vector<NewParticle<dim>> landed;
    /// What accelerated each of them, m/s^2.
    std::vector<std::array<double, dim>> accelerations;
  };

  /// As move_along() for drops and bubbles; those that land are taken out of
  /// the population. Collective.
  template <int dim>
  Dispersal<dim>
  disperse_along(Population<dim>                                &population,
                 const StreamlineWalk<dim, DispersedField<dim>> &walk,
                 const double                                    dt);

  /// Inserts particles that each walk for a time of their own, and returns
  /// what became of those that ended on this rank. Collective.
  template <int dim>
  ConvectionReport
  insert_along(Population<dim>                     &population,
               const StreamlineWalk<dim>           &walk,
               const std::vector<NewParticle<dim>> &particles);
} // namespace Thalweg

#endif
