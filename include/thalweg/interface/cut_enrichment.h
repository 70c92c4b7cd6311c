// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_cut_enrichment_h
#define thalweg_interface_cut_enrichment_h

#include <thalweg/fields/q1_cell.h>
#include <thalweg/fields/q1_simplices.h>
#include <thalweg/interface/cut_cell.h>

namespace Thalweg
{
  /// A vector at each vertex of a cell.
  template <int dim>
  using Vectors = std::array<dealii::Tensor<1, dim>, (1 << dim)>;

  /// The enrichment's functions at a quadrature point: N_j times a factor.
  template <int dim>
  struct Star
  {
    std::array<double, (1 << dim)> factors;
    Vectors<dim>                   gradients;
  };

  /// N_j psi, from |phi| and its gradient.
  template <int dim>
  Star<dim>
  kink_functions(const Q1::Point<dim>                 &point,
                 const std::array<double, (1 << dim)> &w,
                 const double                          absolute_phi,
                 const dealii::Tensor<1, dim>         &absolute_gradient)
  {
    double                 psi      = -absolute_phi;
    dealii::Tensor<1, dim> grad_psi = -absolute_gradient;
    for (unsigned int v = 0; v < w.size(); ++v)
      {
        psi += w[v] * point.values[v];
        grad_psi += w[v] * point.gradients[v];
      }
    Star<dim> star;
    for (unsigned int j = 0; j < w.size(); ++j)
      {
        star.factors[j] = psi;
        star.gradients[j] =
          point.values[j] * grad_psi + psi * point.gradients[j];
      }
    return star;
  }

  /// N_j (H - H_j) where fluid 1 is, or not.
  template <int dim>
  Star<dim>
  jump_functions(const Q1::Point<dim>                 &point,
                 const std::array<double, (1 << dim)> &phi,
                 const bool                            negative)
  {
    Star<dim> star;
    for (unsigned int j = 0; j < phi.size(); ++j)
      {
        const double factor = (negative ? 0. : 1.) - (phi[j] < 0 ? 0. : 1.);
        star.factors[j]     = factor;
        star.gradients[j]   = factor * point.gradients[j];
      }
    return star;
  }

  /// Adds the integrals of the enrichment at one quadrature point, of the
  /// symmetric matrix only what is not above the diagonal.
  template <int dim>
  void
  add_enrichment(CutCell<dim>         &cut,
                 const Q1::Point<dim> &point,
                 const Star<dim>      &star,
                 const double          weight,
                 const double          density)
  {
    constexpr unsigned int n       = 1 << dim;
    const double           inverse = weight / density;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double value = weight * point.values[i];
        for (unsigned int j = 0; j < n; ++j)
          {
            cut.laplace_star[i][j] +=
              inverse * (point.gradients[i] * star.gradients[j]);
            cut.star_divergence[i][j] +=
              (value * star.factors[i]) * point.gradients[j];
            cut.star_gradient[i][j] += value * star.gradients[j];
          }
        for (unsigned int j = 0; j <= i; ++j)
          cut.laplace_star_star[i][j] +=
            inverse * (star.gradients[i] * star.gradients[j]);
        const double square = value * point.values[i] * star.factors[i];
        cut.star_mass[i] += square * star.factors[i];
        cut.mixed_mass[i] += square;
        cut.star_load[i] += weight * star.gradients[i];
        cut.star_inverse_load[i] += inverse * star.gradients[i];
      }
  }

  /// Adds N_i N_j n at a point of the interface.
  template <int dim>
  void
  add_jump(CutCell<dim>                         &cut,
           const std::array<double, (1 << dim)> &values,
           const dealii::Tensor<1, dim>         &vector)
  {
    constexpr unsigned int n = 1 << dim;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        cut.star_jump[n * i + j] += (values[i] * values[j]) * vector;
  }


  /// Adds what is needed of a piece with jumps besides.
  template <int dim>
  void
  add_second_gradients(CutCell<dim>         &cut,
                       const Q1::Point<dim> &point,
                       const double          weight)
  {
    constexpr unsigned int n = 1 << dim;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        cut.second_gradients[n * i + j] +=
          outer_product(weight * point.gradients[i], point.gradients[j]);
  }

  /// int N_i grad(sum_v N_v w_v) with a rule that is exact for it, as the
  /// pressure gradient of the standard functions is integrated.
  template <int dim>
  Vectors<dim>
  continuous_gradient(const typename CellGraph<dim>::Cell  &cell,
                      const std::array<double, (1 << dim)> &w)
  {
    static const Q1::Gauss<dim> gauss;
    Vectors<dim>                result;
    const auto                  add =
      [&](const auto &values, const auto &gradients, const double weight) {
        dealii::Tensor<1, dim> gradient;
        for (unsigned int v = 0; v < w.size(); ++v)
          gradient += w[v] * gradients[v];
        for (unsigned int i = 0; i < w.size(); ++i)
          result[i] += (weight * values[i]) * gradient;
      };
    if (!Q1::is_parallelepiped<dim>(cell))
      Q1::SimplexShape<dim>(cell.vertices).for_each(add);
    else
      for (unsigned int q = 0; q < gauss.n_points; ++q)
        {
          const auto point = gauss.evaluate(cell, q);
          add(point.values, point.gradients, gauss.weight * point.determinant);
        }
    return result;
  }
} // namespace Thalweg

#endif
