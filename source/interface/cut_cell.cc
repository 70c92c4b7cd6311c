// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/cut_in_space.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Below this part of the cell's own stiffness the enrichment's is
    /// round-off: the interface touches a vertex.
    constexpr double negligible = 1e-14;



    /// Adds the integrals at one quadrature point; of the symmetric matrix
    /// only what is not above the diagonal.
    template <int dim>
    void
    add_point(CutCell<dim>                         &cut,
              const Q1::Point<dim>                 &point,
              const std::array<double, (1 << dim)> &w,
              const double                          absolute_phi,
              const dealii::Tensor<1, dim>         &absolute_gradient,
              const double                          weight,
              const double                          density,
              const bool                            enrich)
    {
      const double           inverse  = weight / density;
      double                 psi      = -absolute_phi;
      dealii::Tensor<1, dim> grad_psi = -absolute_gradient;
      if (enrich)
        for (unsigned int v = 0; v < w.size(); ++v)
          {
            psi += w[v] * point.values[v];
            grad_psi += w[v] * point.gradients[v];
          }
      for (unsigned int i = 0; i < w.size(); ++i)
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
          if (enrich)
            {
              cut.laplace_star[i] += inverse * (point.gradients[i] * grad_psi);
              cut.star_divergence[i] += (weight * psi) * point.gradients[i];
              // the continuous part of grad psi is added exactly later
              cut.star_gradient[i] -=
                (weight * point.values[i]) * absolute_gradient;
            }
        }
      if (enrich)
        {
          cut.laplace_star_star += inverse * (grad_psi * grad_psi);
          cut.star_load += weight * grad_psi;
          cut.star_inverse_load += inverse * grad_psi;
        }
    }



    /// Adds int N_i grad(sum_v N_v w_v) with a rule that is exact for it, as
    /// the pressure gradient of the standard functions is integrated.
    template <int dim>
    void
    add_continuous_gradient(CutCell<dim>                         &cut,
                            const typename CellGraph<dim>::Cell  &cell,
                            const std::array<double, (1 << dim)> &w)
    {
      static const Q1::Gauss<dim> gauss;
      if (!Q1::is_parallelepiped<dim>(cell))
        {
          Q1::SimplexShape<dim>(cell.vertices)
            .for_each([&](const auto  &values,
                          const auto  &gradients,
                          const double measure) {
              dealii::Tensor<1, dim> gradient;
              for (unsigned int v = 0; v < w.size(); ++v)
                gradient += w[v] * gradients[v];
              for (unsigned int i = 0; i < w.size(); ++i)
                cut.star_gradient[i] += (measure * values[i]) * gradient;
            });
          return;
        }
      for (unsigned int q = 0; q < gauss.n_points; ++q)
        {
          const auto             point  = gauss.evaluate(cell, q);
          const double           weight = gauss.weight * point.determinant;
          dealii::Tensor<1, dim> gradient;
          for (unsigned int v = 0; v < w.size(); ++v)
            gradient += w[v] * point.gradients[v];
          for (unsigned int i = 0; i < w.size(); ++i)
            cut.star_gradient[i] += (weight * point.values[i]) * gradient;
        }
    }



    /// Adds the integrals of a parallelepiped: the shape functions are Q1.
    template <int dim>
    void
    integrate_in_reference_cell(CutCell<dim>                         &cut,
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
                add_point(cut,
                          point,
                          w,
                          sign * value,
                          sign * (point.covariant * reference_gradient),
                          q.weight * point.determinant,
                          fluids[negative ? 0 : 1].density,
                          enrich);
              }
          });
        }
    }



    /// The same for any other cell: the shape functions are linear in each
    /// simplex, as the level set is.
    template <int dim>
    void
    integrate_in_space(CutCell<dim>                         &cut,
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
          const double sign = piece.negative ? -1. : 1.;
          add_point(cut,
                    point,
                    w,
                    sign * piece.phi,
                    sign * gradient,
                    piece.measure,
                    fluids[piece.negative ? 0 : 1].density,
                    enrich);
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

      cut.negative_fraction    = negative_volume<dim>(cell, phi) / cell.measure;
      const double f           = cut.negative_fraction;
      const double mu[2]       = {fluids[0].viscosity, fluids[1].viscosity};
      cut.arithmetic_viscosity = f * mu[0] + (1 - f) * mu[1];
      cut.harmonic_viscosity =
        mu[0] * mu[1] > 0 ? mu[0] * mu[1] / (f * mu[1] + (1 - f) * mu[0]) : 0.;
    }
  } // namespace



  template <int dim>
  CutCell<dim>
  integrate_cut_cell(const unsigned int                    index,
                     const typename CellGraph<dim>::Cell  &cell,
                     const std::array<double, (1 << dim)> &phi_in,
                     const std::array<double, (1 << dim)> &w_in,
                     const Fluids                         &fluids,
                     const bool                            enrich)
  {
    CutCell<dim> cut{};
    cut.cell   = index;
    auto   phi = phi_in, w = w_in;
    double scale = 0;
    for (const double value : w)
      scale = std::max(scale, std::abs(value));
    for (unsigned int v = 0; v < phi.size(); ++v)
      {
        phi[v] /= scale;
        w[v] /= scale;
      }
    set_laminate(cut, cell, phi, fluids);

    if (Q1::is_parallelepiped<dim>(cell))
      integrate_in_reference_cell(cut, cell, phi, w, fluids, enrich);
    else
      integrate_in_space(cut, cell, phi, w, fluids, enrich);
    for (unsigned int i = 0; i < phi.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          cut.laplace[j][i]     = cut.laplace[i][j];
          cut.mass_matrix[j][i] = cut.mass_matrix[i][j];
        }
    if (enrich)
      {
        add_continuous_gradient(cut, cell, w);
        double trace = 0;
        for (unsigned int i = 0; i < phi.size(); ++i)
          trace += cut.laplace[i][i];
        cut.enriched = cut.laplace_star_star > negligible * trace;
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
                        const Fluids &,
                        const bool);
  template CutCell<3>
  integrate_cut_cell<3>(const unsigned int,
                        const CellGraph<3>::Cell &,
                        const std::array<double, 8> &,
                        const std::array<double, 8> &,
                        const Fluids &,
                        const bool);
  template double
  negative_volume<2>(const CellGraph<2>::Cell &, const std::array<double, 4> &);
  template double
  negative_volume<3>(const CellGraph<3>::Cell &, const std::array<double, 8> &);
} // namespace Thalweg
