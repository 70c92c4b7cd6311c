// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_node_space_h
#define thalweg_fields_node_space_h

#include <thalweg/fields/lagrange_space.h>
#include <thalweg/mesh/cell_field.h>

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Q1 fields on the straight cells that particles see: their nodes
   * are the vertices.
   */
  template <int dim>
  class NodeSpace : public LagrangeSpace<dim>
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;

    explicit NodeSpace(const Mesh<dim> &mesh);

    ~NodeSpace();

    /// Local (ghosted) numbers of the nodes of a cell of the graph, in
    /// deal.II's order of vertices.
    const std::array<unsigned int, n_vertices> &
    nodes(const unsigned int cell) const
    {
      return vertex_nodes[cell];
    }

    /// A zero vector with all locally relevant entries.
    void
    initialize_scalar(Vector &vector) const
    {
      this->initialize(vector, 1);
    }

    /// A zero vector with all locally relevant entries.
    void
    initialize_velocity(Vector &vector) const
    {
      this->initialize(vector, dim);
    }

    /**
     * @brief The part of dependences().all() that belongs to a hanging node.
     * @return first and one past the last index; empty for other nodes,
     *   which includes those that a periodic boundary joins to one other
     */
    std::pair<unsigned int, unsigned int>
    hanging_masters(const unsigned int node) const
    {
      const auto entry = hanging.find(node);
      return entry == hanging.end() ? std::make_pair(0u, 0u) : entry->second;
    }

    /// The position of a node that this rank knows; behind a periodic boundary
    /// it may be that of an image.
    const dealii::Point<dim> &
    position(const unsigned int node) const
    {
      return node_positions[node];
    }

    using LagrangeSpace<dim>::copy_to_cells;

    /// Copies a ghosted, constraint-consistent velocity cell by cell.
    void
    copy_to_cells(const Vector &velocity, CellVelocity<dim> &cells) const;

    /// Copies a ghosted, constraint-consistent scalar cell by cell.
    void
    copy_to_cells(const Vector &scalar, CellField<dim, 1> &cells) const;

    dealii::types::global_dof_index
    n_dofs() const
    {
      return this->scalar().n_dofs() + this->velocity().n_dofs();
    }

  private:
    /// Takes the positions of nodes that only constraints reach from their
    /// owners. Collective.
    void
    ask_for_positions();

    std::vector<std::array<unsigned int, n_vertices>> vertex_nodes;
    std::vector<dealii::Point<dim>>                   node_positions;
    std::unordered_map<unsigned int, std::pair<unsigned int, unsigned int>>
      hanging;
  };
} // namespace Thalweg

#endif
