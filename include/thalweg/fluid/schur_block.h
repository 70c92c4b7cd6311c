// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_schur_block_h
#define thalweg_fluid_schur_block_h

#include <thalweg/core/registry.h>
#include <thalweg/fluid/pressure_system.h>
#include <thalweg/fluid/viscous_operator.h>

namespace Thalweg
{
  /**
   * @brief An approximate inverse of the Schur complement of a CoupledSystem,
   * what is left for the pressure when the velocity is eliminated. Registered
   * under "Pressure block".
   */
  template <int dim>
  class SchurBlock
  {
  public:
    virtual ~SchurBlock() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// What the object refers to; all must outlive it, or the next
    /// initialize().
    struct Parts
    {
      const NodeSpace<dim>       &space;
      const PhaseField<dim>      &phase;
      const PressureSystem<dim>  &pressure;
      const ViscousOperator<dim> &viscous;
      /// tau of the cells, s
      const std::vector<double> &stabilization_times;
    };

    virtual void
    initialize(const Parts &parts) = 0;

    /// Reads the present phases and viscosities. Collective.
    /// @param inverse_dt 1/dt, 1/s
    /// @param theta how much of the friction is that of the step's end
    virtual void
    update(const double inverse_dt, const double theta) = 0;

    /// @param destination, source owned values. Collective.
    virtual void
    vmult(EnrichedPressure       &destination,
          const EnrichedPressure &source) const = 0;
  };
} // namespace Thalweg

#endif
