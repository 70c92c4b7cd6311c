// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_pressure_stabilization_h
#define thalweg_fluid_pressure_stabilization_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/dependences.h>

namespace Thalweg
{
  /**
   * @brief What keeps the pressure of an incremental fractional step free of
   * oscillations where velocity and pressure have equal degrees (Eq. 74-76):
   * tau (grad q, grad p - b) in the equation of continuity, where b is an
   * approximation of grad p by nodal values. Registered under
   * "Stabilization"; quantities are divided by the density.
   */
  template <int dim>
  class PressureStabilization
  {
  public:
    virtual ~PressureStabilization() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Whether there is any.
    virtual bool
    is_active() const
    {
      return true;
    }

    /**
     * @brief The parameter tau of a cell, in s.
     * @param length of the cell, m
     * @param kinematic_viscosity m^2/s
     * @param speed in the cell, m/s
     * @param dt s
     */
    virtual double
    parameter(const double length,
              const double kinematic_viscosity,
              const double speed,
              const double dt) const = 0;

    /**
     * @brief The nodal field b that stands for the pressure gradient, m/s^2.
     * @param pressure_gradient pi of Eq. 79
     * @param forces body and viscous forces, b + g of Eq. 78
     */
    virtual const Vector &
    balance(const Vector &pressure_gradient, const Vector &forces) const = 0;
  };
} // namespace Thalweg

#endif
