// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_seeding_h
#define thalweg_particles_seeding_h

#include <thalweg/core/section.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/function.h>

#include <functional>

namespace Thalweg
{
  /// Where particles stand at the start.
  struct SeedingParameters
  {
    /// Declares the parameters in @p section.
    void
    declare_parameters(const Section &section);

    /// Sub-cells in each direction, with one particle in each.
    unsigned int particles_per_direction = 3;
    /// Displacement from the centre of a sub-cell in parts of half the
    /// sub-cell, between 0 (none) and 1 (anywhere in the sub-cell).
    double jitter = 0;
  };

  /**
   * @brief Fills all cells with particles. Collective.
   *
   * Position and id of each particle follow from its cell alone, so they are
   * the same on any number of ranks.
   *
   * @param population gets the particles; it should be empty
   * @param parameters how many and where
   * @param velocity dim components, in m/s
   * @param level_set one component, negative in the denser fluid
   * @param negative_volume of a cell, in m^dim: what the particles of fluid 0
   *   in it share; those of fluid 1 share the rest. A fluid that none of the
   *   regular particles of the cell stands in gets another one. Without this
   *   function particles carry no volume.
   * @throws dealii::ExcMessage if the functions have the wrong number of
   * components
   */
  template <int dim>
  void
  seed(Population<dim>             &population,
       const SeedingParameters     &parameters,
       const dealii::Function<dim> &velocity,
       const dealii::Function<dim> &level_set,
       const std::function<double(const typename CellGraph<dim>::Cell &)>
         &negative_volume = {});
} // namespace Thalweg

#endif
