// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_viscous_operator_h
#define thalweg_fluid_viscous_operator_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/fluid/fluid_viscosities.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/linear_algebra/jacobi.h>

namespace Thalweg
{
  /**
   * @brief M(rho)/dt + K(mu), the operator of the viscous predictor
   * (Eq. 87b), without a matrix.
   *
   * M is lumped; K has the full symmetric stress, int 2 mu eps(u) : eps(v).
   * In cut cells the fluids form a laminate: shear across the interface
   * sees the harmonic mean of the viscosities, all else the arithmetic one.
   * Where fluid sticks to a wall it does too: a film of the lighter fluid under
   * a heavier one that rolls over it is thinner than the mesh can show, and
   * would let a paste slide over the floor.
   * Fixed velocity components are projected out, so the operator is
   * symmetric and positive definite on what remains.
   */
  template <int dim>
  class ViscousOperator
  {
  public:
    /// @param viscosities nullptr: those of the phase's fluids
    ViscousOperator(const NodeSpace<dim>        &space,
                    const BoundaryNodes<dim>    &boundary,
                    const PhaseField<dim>       &phase,
                    const FluidViscosities<dim> *viscosities = nullptr);

    /// @param mass_ lumped masses, kg, a value a node
    /// @param dt s
    void
    update(const Vector &mass_, const double dt);

    /// Adds -K v, in N, of this rank's cells; not folded.
    void
    subtract_viscous_force(const Vector &velocity, Vector &force) const;

    /// destination = P (M/dt + K) P source
    void
    vmult(Vector &destination, const Vector &source) const;

    const Jacobi<Vector> &
    jacobi() const
    {
      return diagonal;
    }

    static constexpr unsigned int n_cell_values = dim * (1 << dim);
    using CellMatrix =
      std::array<std::array<double, n_cell_values>, n_cell_values>;

    /// K of a cell, the components of a node one behind the other.
    CellMatrix
    cell_matrix(const unsigned int cell) const;

    /// What update() was given: kg, and s.
    const Vector &
    masses() const
    {
      return *mass;
    }

    double
    time_step() const
    {
      return dt;
    }

    /// The viscosity in a cell: one number, or that of a laminate.
    struct CellViscosity
    {
      double              viscosity; ///< Pa s; in a cut cell the mean
      double              harmonic;  ///< the harmonic mean in a cut cell
      const CutCell<dim> *cut;       ///< nullptr in an uncut cell

      /// The stress for a velocity gradient.
      dealii::Tensor<2, dim>
      stress(const dealii::Tensor<2, dim> &velocity_gradient) const
      {
        const dealii::Tensor<2, dim> twice_rate =
          velocity_gradient + transpose(velocity_gradient);
        return cut ? laminate_stress(twice_rate) : viscosity * twice_rate;
      }

      /// The same in a cut cell from twice the rate of strain.
      dealii::Tensor<2, dim>
      laminate_stress(const dealii::Tensor<2, dim> &twice_rate) const;

      /// The stress of a velocity in direction @p component that has the
      /// gradient @p gradient, times the same: an entry of the diagonal.
      inline double
      diagonal(const dealii::Tensor<1, dim> &gradient,
               const unsigned int            component) const;
    };

    CellViscosity
    cell_viscosity(const unsigned int cell) const;

    /// Of the fluids in a cell, m^2/s.
    double
    largest_kinematic_viscosity(const unsigned int cell) const;

    /// The mean viscosity of a cell over the least density in it, m^2/s.
    double
    kinematic_viscosity_of_lightest(const unsigned int cell) const;

  private:
    /// A cell in which both sides are integrated by themselves, or nullptr.
    const CutCell<dim> *
    cell_with_jumps(const unsigned int cell) const;

    /**
     * @brief K of a cell where the pressure may jump: each side has its own
     * viscosity, so that the jump of the stress is exactly that of the
     * pressure, but for shear across the interface, which has the harmonic
     * mean on both.
     */
    CellMatrix
    matrix_of_sides(const unsigned int cell, const CutCell<dim> &cut) const;

    /// Pa s
    double
    fluid_viscosity(const unsigned int fluid, const unsigned int cell) const;

    const NodeSpace<dim>        &space;
    const BoundaryNodes<dim>    &boundary;
    const PhaseField<dim>       &phase;
    const FluidViscosities<dim> *viscosities;
    const std::vector<bool>      at_wall; ///< cells where fluid sticks
    Q1::Gauss<dim>               gauss;
    const Vector                *mass = nullptr;
    double                       dt   = 1.;
    Jacobi<Vector>               diagonal;
    mutable Vector               work;
  };
} // namespace Thalweg

#endif
