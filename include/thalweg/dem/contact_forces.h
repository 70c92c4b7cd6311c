// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_contact_forces_h
#define thalweg_dem_contact_forces_h

#include <thalweg/dem/grain_system.h>

#include <vector>

namespace Thalweg
{
  /// Two grains that touch, and what the second does to the first.
  struct GrainContact
  {
    std::uint32_t first, second; ///< where they are in GrainSystem::grains()
    Vec3          force;         ///< N
    double        overlap;       ///< m
  };

  /**
   * @brief The forces of all pairs that touch, each of them on one rank: for
   * pictures and sums, since none is kept in a step.
   *
   * Springs are those half a sub-step later.
   * @param law of the system
   * @param n_materials that it knows
   */
  std::vector<GrainContact>
  contact_forces(const GrainSystem &system,
                 const ContactLaw  &law,
                 const unsigned int n_materials);
} // namespace Thalweg

#endif
