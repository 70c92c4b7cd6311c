// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_convective_term_h
#define thalweg_fluid_convective_term_h

#include <thalweg/fluid/flow_operators.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief The integrals int N_i V . grad V, by which the pressure of a
   * velocity field is found.
   */
  template <int dim>
  class ConvectiveTerm
  {
  public:
    explicit ConvectiveTerm(const FlowOperators<dim> &operators);

    /// result_i += factor int N_i V . grad V; not folded.
    /// @param velocity ghosted
    void
    add(const Vector &velocity, Vector &result, const double factor) const;

  private:
    /// A quadrature point of a cell in space.
    struct Point
    {
      dealii::Tensor<2, dim> inverse_jacobian; ///< d xi / d x
      double                 JxW;
    };

    /// A shape function at a quadrature point of the reference cell.
    struct Shape
    {
      double                 value;
      dealii::Tensor<1, dim> gradient;
    };

    const FlowOperators<dim> &operators;
    unsigned int              n_points;
    std::vector<Point>        points; ///< [shape][q]
    std::vector<Shape>        shapes; ///< [q][node]
  };
} // namespace Thalweg

#endif
