// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_flow_step_numbers_h
#define thalweg_methods_flow_step_numbers_h

#include <thalweg/core/step_number.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/materials/fluids.h>

#include <limits>

namespace Thalweg
{
  /**
   * @brief What bounds the steps of a flow: its Courant number, where
   * viscosity is explicit its Fourier number and, with surface tension, the
   * step over the shortest one in which a capillary wave passes a cell.
   */
  template <int dim>
  class FlowStepNumbers
  {
  public:
    /**
     * @brief On the present mesh of @p space, which must outlive the object.
     * Collective.
     * @param stable the largest Fourier number with which the method is stable
     *   (Eq. 65)
     * @param surface_tension N/m
     */
    FlowStepNumbers(
      const NodeSpace<dim> &space,
      const Fluids         &fluids,
      const double          stable = std::numeric_limits<double>::infinity(),
      const double          surface_tension = 0.);

    /// @param velocity at the nodes, ghosted, m/s. Collective.
    StepNumbers
    of(const Vector &velocity) const;

  private:
    const NodeSpace<dim> &space;
    const double          stable_fourier_number;
    /// The largest nu / h^2, 1/s.
    const double fourier_rate;
    /// sqrt(4 pi sigma / ((rho_1 + rho_2) h^3)), 1/s (Brackbill et al. 1992)
    const double capillary_rate;
  };
} // namespace Thalweg

#endif
