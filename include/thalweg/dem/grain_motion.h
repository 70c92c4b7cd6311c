// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_motion_h
#define thalweg_dem_grain_motion_h

#include <thalweg/dem/grain_arrays.h>

namespace Thalweg
{
  /**
   * @brief One pass of the leapfrog (Eq. 99-104 of seed 000): kicks velocities and
   * spins, moves places, forgets forces, and extrapolates the velocities to the
   * end of the step, since dashpots would lag half a step behind with those of
   * its middle.
   * @param kick how long forces act, s: half of @p dt at the first step
   * @param dt s
   * @param acceleration of all grains, m/s^2
   * @return the square of the greatest speed of this rank's grains, m^2/s^2
   */
  double
  kick_and_drift(GrainArrays &grains,
                 const double kick,
                 const double dt,
                 const Vec3  &acceleration);

  /// Brings velocities and spins from the middle of a step to its end.
  /// @param kick half of the step, s
  void
  kick(GrainArrays &grains, const double kick, const Vec3 &acceleration);
} // namespace Thalweg

#endif
