// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_fixed_nodes_h
#define thalweg_fields_fixed_nodes_h

#include <thalweg/fields/boundary_conditions.h>
#include <thalweg/fields/dependences.h>

#include <deal.II/base/tensor.h>

#include <utility>
#include <vector>

namespace Thalweg
{
  /// What the boundary faces around a node ask of its velocity.
  template <int dim>
  struct NodeDemand
  {
    dealii::Point<dim> position;
    /// The most demanding kind of condition: given velocity before no-slip,
    /// this before slip, this before open.
    BoundaryKind kind = BoundaryKind::open;
    /// The boundary of that kind.
    dealii::types::boundary_id boundary = dealii::numbers::invalid_boundary_id;

    /// A smooth part of a slip wall.
    struct Wall
    {
      dealii::types::boundary_id boundary;
      /// The sum of the faces' weighted normals.
      dealii::Tensor<1, dim> normal;
      /// The sum of the ways from the node to the faces' centres.
      dealii::Tensor<1, dim> along;
    };
    std::vector<Wall> walls;

    /**
     * @brief Adds what a face asks for.
     * @param id of the face's boundary
     * @param kind_of_face its condition
     * @param normal outward, with a weight as its length
     * @param along from the node to the face's centre
     */
    void
    add(const dealii::types::boundary_id id,
        const BoundaryKind               kind_of_face,
        const dealii::Tensor<1, dim>    &normal,
        const dealii::Tensor<1, dim>    &along);

    /**
     * @brief The normals of the slip walls, orthonormal, without those of
     * walls that meet in an edge which sticks out into the fluid.
     *
     * Fluid leaves such an edge along either wall, or anywhere in between:
     * with both normals fixed it would stick to it. That nothing passes the
     * walls beside the edge is what the pressure equation's natural boundary
     * condition says.
     */
    std::vector<dealii::Tensor<1, dim>>
    fixed_directions() const;

    /// Whether nothing is asked for: open, or only such edges.
    bool
    is_free() const;
  };

  /**
   * @brief Nodes whose velocity, or some directions of it, are given.
   */
  template <int dim>
  class FixedNodes
  {
  public:
    struct Node
    {
      unsigned int       node;
      dealii::Point<dim> position;
      BoundaryKind       kind;
      /// The boundary of that kind.
      dealii::types::boundary_id boundary;
      /// Orthonormal; empty: all directions.
      std::vector<dealii::Tensor<1, dim>> directions;
    };

    void
    add(const unsigned int node, const NodeDemand<dim> &demand);

    /// Sets the fixed components of a velocity to their values at the time
    /// of @p conditions. Owned entries only; ghosts are not updated.
    void
    apply(const BoundaryConditions<dim> &conditions, Vector &velocity) const;

    /// Removes the fixed components.
    void
    project(Vector &velocity) const;

    const std::vector<Node> &
    all() const
    {
      return nodes;
    }

  private:
    std::vector<Node> nodes;
  };
} // namespace Thalweg

#endif
