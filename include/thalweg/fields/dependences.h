// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_dependences_h
#define thalweg_fields_dependences_h

#include <thalweg/mesh/mesh.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace Thalweg
{
  /// A vector distributed over the ranks, with ghost values.
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// Hanging-node and periodicity constraints of @p dofs, consistent among
  /// the ranks. Collective.
  template <int dim>
  void
  make_continuity(const Mesh<dim>                   &mesh,
                  const dealii::DoFHandler<dim>     &dofs,
                  dealii::AffineConstraints<double> &constraints);

  /// All locally relevant nodes of the scalar @p dofs, and those that
  /// constraints reach, with @p n_components entries a node.
  template <int dim>
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
  make_partitioner(const dealii::DoFHandler<dim>           &dofs,
                   const dealii::AffineConstraints<double> &constraints,
                   const unsigned int                       n_components);

  /// A node whose value follows from that of another.
  struct Dependence
  {
    unsigned int node;
    unsigned int master;
    double       weight;
  };

  /**
   * @brief The constraints of a scalar field in local numbers, for vectors
   * with any number of components a node, which stand one behind the other.
   */
  class Dependences
  {
  public:
    /// Reads the constraints of the nodes that @p partitioner knows.
    void
    build(const dealii::AffineConstraints<double>   &constraints,
          const dealii::Utilities::MPI::Partitioner &partitioner);

    /// All local dependences: those of one node stand together.
    const std::vector<Dependence> &
    all() const
    {
      return list;
    }

    /// Whether the value at a local node follows from those of others.
    bool
    is_dependent(const unsigned int node) const
    {
      return dependent[node];
    }

    /// The number of local nodes, owned and ghost.
    unsigned int
    n_nodes() const
    {
      return dependent.size();
    }

    /**
     * @brief Moves what was added at constrained nodes to the nodes that
     * they depend on, and adds up over the ranks: the transpose of
     * interpolate().
     *
     * Before, entries (owned and ghost) hold what this rank's cells added.
     * Afterwards the ghost entries are zero.
     * @param n_components values a node
     */
    void
    fold(Vector &vector, const unsigned int n_components) const;

    /**
     * @brief As fold(), but only for nodes that are the same as another one
     * behind a periodic boundary; hanging nodes lose what they have.
     * @param operation how values of one node are joined: add, min or max
     */
    void
    join_copies(Vector                               &vector,
                const unsigned int                    n_components,
                const dealii::VectorOperation::values operation) const;

    /// Updates ghost values and sets the values at constrained nodes.
    void
    interpolate(Vector &vector, const unsigned int n_components) const;

  private:
    std::vector<Dependence> list;
    std::vector<bool>       dependent;
  };
} // namespace Thalweg

#endif
