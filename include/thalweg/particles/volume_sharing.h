// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_volume_sharing_h
#define thalweg_particles_volume_sharing_h

#include <thalweg/particles/population.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Lets particles of one fluid carry equal parts of the volume that
   * they carry together.
   *
   * With the volume goes what properties that were added say of it, so that
   * none of that is lost: who gets volume gets a mixture of what others give.
   * Who has none, and knows its property, has just come in with that.
   */
  template <int dim>
  void
  share_volume(const std::vector<ParticleReference<dim, false>> &particles);

  /// Gives what one particle carries to another one of its fluid, with its
  /// momentum. Place and level set stay: a plane remains a plane.
  template <int dim>
  void
  merge(const ParticleReference<dim, false> &from,
        const ParticleReference<dim, false> &into);
} // namespace Thalweg

#endif
