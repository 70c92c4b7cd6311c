// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_boundary_reaction_h
#define thalweg_fluid_boundary_reaction_h

#include <thalweg/fluid/flow_operators.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief The forces of a fluid on the boundary nodes whose velocity is
   * fixed: the residual of the momentum equation in Eulerian form, with the
   * nodes' own test functions, at the middle of a step.
   *
   * -rho [(N, dV/dt + V . grad V - b) + nu (grad N, grad V) - (div N, p)],
   * where V is the mean of the velocities before and after the step and p the
   * pressure at its middle: all are the mesh's, so the error of the time
   * integration of the particles does not enter.
   */
  template <int dim>
  class BoundaryReaction
  {
  public:
    /// The arguments must outlive the object.
    BoundaryReaction(const FlowOperators<dim> &operators,
                     const FlowBoundary<dim>  &boundary,
                     const double              kinematic_viscosity);

    /**
     * @param begin_velocity and @p end_velocity of the step, ghosted, m/s
     * @param pressure at the middle of the step over the density, ghosted
     * @param body_force nodal, ghosted, m/s^2
     * @param dt s
     * @param density kg/m^3
     * @param reaction out: N (N/m in 2D), ghosted
     */
    void
    find(const Vector &begin_velocity,
         const Vector &end_velocity,
         const Vector &pressure,
         const Vector &body_force,
         const double  dt,
         const double  density,
         Vector       &reaction);

    /**
     * @brief The viscous force per area: what is left of the reaction
     * without the pressure on the boundary faces where the velocity is given
     * or zero, over the integrals of the shape functions there.
     *
     * At a node where two of these faces meet at an angle it is a mean of
     * both.
     * @param reaction of find()
     * @param pressure over the density, ghosted
     * @param traction out: Pa, ghosted; zero at all other nodes
     */
    void
    find_traction(const Vector &reaction,
                  const Vector &pressure,
                  const double  density,
                  Vector       &traction) const;

  private:
    /// A face's [node of velocity][node of pressure] int N q n.
    struct Face
    {
      unsigned int                        cell;
      std::vector<dealii::Tensor<1, dim>> pressure;
    };

    void
    collect_boundary_cells();

    void
    collect_faces();

    /// Adds factor (N, V . grad V) of the cells at the boundary.
    void
    add_convection(const double factor, Vector &force) const;

    const FlowOperators<dim> &operators;
    const FlowBoundary<dim>  &boundary;
    const double              nu;
    std::vector<unsigned int> boundary_cells;
    std::vector<Face>         faces;
    /// int N over all of them, for each component of the nodes.
    Vector area;
    Vector velocity, acceleration;
  };
} // namespace Thalweg

#endif
