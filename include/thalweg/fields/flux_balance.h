// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_flux_balance_h
#define thalweg_fields_flux_balance_h

#include <thalweg/fields/boundary_conditions.h>

namespace Thalweg
{
  /**
   * @brief Refuses given velocities that let more in than out, or less, where
   * no boundary is open that would make up for it: such a flow is not that of
   * an incompressible fluid.
   *
   * Fluxes are integrated with two rules a face, and may differ by twice
   * what these differ, and by a millionth. Collective.
   *
   * @param conditions their time is the same afterwards
   * @param mesh a coarse one of the same domain serves as well: curved
   *   boundaries count as curved
   * @param time in s, for functions that depend on it
   * @throws dealii::ExcMessage with the fluxes, on all processes
   */
  template <int dim>
  void
  check_flux_balance(const BoundaryConditions<dim> &conditions,
                     const Mesh<dim>               &mesh,
                     const double                   time);
} // namespace Thalweg

#endif
