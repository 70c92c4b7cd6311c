// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_velocity_projection_h
#define thalweg_transfer_velocity_projection_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/lagrange_space.h>
#include <thalweg/particles/population.h>

namespace Thalweg
{
  /**
   * @brief The velocity of a single fluid from the particles to a space of
   * any degree; registered under "Velocity projection".
   */
  template <int dim>
  class VelocityProjection
  {
  public:
    virtual ~VelocityProjection() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /**
     * @brief Projects. Collective.
     * @param population particles with valid reference coordinates
     * @param space of the velocity
     * @param velocity in: a guess, ghosted, which stays where no particle
     *   reaches; out: V*, ghosted and consistent, m/s
     * @return iterations of the linear solver, if there is one
     * @throws StepFailure
     */
    virtual unsigned int
    project(const Population<dim>    &population,
            const LagrangeSpace<dim> &space,
            Vector                   &velocity) const = 0;
  };

  /**
   * @brief V_p += N(x_p) (V^{n+1} - V*) (Eq. 81e), blended with the mesh's
   * velocity: V_p = (1 - blend) (V_p + increment) + blend N(x_p) V^{n+1}.
   */
  template <int dim>
  void
  add_increment(Population<dim>          &population,
                const LagrangeSpace<dim> &space,
                const Vector             &new_velocity,
                const Vector             &velocity_star,
                const double              blend);

  /// V_p += factor N(x_p) field.
  template <int dim>
  void
  add_field(Population<dim>          &population,
            const LagrangeSpace<dim> &space,
            const Vector             &field,
            const double              factor);
} // namespace Thalweg

#endif
