#ifndef thalweg_fields_node_space_h
#define thalweg_fields_node_space_h

#include <thalweg/fields/dependences.h>
#include <thalweg/mesh/cell_field.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Q1 fields with one value a node (pressure, level set) or dim
   * values a node (velocity) on the same nodes.
   *
   * The degrees of freedom of a node's velocity stand one behind the other:
   * component c of node n is entry `dim * n + c`, in global and in local
   * numbering, so that one table of nodes serves both.
   */
  template <int dim>
  class NodeSpace
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;

    explicit NodeSpace(const Mesh<dim> &mesh);

    /// Distributes anew; call it after every change of the mesh.
    void
    distribute();

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    const dealii::DoFHandler<dim> &
    scalar() const
    {
      return scalar_dofs;
    }

    const dealii::DoFHandler<dim> &
    velocity() const
    {
      return velocity_dofs;
    }

    /// Hanging nodes and periodic boundaries of a scalar field.
    const dealii::AffineConstraints<double> &
    scalar_constraints() const
    {
      return scalar_continuity;
    }

    /// Local (ghosted) numbers of the nodes of a cell of the graph, in
    /// deal.II's order of vertices.
    const std::array<unsigned int, n_vertices> &
    nodes(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    /// How scalars are distributed over the ranks.
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    scalar_layout() const
    {
      return scalar_partitioner;
    }

    /// A zero vector with all locally relevant entries.
    void
    initialize_scalar(Vector &vector) const;

    /// A zero vector with all locally relevant entries.
    void
    initialize_velocity(Vector &vector) const;

    /// See Dependences::fold().
    /// @param n_components values a node: 1 or dim
    void
    fold(Vector &vector, const unsigned int n_components) const
    {
      node_dependences.fold(vector, n_components);
    }

    /// Updates ghost values and sets the values at constrained nodes.
    void
    interpolate(Vector &vector, const unsigned int n_components) const
    {
      node_dependences.interpolate(vector, n_components);
    }

    /// All local dependences: those of one node stand together.
    const std::vector<Dependence> &
    dependences() const
    {
      return node_dependences.all();
    }

    /// Whether the value at a local node follows from those of others.
    bool
    is_dependent(const unsigned int node) const
    {
      return node_dependences.is_dependent(node);
    }

    /**
     * @brief The part of dependences() that belongs to a hanging node.
     * @return first and one past the last index; empty for other nodes,
     *   which includes those that a periodic boundary joins to one other
     */
    std::pair<unsigned int, unsigned int>
    hanging_masters(const unsigned int node) const
    {
      const auto entry = hanging.find(node);
      return entry == hanging.end() ? std::make_pair(0u, 0u) : entry->second;
    }

    /// The position of a node of a local cell; not a number for those that
    /// only constraints reach.
    const dealii::Point<dim> &
    position(const unsigned int node) const
    {
      return node_positions[node];
    }

    /// Copies a ghosted, constraint-consistent velocity cell by cell.
    void
    copy_to_cells(const Vector &velocity, CellVelocity<dim> &cells) const;

    /// Copies a ghosted, constraint-consistent scalar cell by cell.
    void
    copy_to_cells(const Vector &scalar, CellField<dim, 1> &cells) const;

    dealii::types::global_dof_index
    n_dofs() const
    {
      return scalar_dofs.n_dofs() + velocity_dofs.n_dofs();
    }

  private:
    const Mesh<dim>                                  &mesh_;
    dealii::FE_Q<dim>                                 fe_scalar;
    dealii::FESystem<dim>                             fe_velocity;
    dealii::DoFHandler<dim>                           scalar_dofs;
    dealii::DoFHandler<dim>                           velocity_dofs;
    dealii::AffineConstraints<double>                 scalar_continuity;
    std::vector<std::array<unsigned int, n_vertices>> cell_nodes;
    Dependences                                       node_dependences;
    std::vector<dealii::Point<dim>>                   node_positions;
    std::unordered_map<unsigned int, std::pair<unsigned int, unsigned int>>
      hanging;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      scalar_partitioner;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      velocity_partitioner;
  };
} // namespace Thalweg

#endif
