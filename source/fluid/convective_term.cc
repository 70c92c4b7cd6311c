// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fluid/convective_term.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Thalweg
{
  template <int dim>
  ConvectiveTerm<dim>::ConvectiveTerm(const FlowOperators<dim> &operators)
    : operators(operators)
  {
    using namespace dealii;
    const auto        &V = operators.velocity_space;
    const unsigned int n = V.n_nodes_per_cell();
    const QGauss<dim>  gauss(V.degree() + 1);
    n_points = gauss.size();
    shapes.resize(n_points * n);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int i = 0; i < n; ++i)
        shapes[q * n + V.lexicographic()[i]] = {
          V.scalar().get_fe().shape_value(i, gauss.point(q)),
          V.scalar().get_fe().shape_grad(i, gauss.point(q))};

    FEValues<dim>     values(V.mapping(),
                         V.scalar().get_fe(),
                         gauss,
                         update_inverse_jacobians | update_JxW_values);
    std::vector<bool> done(operators.mass.n_shapes(), false);
    points.resize(done.size() * n_points);
    for (unsigned int c = 0; c < V.mesh().graph().n_owned_cells(); ++c)
      {
        const unsigned int shape = operators.mass.shape(c);
        if (done[shape])
          continue;
        done[shape] = true;
        values.reinit(
          Compat::on_dof_handler(V.mesh().graph().iterator(c), V.scalar()));
        for (unsigned int q = 0; q < n_points; ++q)
          points[shape * n_points + q] = {
            Tensor<2, dim>(values.inverse_jacobian(q)), values.JxW(q)};
      }
  }



  template <int dim>
  void
  ConvectiveTerm<dim>::add(const Vector &velocity,
                           Vector       &result,
                           const double  factor) const
  {
    const auto        &V = operators.velocity_space;
    const unsigned int n = V.n_nodes_per_cell();
    for (unsigned int c = 0; c < V.mesh().graph().n_owned_cells(); ++c)
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Point &point = points[operators.mass.shape(c) * n_points + q];
          dealii::Tensor<1, dim> u;
          dealii::Tensor<2, dim> reference_gradient;
          for (unsigned int i = 0; i < n; ++i)
            {
              const Shape &shape = shapes[q * n + i];
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double nodal =
                    velocity.local_element(dim * V.nodes(c)[i] + d);
                  u[d] += nodal * shape.value;
                  reference_gradient[d] += nodal * shape.gradient;
                }
            }
          // V . grad V = (du/dxi) (dxi/dx) V
          const dealii::Tensor<1, dim> load =
            (factor * point.JxW) *
            (reference_gradient * (point.inverse_jacobian * u));
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int d = 0; d < dim; ++d)
              result.local_element(dim * V.nodes(c)[i] + d) +=
                shapes[q * n + i].value * load[d];
        }
  }



  THALWEG_INSTANTIATE(ConvectiveTerm)
} // namespace Thalweg
