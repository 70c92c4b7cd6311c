// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/cell_gradients.h>
#include <thalweg/fields/q1_cell.h>

#include <cmath>

namespace Thalweg
{
  template <int dim, int n_components>
  std::array<dealii::Tensor<1, dim>, n_components>
  gradient_at_center(
    const typename CellGraph<dim>::Cell                            &cell,
    const std::array<std::array<double, n_components>, (1 << dim)> &values)
  {
    const auto point = Q1::middle<dim>(cell);
    std::array<dealii::Tensor<1, dim>, n_components> gradients;
    for (unsigned int v = 0; v < values.size(); ++v)
      for (int i = 0; i < n_components; ++i)
        gradients[i] += values[v][i] * point.gradients[v];
    return gradients;
  }



  template <int dim>
  double
  cell_size(const typename CellGraph<dim>::Cell &cell)
  {
    return std::pow(cell.measure, 1. / dim);
  }



#define THALWEG_INSTANTIATE_GRADIENT(dim, n)                                 \
  template std::array<dealii::Tensor<1, dim>, n> gradient_at_center<dim, n>( \
    const CellGraph<dim>::Cell &,                                            \
    const std::array<std::array<double, n>, (1 << dim)> &);
  THALWEG_INSTANTIATE_GRADIENT(2, 1)
  THALWEG_INSTANTIATE_GRADIENT(2, 2)
  THALWEG_INSTANTIATE_GRADIENT(3, 1)
  THALWEG_INSTANTIATE_GRADIENT(3, 3)
#undef THALWEG_INSTANTIATE_GRADIENT
  template double
  cell_size<2>(const CellGraph<2>::Cell &);
  template double
  cell_size<3>(const CellGraph<3>::Cell &);
} // namespace Thalweg
