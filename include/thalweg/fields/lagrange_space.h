// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_lagrange_space_h
#define thalweg_fields_lagrange_space_h

#include <thalweg/fields/dependences.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <memory>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Continuous fields of any degree with one value a node (pressure)
   * or dim values a node (velocity).
   *
   * The degrees of freedom of a node's velocity stand one behind the other:
   * component c of node n is entry `dim * n + c`, in global and in local
   * numbering, so that one table of nodes serves both.
   */
  template <int dim>
  class LagrangeSpace
  {
  public:
    /**
     * @param mesh must outlive the space
     * @param degree 1 or 2
     * @param mapping of the flow's cells
     */
    LagrangeSpace(const Mesh<dim>            &mesh,
                  const unsigned int          degree,
                  const dealii::Mapping<dim> &mapping);

    ~LagrangeSpace();

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    const dealii::Mapping<dim> &
    mapping() const
    {
      return mapping_;
    }

    unsigned int
    degree() const
    {
      return fe_scalar.degree;
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

    /// (degree + 1)^dim.
    unsigned int
    n_nodes_per_cell() const
    {
      return fe_scalar.n_dofs_per_cell();
    }

    /// Local (ghosted) numbers of the nodes of a cell of the graph, in
    /// lexicographic order, x fastest.
    const unsigned int *
    nodes(const unsigned int cell) const
    {
      return &cell_nodes[cell * n_nodes_per_cell()];
    }

    /// The place in lexicographic order of each of deal.II's degrees of
    /// freedom of a cell of FE_Q.
    const std::vector<unsigned int> &
    lexicographic() const
    {
      return lexicographic_numbering;
    }

    /// Reference coordinates of the nodes, in lexicographic order.
    const std::vector<dealii::Point<dim>> &
    unit_nodes() const
    {
      return unit_support_points;
    }

    const Dependences &
    dependences() const
    {
      return node_dependences;
    }

    /// Whether the value at a local node follows from those of others.
    bool
    is_dependent(const unsigned int node) const
    {
      return node_dependences.is_dependent(node);
    }

    /// A zero vector with all locally relevant entries.
    /// @param n_components 1 or dim
    void
    initialize(Vector &vector, const unsigned int n_components) const
    {
      vector.reinit(n_components == 1 ? scalar_partitioner
                                      : velocity_partitioner);
    }

    /// See Dependences::fold().
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

    /// How scalars are distributed over the ranks.
    const dealii::Utilities::MPI::Partitioner &
    scalar_layout() const
    {
      return *scalar_partitioner;
    }

    unsigned int
    n_owned_nodes() const
    {
      return scalar_partitioner->locally_owned_size();
    }

    /// Copies a ghosted velocity cell by cell, `[(cell * n_nodes_per_cell() +
    /// node) * dim + component]`.
    void
    copy_to_cells(const Vector &velocity, std::vector<double> &cells) const;

  private:
    void
    number_cells();

    const Mesh<dim>                  &mesh_;
    const dealii::Mapping<dim>       &mapping_;
    dealii::FE_Q<dim>                 fe_scalar;
    dealii::FESystem<dim>             fe_velocity;
    dealii::DoFHandler<dim>           scalar_dofs;
    dealii::DoFHandler<dim>           velocity_dofs;
    dealii::AffineConstraints<double> scalar_continuity;
    std::vector<unsigned int>         lexicographic_numbering;
    std::vector<dealii::Point<dim>>   unit_support_points;
    std::vector<unsigned int>         cell_nodes;
    Dependences                       node_dependences;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      scalar_partitioner;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      velocity_partitioner;
  };
} // namespace Thalweg

#endif
