// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_materials_rheology_h
#define thalweg_materials_rheology_h

#include <thalweg/core/registry.h>

namespace Thalweg
{
  /**
   * @brief How the viscosity of a fluid depends on how fast it is sheared.
   * Registered under "Rheology" of each fluid.
   *
   * The shear rate is that of the rate of strain eps, sqrt(2 eps : eps).
   */
  class Rheology
  {
  public:
    virtual ~Rheology() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Whether the viscosity depends on the shear rate at all.
    virtual bool
    depends_on_shear() const
    {
      return true;
    }

    /// A viscosity and its derivative by the shear rate.
    struct Value
    {
      double viscosity; ///< Pa s
      double slope;     ///< Pa s^2
    };

    /**
     * @param shear_rate at least 0, 1/s
     * @param reference what the parameter "Viscosity" of the fluid says, or a
     *   coupling where it depends on other things
     */
    virtual Value
    value(const double shear_rate, const double reference) const = 0;
  };
} // namespace Thalweg

#endif
