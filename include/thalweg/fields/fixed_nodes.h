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
    /// Weighted normals of slip walls with their boundaries; one for each
    /// smooth part of a wall.
    std::vector<std::pair<dealii::types::boundary_id, dealii::Tensor<1, dim>>>
      walls;

    /**
     * @brief Adds what a face asks for.
     * @param id of the face's boundary
     * @param kind_of_face its condition
     * @param normal outward, with a weight as its length
     */
    void
    add(const dealii::types::boundary_id id,
        const BoundaryKind               kind_of_face,
        const dealii::Tensor<1, dim>    &normal);
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
