// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_enriched_matrix_h
#define thalweg_fluid_enriched_matrix_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/linear_algebra/amg.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/solver_control.h>

#include <memory>
#include <unordered_map>
#include <vector>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SolverDirect;
    class SparseMatrix;
  } // namespace TrilinosWrappers
} // namespace dealii

namespace Thalweg
{
  /**
   * @brief A pressure sum_i N_i p_i + sum_j N_j psi q_j in Pa: the blocks p
   * and q have a value for each node, ghosted and consistent. Where no cell
   * that the interface cuts is near, q is zero.
   */
  using EnrichedPressure =
    dealii::LinearAlgebra::distributed::BlockVector<double>;

  /// p of an enriched pressure or of a load for it.
  template <typename Pressure>
  inline auto &
  nodal(Pressure &pressure)
  {
    return pressure.block(0);
  }

  /// q of an enriched pressure or of a load for it.
  template <typename Pressure>
  inline auto &
  star(Pressure &pressure)
  {
    return pressure.block(1);
  }

  /// Makes @p pressure zero at the nodes of @p space.
  template <int dim>
  void
  initialize(const NodeSpace<dim> &space, EnrichedPressure &pressure)
  {
    pressure.reinit(2);
    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      space.initialize_scalar(pressure.block(b));
    pressure.collect_sizes();
  }

  /// Adds @p increment, of which owned values count, to @p pressure and makes
  /// that ghosted and consistent.
  template <int dim>
  void
  add(const NodeSpace<dim>   &space,
      const EnrichedPressure &increment,
      EnrichedPressure       &pressure)
  {
    pressure.zero_out_ghost_values();
    pressure.add(1., increment);
    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      space.interpolate(pressure.block(b), 1);
  }

  /**
   * @brief The stiffness of a pressure with its enrichment,
   *
   *   (K   L)        K_ij = int grad N_i . grad N_j / rho,
   *   (L^T S),       L_ij = int grad N_i . grad(N_j psi) / rho,
   *                  S_ij = int grad(N_i psi) . grad(N_j psi) / rho,
   *
   * where L and S live in cut cells and are never assembled. Its inverse is
   * approximated by block factorization: the rows of the nodes of cut cells are
   * inverted exactly (those of each process by itself; they are few), and a
   * multigrid cycle for K stands for what is left of the others.
   *
   * With one factor q a cell, which could be condensed there, a pressure that
   * is steeper here than there along the interface does not fit together in the
   * lighter fluid, which forbids it: the pressure of a wave was wrong by a part
   * kh/2, with this space it is of second order.
   */
  template <int dim>
  class EnrichedMatrix
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;

    /// All must outlive the object.
    /// @param standard K
    EnrichedMatrix(const NodeSpace<dim>                         &space,
                   const BoundaryNodes<dim>                     &boundary,
                   const PhaseField<dim>                        &phase,
                   const dealii::TrilinosWrappers::SparseMatrix &standard);
    ~EnrichedMatrix();

    /// Reads the present phases. Collective.
    void
    update();

    /// Collective. At open boundaries p has neither rows nor columns.
    /// @param result owned values only
    void
    vmult(EnrichedPressure &result, const EnrichedPressure &pressure) const;

    /**
     * @brief Multiplies by an approximate inverse. Collective.
     * @param result owned values only
     * @param amg of K
     */
    void
    precondition(EnrichedPressure        &result,
                 const EnrichedPressure  &load,
                 const AmgPreconditioner &amg) const;

    /// Inverts the rows and columns of the nodes of cut cells alone.
    /// @param pressure zero at all other nodes
    void
    invert_beside_interface(EnrichedPressure       &pressure,
                            const EnrichedPressure &load) const;

    /// Lets the owned nodes where the pressure is given be zero.
    void
    remove_given(Vector &nodal) const;

  private:
    /// A node that values at a cell's vertex depend on.
    struct Master
    {
      unsigned int node;
      unsigned int vertex;
      double       weight;
    };

    /// The nodes that those of a cell depend on, with repetitions.
    void
    find_masters(const unsigned int cell, std::vector<Master> &masters) const;

    /// Calls @p visit(i, j, L_ij, S_ij) for the parts of the entries that this
    /// rank's cells make.
    template <typename Visitor>
    void
    for_each_entry(const Visitor &visit) const;

    /// Of the rows that are inverted exactly.
    struct Entry
    {
      int    row;
      int    column;
      double value;
    };

    /// Finds the owned nodes of cut cells and gives them rows.
    void
    number_rows();

    /// Collects the entries that come from K, and the links.
    void
    collect_standard_entries(std::vector<Entry> &entries);

    /// Collects the parts of the entries that come from L and S.
    void
    collect_star_entries(std::vector<Entry> &entries) const;

    /// rows = those of @p load
    void
    read_rows(const EnrichedPressure &load) const;

    /// solution = the inverse times rows
    void
    solve_rows() const;

    /// Sets the nodes' values to the solution.
    void
    write_rows(EnrichedPressure &pressure) const;

    const NodeSpace<dim>                         &space;
    const BoundaryNodes<dim>                     &boundary;
    const PhaseField<dim>                        &phase;
    const dealii::TrilinosWrappers::SparseMatrix &standard;
    /// Of each dependent node: where its dependences begin and end.
    std::unordered_map<unsigned int, std::pair<unsigned int, unsigned int>>
                              dependences;
    std::vector<bool>         is_given; ///< local nodes at open boundaries
    std::vector<unsigned int> nodes;    ///< owned, of cut cells
    /// Of each local node: the row of its q, and of its p; -1 for none
    std::vector<int> star_row, nodal_row;
    unsigned int     n_rows = 0;
    /// Entries of K in the rows of p and the columns of other owned nodes.
    std::vector<Entry>                                      links;
    dealii::SolverControl                                   control;
    std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> block;
    std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> inverse;
    /// Values of the rows that are inverted exactly.
    mutable Vector rows, solution;
    mutable Vector nodal_part;
    mutable Vector star_part;
    mutable Vector nodal_values;
    mutable Vector star_values;
  };
} // namespace Thalweg

#endif
