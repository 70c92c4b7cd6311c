// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_stokes_pressure_h
#define thalweg_fluid_stokes_pressure_h

#include <thalweg/fluid/wall_friction.h>

#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What friction demands of the pressure: the harmonic part that the
   * vorticity at boundaries makes.
   *
   * A velocity field without divergence has Lap u = -rot rot u, so that
   *
   * (grad q, nu Lap u) = -nu <grad q, n x rot u>
   *
   * with integrals over boundaries alone (Liu, Liu and Pego 2007): first
   * derivatives there instead of second ones inside, whose noise is kept out
   * of the pressure. The velocity's derivative along the normal is that of
   * WallFriction where the velocity is given or zero, and zero elsewhere.
   */
  template <int dim>
  class StokesPressure
  {
  public:
    /// @param operators must outlive the object
    StokesPressure(const FlowOperators<dim> &operators,
                   const FlowBoundary<dim>  &boundary,
                   const double              kinematic_viscosity);

    /**
     * @brief result -= nu <grad q, n x rot V>; not folded. Collective.
     * @param velocity ghosted
     * @param g its viscous acceleration, m/s^2, ghosted
     */
    void
    add(const Vector &velocity, const Vector &g, Vector &result);

  private:
    /// What a face gives to the nodes of its cell's pressure.
    struct Face
    {
      unsigned int cell;
      /// [node of pressure][node of velocity][component]
      std::vector<double> of_velocity;
      /// [node of pressure][node of the face][component]; empty where the
      /// velocity is neither given nor zero.
      std::vector<double> of_friction;
    };

    /// What the velocity's derivatives along the face give.
    void
    add_velocity(const dealii::FEFaceValues<dim> &velocity,
                 const dealii::FEFaceValues<dim> &pressure,
                 Face                            &face) const;

    /// What that along its normal gives.
    void
    add_friction(const dealii::FEFaceValues<dim> &velocity,
                 const dealii::FEFaceValues<dim> &pressure,
                 const unsigned int               face_no,
                 Face                            &face) const;

    const FlowOperators<dim> &operators;
    const double              nu;
    WallFriction<dim>         friction;
    std::vector<Face>         faces; ///< those with friction in its order
  };
} // namespace Thalweg

#endif
