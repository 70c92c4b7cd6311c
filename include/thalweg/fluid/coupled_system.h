// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_coupled_system_h
#define thalweg_fluid_coupled_system_h

#include <thalweg/fluid/coupled_flow.h>
#include <thalweg/fluid/coupled_stabilization.h>
#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/fluid/pressure_system.h>
#include <thalweg/fluid/shear_viscosities.h>
#include <thalweg/fluid/viscous_operator.h>

namespace Thalweg
{
  /// What a CoupledSystem stands on.
  template <int dim>
  struct CoupledParts
  {
    const NodeSpace<dim>        &space;
    const BoundaryNodes<dim>    &boundary;
    const PhaseField<dim>       &phase;
    const BodyForces<dim>       &forces;
    const NodalMass<dim>        &mass;
    const PressureSystem<dim>   &pressure;
    const ViscousOperator<dim>  &viscous;
    const ShearViscosities<dim> &shear;
  };

  /**
   * @brief The flow equations of a step with velocity and enriched pressure
   * as unknowns together (Eq. 88 to 92), without a matrix.
   *
   * With w = V^{n+1} - V* the change of the velocity, M the nodes' masses, W
   * the inverse of their mass matrix as NodalMass has it, K the friction and
   * G p = int N grad p,
   *
   *   w / dt + M^{-1} K (V* + theta w) + W (G p - F) = 0,
   *   (grad q, w) + T(q; p) = (q, s dt div r + (1 - s) div (V* + lead))
   *
   * for all functions q of the enriched space, where T is the stabilization,
   * tau = s dt its time and r the rate of PressureSystem: where inertia rules
   * (s = 1) the velocity's change is free of divergence together with that of
   * the convection, so that errors of the projection do no work on the
   * pressure; where viscosity does (s = 0) the velocity is, since it has
   * smoothed the errors away. Without friction and with orthogonal subscales
   * the second equation is that of PressureSystem.
   *
   * Rows are divided by the scales of their equations, so that a norm of
   * residuals has no unit and a tolerance is a relative one.
   */
  template <int dim>
  class CoupledSystem
  {
  public:
    /// All that is referred to must outlive the object.
    CoupledSystem(const CoupledParts<dim>    &parts,
                  const CoupledStabilization &stabilization);

    /**
     * @brief Reads the present phases and viscosities. Collective.
     * @param dt s
     * @param theta how much of the friction is that of the step's end
     * @param deflection of a tank that turns, which multiplies accelerations
     * @return the largest nu dt / h^2
     */
    double
    update(const double                  dt,
           const double                  theta,
           const dealii::Tensor<2, dim> &deflection);

    /**
     * @brief Lets the equations' scales be the norms of the accelerations and
     * velocities that act, and of the divergences that these would have if
     * nothing cancelled. Collective.
     * @param velocity_ V* with its boundary values, ghosted, m/s
     * @param given pressure, which is zero but at open boundaries, ghosted
     */
    void
    find_scales(const Vector &velocity_, const EnrichedPressure &given);

    /// How much of the change of viscosities by the velocity the matrix has:
    /// 1 with Newton's method, else 0.
    void
    set_tangent(const double factor)
    {
      tangent_factor = factor;
    }

    /**
     * @brief What the equations lack. Collective.
     * @param velocity_ V* with its boundary values, m/s, ghosted
     * @param rate r, m/s^2, ghosted
     * @param lead m/s, ghosted
     * @param change w, m/s, ghosted
     * @param pressure with its values at open boundaries, ghosted
     * @param residual out
     */
    void
    find_residual(const Vector           &velocity_,
                  const Vector           &rate,
                  const Vector           &lead,
                  const Vector           &change,
                  const EnrichedPressure &pressure,
                  CoupledFlow            &residual);

    /// The product with the matrix. Collective.
    void
    vmult(CoupledFlow &result, const CoupledFlow &flow) const;

    /**
     * @brief Adds -M^{-1} int N p n of jumps at the interface to the owned
     * values: they balance friction, and so have its masses. Overwrites what
     * has been found of friction.
     */
    void
    add_jumps(const EnrichedPressure &pressure, Vector &result) const;

    /// What the rows of the momentum equation, in m/s^2, are divided by, and
    /// those of the other one.
    double
    momentum_scale() const
    {
      return scales[0];
    }

    double
    continuity_scale() const
    {
      return scales[1];
    }

    double
    part_of_end() const
    {
      return theta;
    }

    /// tau of the cells, s; those of the last update().
    const std::vector<double> &
    stabilization_times() const
    {
      return taus;
    }

  private:
    /// friction = -factor M^{-1} K velocity_, with free components only.
    void
    find_friction(const Vector &velocity_,
                  const double  factor,
                  const bool    with_tangent = false) const;

    /// From forces of this rank's cells to accelerations, in `friction`.
    void
    finish_friction(const double factor) const;

    /// Dependent nodes have no rows.
    void
    clear_dependent(Vector &rows) const;

    /// The rows of the first equation from accelerations.
    void
    finish_momentum(Vector &rows) const;

    /// What the stabilization has against pressure and forces.
    /// @param projection what nodes make of both @param change w, owned
    void
    find_balance(const Vector &projection, const Vector &change) const;

    /// Adds T of a pressure, with the balance.
    void
    add_stabilization(const bool              with_forces,
                      const EnrichedPressure &pressure) const;

    /// The rows of the second equation from what cells have added to `load`.
    /// @param factor of them
    void
    finish(const double factor, CoupledFlow &rows) const;

    /// Takes a constant away that no velocity can give.
    void
    balance(Vector &rows) const;

    const CoupledParts<dim>     parts;
    const CoupledStabilization &stabilization;
    double                      dt = 1., theta = 1., tangent_factor = 0.;
    double                      largest_tau = 1.;
    dealii::Tensor<2, dim>      deflection;
    std::array<double, 2>       scales{{1., 1.}};
    /// 1/h^2 of the cells, the mean over their directions, 1/m^2
    std::vector<double>      inverse_squares;
    std::vector<double>      taus;          ///< of the cells, s
    std::vector<double>      impulse_times; ///< s dt of the cells, s
    std::vector<double>      rests;         ///< 1 - s of the cells
    Vector                   measures;      ///< int N_i
    Vector                   extents;       ///< sum of int |grad N_i|
    mutable Vector           work, acceleration, friction, against;
    mutable EnrichedPressure pressure_work, load;
  };
} // namespace Thalweg

#endif
