// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_boundary_nodes_h
#define thalweg_fields_boundary_nodes_h

#include <thalweg/fields/boundary_faces.h>
#include <thalweg/fields/fixed_nodes.h>
#include <thalweg/fields/node_space.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What the boundary conditions ask of the velocities and pressures
   * at the nodes.
   *
   * A node has as many fixed directions as conditions demand: one on a
   * smooth slip wall, two on an edge between two, none on one that sticks
   * out into the fluid, all of them where the velocity is given or the fluid
   * sticks.
   */
  template <int dim>
  class BoundaryNodes
  {
  public:
    /// Reads mesh and conditions; make a new object after the mesh changed.
    BoundaryNodes(const NodeSpace<dim>          &space,
                  const BoundaryConditions<dim> &conditions);

    /// Sets the fixed components of a velocity to their values at the time
    /// of the conditions. Owned entries only; ghosts are not updated.
    void
    apply(Vector &velocity) const
    {
      fixed.apply(conditions_, velocity);
    }

    /// Removes the fixed components.
    void
    project(Vector &velocity) const
    {
      fixed.project(velocity);
    }

    /// Removes the normal components at slip walls. Owned entries only.
    void
    project_slip(Vector &velocity) const
    {
      slip.project(velocity);
    }

    /**
     * @brief Adds @p factor times the integral of N_i (@p field . n) over the
     * boundaries with a given velocity to @p scalar (this rank's cells; not
     * yet folded).
     * @param field at the nodes, ghosted and consistent
     */
    void
    add_flux(const Vector &field, const double factor, Vector &scalar) const;

    /// Of each owned cell: whether the velocity is given as a whole at one of
    /// its nodes or more, as where fluid sticks. Collective.
    std::vector<bool>
    cells_with_given_nodes() const;

    using Face = BoundaryFace<dim>;

    /// The faces of locally owned cells at boundaries where fluid can pass.
    const std::vector<Face> &
    passable_faces() const
    {
      return faces;
    }

    /// A node where the pressure is given.
    struct PressureNode
    {
      unsigned int               node;
      dealii::Point<dim>         position;
      dealii::types::boundary_id id;
      dealii::Tensor<1, dim>     normal; ///< outward, or 0 if sides cancel
    };

    /// The nodes, owned and ghost, at open boundaries.
    const std::vector<PressureNode> &
    pressure_nodes() const
    {
      return open_nodes;
    }

    const BoundaryConditions<dim> &
    conditions() const
    {
      return conditions_;
    }

  private:
    void
    collect_nodes();

    void
    collect_faces();

    const NodeSpace<dim>          &space;
    const BoundaryConditions<dim> &conditions_;
    FixedNodes<dim>                fixed;
    FixedNodes<dim>                slip;
    std::vector<PressureNode>      open_nodes;
    std::vector<Face>              faces;
  };
} // namespace Thalweg

#endif
