// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_velocity_block_h
#define thalweg_fluid_velocity_block_h

#include <thalweg/core/registry.h>
#include <thalweg/fluid/viscous_operator.h>

namespace Thalweg
{
  /**
   * @brief An approximate inverse of M/dt + K, the block of the velocity in
   * a CoupledSystem. Registered under "Velocity block".
   */
  template <int dim>
  class VelocityBlock
  {
  public:
    virtual ~VelocityBlock() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Sets up for a mesh. What it refers to must outlive the object, or the
    /// next initialize().
    virtual void
    initialize(const NodeSpace<dim>       &space,
               const BoundaryNodes<dim>   &boundary,
               const ViscousOperator<dim> &viscous) = 0;

    /// Reads what the operator is after its update(). Collective.
    /// @param fourier_number the largest nu dt / h^2
    virtual void
    update(const double fourier_number) = 0;

    /// @param destination, source owned values, without fixed components.
    ///   Collective.
    virtual void
    vmult(Vector &destination, const Vector &source) const = 0;

    /// How many hierarchies or factorizations have been made so far.
    virtual unsigned int
    n_setups() const
    {
      return 0;
    }
  };
} // namespace Thalweg

#endif
