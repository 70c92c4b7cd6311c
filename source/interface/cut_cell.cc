// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/cut_in_space.h>
#include <thalweg/materials/laminate.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Below this part of the cell's own stiffness the enrichment's is
    /// round-off: the interface touches a vertex.
    constexpr double negligible = 1e-14;



    template <int dim>
    using Vectors = std::array<dealii::Tensor<1, dim>, (1 << dim)>;



    /// Adds the integrals of the enrichment at one quadrature point, of the
    /// symmetric matrix only what is not above the diagonal, and int N_i grad
    /// |phi| to @p kink.
    template <int dim>
    void
    add_enrichment(CutCell<dim>                         &cut,
                   Vectors<dim>                         &kink,
                   const Q1::Point<dim>                 &point,
                   const std::array<double, (1 << dim)> &w,
                   const double                          absolute_phi,
                   const dealii::Tensor<1, dim>         &absolute_gradient,
                   const double                          weight,
                   const double                          density)
    {
      constexpr unsigned int n        = 1 << dim;
      double                 psi      = -absolute_phi;
      dealii::Tensor<1, dim> grad_psi = -absolute_gradient;
      for (unsigned int v = 0; v < n; ++v)
        {
          psi += w[v] * point.values[v];
          grad_psi += w[v] * point.gradients[v];
        }
      Vectors<dim> star;
      for (unsigned int j = 0; j < n; ++j)
        star[j] = point.values[j] * grad_psi + psi * point.gradients[j];
      const double inverse = weight / density;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double value = weight * point.values[i];
          for (unsigned int j = 0; j < n; ++j)
            {
              cut.laplace_star[i][j] +=
                inverse * (point.gradients[i] * star[j]);
              cut.star_divergence[i][j] += (value * psi) * point.gradients[j];
              cut.star_gradient[i][j] += value * star[j];
            }
          for (unsigned int j = 0; j <= i; ++j)
            cut.laplace_star_star[i][j] += inverse * (star[i] * star[j]);
          const double square = weight * point.values[i] * point.values[i];
          cut.star_mass[i] += square * psi * psi;
          cut.mixed_mass[i] += square * psi;
          cut.star_load[i] += weight * star[i];
          cut.star_inverse_load[i] += inverse * star[i];
          kink[i] += value * absolute_gradient;
        }
    }



    /// Adds the integrals at one quadrature point; of symmetric matrices only
    /// what is not above the diagonal.
    template <int dim>
    void
    add_point(CutCell<dim>         &cut,
              const Q1::Point<dim> &point,
              const double          weight,
              const double          density)
    {
      const double inverse = weight / density;
      for (unsigned int i = 0; i < point.values.size(); ++i)
        {
          cut.mass[i] += weight * density * point.values[i];
          cut.gradient[i] += inverse * point.gradients[i];
          for (unsigned int j = 0; j <= i; ++j)
            {
              cut.laplace[i][j] +=
                inverse * (point.gradients[i] * point.gradients[j]);
              cut.mass_matrix[i][j] +=
                weight * density * point.values[i] * point.values[j];
            }
        }
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
            add(point.values,
                point.gradients,
                gauss.weight * point.determinant);
          }
      return result;
    }



    /// Lets sum_j int N_i grad(N_j psi) be int N_i grad psi as exactly as
    /// gravity is integrated, so that both are balanced at rest.
    template <int dim>
    void
    balance_uniform_kink(CutCell<dim>                         &cut,
                         const Vectors<dim>                   &kink,
                         const typename CellGraph<dim>::Cell  &cell,
                         const std::array<double, (1 << dim)> &w)
    {
      constexpr unsigned int n          = 1 << dim;
      const Vectors<dim>     continuous = continuous_gradient<dim>(cell, w);
      for (unsigned int i = 0; i < n; ++i)
        {
          auto missing = continuous[i] - kink[i];
          for (unsigned int j = 0; j < n; ++j)
            missing -= cut.star_gradient[i][j];
          for (unsigned int j = 0; j < n; ++j)
            cut.star_gradient[i][j] += missing / n;
        }
    }



    /// Adds the integrals of a parallelepiped: the shape functions are Q1.
    template <int dim>
    void
    integrate_in_reference_cell(CutCell<dim>                         &cut,
                                Vectors<dim>                         &kink,
                                const typename CellGraph<dim>::Cell  &cell,
                                const std::array<double, (1 << dim)> &phi,
                                const std::array<double, (1 << dim)> &w,
                                const Fluids                         &fluids,
                                const bool                            enrich)
    {
      for (const auto &simplex : SimplexCut::divide<dim>(phi))
        {
          const auto reference_gradient = SimplexCut::gradient(simplex);
          SimplexCut::cut(simplex, [&](const auto &piece) {
            const bool   negative = SimplexCut::is_negative(piece);
            const double sign     = negative ? -1. : 1.;
            for (const auto &q : SimplexCut::quadrature(piece))
              {
                const auto point =
                  Q1::evaluate<dim>(cell,
                                    Q1::values<dim>(q.xi),
                                    Q1::reference_gradients<dim>(q.xi));
                const double value =
                  simplex.phi[0] +
                  reference_gradient * (q.xi - simplex.corners[0]);
                const double weight  = q.weight * point.determinant;
                const double density = fluids[negative ? 0 : 1].density;
                add_point(cut, point, weight, density);
                if (enrich)
                  add_enrichment(cut,
                                 kink,
                                 point,
                                 w,
                                 sign * value,
                                 sign * (point.covariant * reference_gradient),
                                 weight,
                                 density);
              }
          });
        }
    }



    /// The same for any other cell: the shape functions are linear in each
    /// simplex, as the level set is.
    template <int dim>
    void
    integrate_in_space(CutCell<dim>                         &cut,
                       Vectors<dim>                         &kink,
                       const typename CellGraph<dim>::Cell  &cell,
                       const std::array<double, (1 << dim)> &phi,
                       const std::array<double, (1 << dim)> &w,
                       const Fluids                         &fluids,
                       const bool                            enrich)
    {
      const Q1::SimplexShape<dim> shape(cell.vertices);
      SimplexCut::cut_in_space<dim>(
        shape, phi, [&](const auto &piece, const auto &simplex) {
          Q1::Point<dim> point;
          point.values    = shape.values(piece.simplex, piece.middle);
          point.gradients = shape.gradients(piece.simplex, simplex);
          dealii::Tensor<1, dim> gradient;
          for (unsigned int v = 0; v < phi.size(); ++v)
            gradient += phi[v] * point.gradients[v];
          const double sign    = piece.negative ? -1. : 1.;
          const double density = fluids[piece.negative ? 0 : 1].density;
          add_point(cut, point, piece.measure, density);
          if (enrich)
            add_enrichment(cut,
                           kink,
                           point,
                           w,
                           sign * piece.phi,
                           sign * gradient,
                           piece.measure,
                           density);
        });
    }



    /// Normal, fractions and mean viscosities.
    template <int dim>
    void
    set_laminate(CutCell<dim>                         &cut,
                 const typename CellGraph<dim>::Cell  &cell,
                 const std::array<double, (1 << dim)> &phi,
                 const Fluids                         &fluids)
    {
      dealii::Point<dim> center;
      for (unsigned int d = 0; d < dim; ++d)
        center[d] = .5;
      const auto point =
        Q1::evaluate<dim>(cell,
                          Q1::values<dim>(center),
                          Q1::reference_gradients<dim>(center));
      for (unsigned int v = 0; v < phi.size(); ++v)
        cut.normal += phi[v] * point.gradients[v];
      if (cut.normal.norm() > 0)
        cut.normal /= cut.normal.norm();

      cut.negative_fraction = negative_volume<dim>(cell, phi) / cell.measure;
      cut.arithmetic_viscosity =
        arithmetic_mean(cut.negative_fraction,
                        {{fluids[0].viscosity, fluids[1].viscosity}});
      cut.harmonic_viscosity =
        harmonic_mean(cut.negative_fraction,
                      {{fluids[0].viscosity, fluids[1].viscosity}});
    }
  } // namespace



  template <int dim>
  CutCell<dim>
  integrate_cut_cell(const unsigned int                    index,
                     const typename CellGraph<dim>::Cell  &cell,
                     const std::array<double, (1 << dim)> &phi_in,
                     const std::array<double, (1 << dim)> &w_in,
                     const double                          length,
                     const Fluids                         &fluids,
                     const bool                            enrich)
  {
    constexpr unsigned int n = 1 << dim;
    CutCell<dim>           cut{};
    cut.cell = index;
    auto phi = phi_in, w = w_in;
    for (unsigned int v = 0; v < n; ++v)
      {
        phi[v] /= length;
        w[v] /= length;
      }
    set_laminate(cut, cell, phi, fluids);

    Vectors<dim> kink;
    if (Q1::is_parallelepiped<dim>(cell))
      integrate_in_reference_cell(cut, kink, cell, phi, w, fluids, enrich);
    else
      integrate_in_space(cut, kink, cell, phi, w, fluids, enrich);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          cut.laplace[j][i]           = cut.laplace[i][j];
          cut.mass_matrix[j][i]       = cut.mass_matrix[i][j];
          cut.laplace_star_star[j][i] = cut.laplace_star_star[i][j];
        }
    if (enrich)
      {
        balance_uniform_kink(cut, kink, cell, w);
        double trace = 0, star_trace = 0;
        for (unsigned int i = 0; i < n; ++i)
          {
            trace += cut.laplace[i][i];
            star_trace += cut.laplace_star_star[i][i];
          }
        cut.enriched = star_trace > negligible * trace;
      }
    return cut;
  }



  template <int dim>
  double
  negative_volume(const typename CellGraph<dim>::Cell  &cell,
                  const std::array<double, (1 << dim)> &phi)
  {
    if (cell.axis_parallel)
      return cell.measure * SimplexCut::negative_fraction<dim>(phi);
    const auto [smallest, largest] =
      std::minmax_element(phi.begin(), phi.end());
    if (*smallest >= 0)
      return 0.;
    if (*largest <= 0)
      return cell.measure;
    double volume = 0;
    SimplexCut::cut_in_space<dim>(Q1::SimplexShape<dim>(cell.vertices),
                                  phi,
                                  [&volume](const auto &piece, const auto &) {
                                    if (piece.negative)
                                      volume += piece.measure;
                                  });
    return volume;
  }



  template CutCell<2>
  integrate_cut_cell<2>(const unsigned int,
                        const CellGraph<2>::Cell &,
                        const std::array<double, 4> &,
                        const std::array<double, 4> &,
                        const double,
                        const Fluids &,
                        const bool);
  template CutCell<3>
  integrate_cut_cell<3>(const unsigned int,
                        const CellGraph<3>::Cell &,
                        const std::array<double, 8> &,
                        const std::array<double, 8> &,
                        const double,
                        const Fluids &,
                        const bool);
  template double
  negative_volume<2>(const CellGraph<2>::Cell &, const std::array<double, 4> &);
  template double
  negative_volume<3>(const CellGraph<3>::Cell &, const std::array<double, 8> &);
} // namespace Thalweg
