// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_coupled_stabilization_h
#define thalweg_fluid_coupled_stabilization_h

#include <thalweg/core/registry.h>

namespace Thalweg
{
  /**
   * @brief What keeps the pressure of a CoupledSystem free of oscillations
   * (Eq. 89, 90): the term
   *
   *   T(q; p) = tau (grad q, g + f / rho - grad p / rho - a)
   *
   * in the equation of continuity, where a is what the terms stand against.
   * Registered under "Stabilization".
   */
  class CoupledStabilization
  {
  public:
    virtual ~CoupledStabilization() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// What a is: the acceleration of the fluid w / dt; what nodal values can
    /// represent of forces and pressure gradient; or the nodal friction.
    enum class Balance
    {
      acceleration,
      projection,
      friction
    };

    virtual Balance
    balance() const = 0;

    /**
     * @brief 1/tau in a cell, 1/s.
     * @param viscous_rate nu / h^2, 1/s
     * @param inverse_dt 1/dt, 1/s
     */
    virtual double
    rate(const double viscous_rate, const double inverse_dt) const = 0;
  };
} // namespace Thalweg

#endif
