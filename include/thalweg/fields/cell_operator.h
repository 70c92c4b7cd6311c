// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_cell_operator_h
#define thalweg_fields_cell_operator_h

#include <thalweg/fields/lagrange_space.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief A square matrix given by those of the cells, which acts on each
   * component of a field alike.
   *
   * Cells of the same shape share theirs. For the degrees 1 and 2 this costs
   * no more memory traffic than a sparse matrix, serves all components at
   * once, and needs no assembly where the cells' matrices change every step.
   */
  template <int dim>
  class CellOperator
  {
  public:
    CellOperator() = default;

    explicit CellOperator(const LagrangeSpace<dim> &space);

    /// The number of nodes of a cell.
    unsigned int
    size() const
    {
      return n;
    }

    /// Makes room for @p n_shapes matrices of zeros, and all owned cells
    /// have the first one.
    void
    reinit(const unsigned int n_shapes);

    /// Says which of the matrices a cell has.
    void
    set_shape(const unsigned int cell, const unsigned int shape)
    {
      shape_of_cell[cell] = shape;
    }

    unsigned int
    shape(const unsigned int cell) const
    {
      return shape_of_cell[cell];
    }

    unsigned int
    n_shapes() const
    {
      return entries.size() / (n * n);
    }

    /// The matrix number @p shape, row by row, lexicographic.
    double *
    matrix(const unsigned int shape)
    {
      return &entries[shape * n * n];
    }

    const double *
    matrix(const unsigned int shape) const
    {
      return &entries[shape * n * n];
    }

    /// This = a A + b B, of operators with the same shapes.
    void
    combine(const double             a,
            const CellOperator<dim> &A,
            const double             b,
            const CellOperator<dim> &B);

    /**
     * @brief destination += factor A source; not folded.
     * @param source ghosted and consistent
     * @param n_components 1 or dim
     * @param cell_factors a factor a cell besides, or nullptr
     */
    void
    add_product(const Vector       &source,
                Vector             &destination,
                const unsigned int  n_components,
                const double        factor,
                const double *const cell_factors = nullptr) const;

    /// destination += the diagonal, at all components; not folded.
    void
    add_diagonal(Vector             &destination,
                 const unsigned int  n_components,
                 const double *const cell_factors = nullptr) const;

    const LagrangeSpace<dim> &
    space() const
    {
      return *space_;
    }

  private:
    const LagrangeSpace<dim> *space_ = nullptr;
    unsigned int              n      = 0;
    std::vector<double>       entries;
    std::vector<unsigned int> shape_of_cell;
  };
} // namespace Thalweg

#endif
