// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_grain_budget_h
#define thalweg_methods_grain_budget_h

#include <thalweg/methods/grain_view.h>

#include <mpi.h>

namespace Thalweg
{
  /// What the grains of all ranks are together.
  struct GrainSums
  {
    double n           = 0.;
    double mass        = 0.;     ///< kg
    double translation = 0.;     ///< kinetic energy, J
    double rotation    = 0.;     ///< kinetic energy, J
    double potential   = 0.;     ///< of gravity, J
    double elastic     = 0.;     ///< in springs along normals, J
    double sheared     = 0.;     ///< in those at right angles, J
    double rolled      = 0.;     ///< in those of rolling, J
    Vec3   momentum{0., 0., 0.}; ///< kg m/s
    Vec3   center{0., 0., 0.};   ///< of mass, times mass, kg m
    double n_contacts      = 0.; ///< of pairs, and of grains with walls
    double n_wall_contacts = 0.;
    double largest_overlap = 0.; ///< over the smaller diameter
    double fastest         = 0.; ///< m/s
  };

  /// Kinetic and potential energy of one grain, J.
  /// @param datum where the potential is zero, m
  double
  energy_of_grain(const GrainSystem &system,
                  const GrainRecord &grain,
                  const Vec3        &gravity,
                  const Vec3        &datum);

  /// Sums over all grains and contacts. Collective.
  GrainSums
  sum_up(const MPI_Comm   communicator,
         const GrainView &view,
         const Vec3      &gravity,
         const Vec3      &datum);
} // namespace Thalweg

#endif
