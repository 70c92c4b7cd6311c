// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_flow_boundary_h
#define thalweg_fields_flow_boundary_h

#include <thalweg/fields/fixed_nodes.h>
#include <thalweg/fields/lagrange_space.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What the boundary conditions ask of the velocities and pressures
   * of a flow in spaces of any degree, on curved boundaries too.
   */
  template <int dim>
  class FlowBoundary
  {
  public:
    /// All arguments must outlive the object.
    FlowBoundary(const LagrangeSpace<dim>      &velocity_space,
                 const LagrangeSpace<dim>      &pressure_space,
                 const BoundaryConditions<dim> &conditions);

    /// Sets the fixed components of a velocity to their values at the time
    /// of the conditions. Owned entries only; ghosts are not updated.
    void
    apply(Vector &velocity) const
    {
      fixed_nodes.apply(conditions_, velocity);
    }

    /// Removes the fixed components.
    void
    project(Vector &velocity) const
    {
      fixed_nodes.project(velocity);
    }

    /// Removes the normal components at slip walls. Owned entries only.
    void
    project_slip(Vector &velocity) const
    {
      slip_nodes.project(velocity);
    }

    /**
     * @brief Removes from a field of material accelerations what walls do
     * not admit: all components at walls where the fluid sticks (moving ones
     * too), the normal one at slip walls. Owned entries only.
     */
    void
    project_acceleration(Vector &acceleration) const;

    /// Sets the nodes at open boundaries to @p factor times their value in Pa.
    void
    apply_open(Vector &pressure, const double factor) const;

    /// Removes the values at open boundaries.
    void
    project_open(Vector &pressure) const;

    const FixedNodes<dim> &
    fixed() const
    {
      return fixed_nodes;
    }

    /// A node where the pressure is given.
    struct OpenNode
    {
      unsigned int               node; ///< owned
      dealii::Point<dim>         position;
      dealii::types::boundary_id id;
    };

    const std::vector<OpenNode> &
    open_nodes() const
    {
      return open;
    }

    const BoundaryConditions<dim> &
    conditions() const
    {
      return conditions_;
    }

  private:
    void
    collect_velocity(const LagrangeSpace<dim> &space);

    void
    collect_pressure(const LagrangeSpace<dim> &space);

    const BoundaryConditions<dim> &conditions_;
    FixedNodes<dim>                fixed_nodes;
    /// Those of them with some free directions.
    FixedNodes<dim> slip_nodes;
    /// Outward normals at fixed_nodes.all() of the boundary whose condition
    /// holds there: what a lid slides along does not count at its corners.
    std::vector<dealii::Tensor<1, dim>> normals;
    std::vector<OpenNode>               open;
  };

  /// Whether an owned cell's face is at a boundary where the velocity is given
  /// or zero.
  template <int dim>
  bool
  is_sticking_face(const CellGraph<dim>          &graph,
                   const BoundaryConditions<dim> &conditions,
                   const unsigned int             cell,
                   const unsigned int             face_no)
  {
    const auto &face = graph.cell(cell).faces[face_no];
    if (face.behind != CellGraph<dim>::Behind::boundary)
      return false;
    const BoundaryKind kind = conditions.at(face.boundary_id).kind;
    return kind == BoundaryKind::velocity || kind == BoundaryKind::no_slip;
  }

  /// Calls @p visit(cell, face_no) for each face of an owned cell at a
  /// boundary where the velocity is given or zero.
  template <int dim, typename Visitor>
  void
  for_each_sticking_face(const CellGraph<dim>          &graph,
                         const BoundaryConditions<dim> &conditions,
                         const Visitor                 &visit)
  {
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        if (is_sticking_face(graph, conditions, c, f))
          visit(c, f);
  }
} // namespace Thalweg

#endif
