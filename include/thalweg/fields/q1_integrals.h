// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_q1_integrals_h
#define thalweg_fields_q1_integrals_h

#include <thalweg/fields/q1_cell.h>

namespace Thalweg
{
  /**
   * @brief Integrals over a cell that fluids do not enter, exact, with tables
   * for axis-parallel cells.
   *
   * The functions are Q1 in parallelepipeds, and linear in each simplex of
   * other cells (Q1::SimplexShape), as in those that two fluids share: so both
   * kinds of cells agree on every plane.
   */
  template <int dim>
  class Q1Integrals
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;
    using Cell                               = typename CellGraph<dim>::Cell;
    template <typename T>
    using PerVertex = std::array<T, n_vertices>;
    using Velocity  = std::array<double, dim * n_vertices>;

    Q1Integrals();

    /// Adds int grad N_i . V to @p result.
    void
    add_divergence(const Cell        &cell,
                   const Velocity    &velocity,
                   PerVertex<double> &result) const;

    /// Adds @p factor int N_i div V to @p result.
    void
    add_outflow(const Cell        &cell,
                const Velocity    &velocity,
                const double       factor,
                PerVertex<double> &result) const;

    /// Adds int N_i grad p to @p result.
    void
    add_gradient(const Cell              &cell,
                 const PerVertex<double> &pressure,
                 Velocity                &result) const;

    /// int grad N_i . grad N_j
    PerVertex<PerVertex<double>>
    laplace(const Cell &cell) const;

    /// int N_i
    PerVertex<double>
    node_measures(const Cell &cell) const;

    /// int grad N_i
    PerVertex<dealii::Tensor<1, dim>>
    gradient_integrals(const Cell &cell) const;

    const Q1::Gauss<dim> &
    quadrature() const
    {
      return gauss;
    }

  private:
    Q1::Gauss<dim> gauss;
    /// [i][j][d]: int d_d N_i N_j over the reference cell
    PerVertex<PerVertex<dealii::Tensor<1, dim>>> divergence_table;
    /// [i][j][d]: int d_d N_i d_d N_j over the reference cell
    PerVertex<PerVertex<dealii::Tensor<1, dim>>> laplace_table;
  };
} // namespace Thalweg

#endif
