// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_missing_fluid_h
#define thalweg_methods_missing_fluid_h

#include <thalweg/materials/fluids.h>
#include <thalweg/mesh/mesh.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/function.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief What to tell users if one of two fluids has no particle: mostly the
   * initial level set and the mesh are not of the same place or unit.
   * Collective.
   * @return nothing if both have some
   */
  template <int dim>
  std::string
  missing_fluid(const Population<dim> &population, const Fluids &fluids);

  /**
   * @brief The same before there are particles: whether the level set leaves
   * one of two fluids less than a particle's volume.
   * @param mesh the coarse mesh
   * @param n_particles about how many particles the run would begin with
   */
  template <int dim>
  std::string
  missing_fluid(const Mesh<dim>             &mesh,
                const Fluids                &fluids,
                const dealii::Function<dim> &level_set,
                const double                 n_particles);
} // namespace Thalweg

#endif
