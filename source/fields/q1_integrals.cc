// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/fields/q1_simplices.h>

namespace Thalweg
{
  namespace
  {
    /// Calls @p visit(values, gradients, weight) for the quadrature points of
    /// a cell: Gauss points, or the middles of the simplices that a cell
    /// which is no parallelepiped is divided into.
    template <int dim, typename Visitor>
    void
    for_each_point(const Q1::Gauss<dim>                &gauss,
                   const typename CellGraph<dim>::Cell &cell,
                   const Visitor                       &visit)
    {
      if (!Q1::is_parallelepiped<dim>(cell))
        Q1::SimplexShape<dim>(cell.vertices).for_each(visit);
      else
        for (unsigned int q = 0; q < gauss.n_points; ++q)
          {
            const auto point = gauss.evaluate(cell, q);
            visit(point.values,
                  point.gradients,
                  gauss.weight * point.determinant);
          }
    }
  } // namespace



  template <int dim>
  Q1Integrals<dim>::Q1Integrals()
    : divergence_table{}
    , laplace_table{}
  {
    for (unsigned int q = 0; q < gauss.n_points; ++q)
      for (unsigned int i = 0; i < n_vertices; ++i)
        for (unsigned int j = 0; j < n_vertices; ++j)
          for (unsigned int d = 0; d < dim; ++d)
            {
              divergence_table[i][j][d] +=
                gauss.weight * gauss.gradients[q][i][d] * gauss.values[q][j];
              laplace_table[i][j][d] += gauss.weight *
                                        gauss.gradients[q][i][d] *
                                        gauss.gradients[q][j][d];
            }
  }



  template <int dim>
  void
  Q1Integrals<dim>::add_divergence(const Cell        &cell,
                                   const Velocity    &velocity,
                                   PerVertex<double> &result) const
  {
    if (cell.axis_parallel)
      {
        const dealii::Tensor<1, dim> scale = cell.measure * cell.inverse_extent;
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              result[i] +=
                scale[d] * divergence_table[i][j][d] * velocity[dim * j + d];
        return;
      }
    for_each_point<dim>(gauss,
                        cell,
                        [&](const auto  &values,
                            const auto  &gradients,
                            const double weight) {
                          dealii::Tensor<1, dim> value;
                          for (unsigned int j = 0; j < n_vertices; ++j)
                            for (unsigned int d = 0; d < dim; ++d)
                              value[d] += values[j] * velocity[dim * j + d];
                          value *= weight;
                          for (unsigned int i = 0; i < n_vertices; ++i)
                            result[i] += gradients[i] * value;
                        });
  }



  template <int dim>
  void
  Q1Integrals<dim>::add_outflow(const Cell        &cell,
                                const Velocity    &velocity,
                                const double       factor,
                                PerVertex<double> &result) const
  {
    if (cell.axis_parallel)
      {
        const dealii::Tensor<1, dim> scale =
          (factor * cell.measure) * cell.inverse_extent;
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              result[i] +=
                scale[d] * divergence_table[j][i][d] * velocity[dim * j + d];
        return;
      }
    for_each_point<dim>(
      gauss,
      cell,
      [&](const auto &values, const auto &gradients, const double weight) {
        double divergence = 0.;
        for (unsigned int j = 0; j < n_vertices; ++j)
          for (unsigned int d = 0; d < dim; ++d)
            divergence += gradients[j][d] * velocity[dim * j + d];
        divergence *= factor * weight;
        for (unsigned int i = 0; i < n_vertices; ++i)
          result[i] += values[i] * divergence;
      });
  }



  template <int dim>
  void
  Q1Integrals<dim>::add_gradient(const Cell              &cell,
                                 const PerVertex<double> &pressure,
                                 Velocity                &result) const
  {
    if (cell.axis_parallel)
      {
        const dealii::Tensor<1, dim> scale = cell.measure * cell.inverse_extent;
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              result[dim * i + d] +=
                scale[d] * divergence_table[j][i][d] * pressure[j];
        return;
      }
    for_each_point<dim>(gauss,
                        cell,
                        [&](const auto  &values,
                            const auto  &gradients,
                            const double weight) {
                          dealii::Tensor<1, dim> gradient;
                          for (unsigned int j = 0; j < n_vertices; ++j)
                            gradient += pressure[j] * gradients[j];
                          gradient *= weight;
                          for (unsigned int i = 0; i < n_vertices; ++i)
                            for (unsigned int d = 0; d < dim; ++d)
                              result[dim * i + d] += values[i] * gradient[d];
                        });
  }



  template <int dim>
  typename Q1Integrals<dim>::template PerVertex<
    typename Q1Integrals<dim>::template PerVertex<double>>
  Q1Integrals<dim>::laplace(const Cell &cell) const
  {
    PerVertex<PerVertex<double>> matrix{};
    if (cell.axis_parallel)
      {
        dealii::Tensor<1, dim> scale;
        for (unsigned int d = 0; d < dim; ++d)
          scale[d] =
            cell.measure * cell.inverse_extent[d] * cell.inverse_extent[d];
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            matrix[i][j] = scale * laplace_table[i][j];
        return matrix;
      }
    for_each_point<dim>(
      gauss,
      cell,
      [&](const auto &, const auto &gradients, const double weight) {
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            matrix[i][j] += weight * (gradients[i] * gradients[j]);
      });
    return matrix;
  }



  template <int dim>
  typename Q1Integrals<dim>::template PerVertex<double>
  Q1Integrals<dim>::node_measures(const Cell &cell) const
  {
    PerVertex<double> result{};
    if (cell.axis_parallel)
      {
        result.fill(cell.measure / n_vertices);
        return result;
      }
    for_each_point<dim>(
      gauss, cell, [&](const auto &values, const auto &, const double weight) {
        for (unsigned int i = 0; i < n_vertices; ++i)
          result[i] += weight * values[i];
      });
    return result;
  }



  template <int dim>
  typename Q1Integrals<dim>::template PerVertex<dealii::Tensor<1, dim>>
  Q1Integrals<dim>::gradient_integrals(const Cell &cell) const
  {
    PerVertex<dealii::Tensor<1, dim>> result{};
    for_each_point<dim>(gauss,
                        cell,
                        [&](const auto &,
                            const auto  &gradients,
                            const double weight) {
                          for (unsigned int i = 0; i < n_vertices; ++i)
                            result[i] += weight * gradients[i];
                        });
    return result;
  }



  THALWEG_INSTANTIATE(Q1Integrals)
} // namespace Thalweg
