// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_cell_matrices_h
#define thalweg_linear_algebra_cell_matrices_h

#include <deal.II/base/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace dealii
{
  template <typename Number>
  class AffineConstraints;
  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Thalweg
{
  /**
   * @brief Adds the matrices of cells to a sparse matrix, over and over again
   * for the same cells.
   *
   * The places of the entries are looked up once for cells whose rows are all
   * on this rank and free of constraints; the others go the general way.
   * @tparam n degrees of freedom of a cell
   */
  template <unsigned int n>
  class CellMatrices
  {
  public:
    using Local   = std::array<std::array<double, n>, n>;
    using Indices = std::array<dealii::types::global_dof_index, n>;

    /**
     * @param matrix with its sparsity; it must stay where it is
     * @param constraints closed; must live as long
     * @param cells the global degrees of freedom of each cell
     */
    void
    initialize(dealii::TrilinosWrappers::SparseMatrix  &matrix,
               const dealii::AffineConstraints<double> &constraints,
               const std::vector<Indices>              &cells);

    /// Adds the matrix of a cell; compress the matrix after the last one.
    void
    add(const unsigned int cell, const Local &local);

  private:
    /// Looks the places of a cell's entries up.
    /// @return whether all are there
    bool
    find_places(const Indices &indices);

    /// A cell without places of its own.
    static constexpr unsigned int general = static_cast<unsigned int>(-1);

    dealii::TrilinosWrappers::SparseMatrix  *matrix      = nullptr;
    const dealii::AffineConstraints<double> *constraints = nullptr;

    std::vector<Indices> cells;
    /// Of each cell: where its places begin, or `general`.
    std::vector<unsigned int> place_of_cell;
    /// Of each place: the values of the n rows on this rank ...
    std::vector<std::array<double *, n>> rows;
    /// ... and where in the row the n columns stand.
    std::vector<std::array<std::uint16_t, n * n>> columns;
  };
} // namespace Thalweg

#endif
