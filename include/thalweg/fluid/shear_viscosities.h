// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_shear_viscosities_h
#define thalweg_fluid_shear_viscosities_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fluid/fluid_viscosities.h>
#include <thalweg/interface/phase_field.h>

namespace Thalweg
{
  /**
   * @brief The viscosities of fluids that depend on how fast they are sheared,
   * and on what FluidViscosities say besides: a number a cell, from the
   * velocity gradient in its middle.
   *
   * In cut cells the fluids form a laminate: the shear across the interface is
   * that with which both have the same shear stress, but for cells where fluid
   * sticks to a wall, see ViscousOperator.
   */
  template <int dim>
  class ShearViscosities
  {
  public:
    /// All must outlive the object.
    ShearViscosities(const NodeSpace<dim>        &space,
                     const BoundaryNodes<dim>    &boundary,
                     const PhaseField<dim>       &phase,
                     const FluidViscosities<dim> &given);

    /// Whether any viscosity depends on the shear rate. If none does
    /// viscosities() are those given.
    bool
    depend_on_shear() const
    {
      return is_active;
    }

    const FluidViscosities<dim> &
    viscosities() const
    {
      return is_active ? own : given;
    }

    /**
     * @brief Lets the viscosities be those of a velocity.
     * @param velocity ghosted, m/s
     * @param with_cut_cells whether also in cut cells, or there they stay:
     *   that of a fluid and the share of the shear that it gets depend on each
     *   other, and iterations between both go round in circles.
     */
    void
    update(const Vector &velocity, const bool with_cut_cells = true);

    /**
     * @brief Adds -factor times the change of the viscous force by that of the
     * viscosities when the velocity at the last update() changes by @p change,
     * in N, of this rank's cells; not folded.
     */
    void
    subtract_tangent(const Vector &change,
                     const double  factor,
                     Vector       &force) const;

  private:
    static constexpr unsigned int n_vertices = 1 << dim;

    /// The velocity gradient in the middle of a cell.
    dealii::Tensor<2, dim>
    gradient(const Vector &velocity, const unsigned int cell) const;

    /// The shear rate of a fluid in a cell for a symmetric 2 eps.
    double
    shear_rate(const dealii::Tensor<2, dim> &twice_rate,
               const unsigned int            fluid,
               const unsigned int            cell) const;

    const NodeSpace<dim>        &space;
    const PhaseField<dim>       &phase;
    const FluidViscosities<dim> &given;
    const bool                   is_active;
    const std::vector<bool>      at_wall;
    FluidViscosities<dim>        own;
    Q1::Gauss<dim>               gauss;
    /// The velocity at the last update(), and of uncut cells d mu / d rate^2.
    Vector              last;
    std::vector<double> slopes;
  };
} // namespace Thalweg

#endif
