// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_dispersed_motion_h
#define thalweg_methods_dispersed_motion_h

#include <thalweg/fluid/body_forces.h>
#include <thalweg/materials/fluids.h>
#include <thalweg/particles/dispersed_field.h>

namespace Thalweg
{
  /**
   * @brief How drops and bubbles move under body forces.
   *
   * Drops fall freely: what the lighter fluid does to them is neglected.
   * Bubbles rise against the acceleration a at once with the velocity at which
   * drag balances buoyancy, for a sphere of their volume (in two dimensions a
   * cylinder) with the diameter d: the lesser one of that of a solid sphere in
   * creeping flow, (rho_1 - rho_2) a d^2 / (18 mu_1) (Stokes), and of a
   * spherical cap, 0.71 sqrt(a d) (R. M. Davies and G. I. Taylor, 1950).
   *
   * @param forces, fluids must outlive what is returned; the forces are those
   *   at the time to which they are set when it is called
   */
  template <int dim>
  DispersedMotion<dim>
  dispersed_motion(const BodyForces<dim> &forces, const Fluids &fluids);
} // namespace Thalweg

#endif
