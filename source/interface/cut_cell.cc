// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/cut_enrichment.h>
#include <thalweg/interface/cut_in_space.h>
#include <thalweg/interface/interface_quadrature.h>
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



    /// A side with less than this part of a cell has no pressure of its own
    /// there, but that of the nodes, which is wrong beside a jump.
    constexpr double least_side = 1e-3;



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



    /// What is needed besides while a cell is integrated.
    template <int dim>
    struct Sums
    {
      Vectors<dim> kink; ///< int N_i grad |phi|
      /// [i][j]: int N_i grad N_j by the rule for pieces
      std::array<Vectors<dim>, (1 << dim)> gradient;
    };



    /// What a cut cell is integrated from.
    template <int dim>
    struct Task
    {
      const typename CellGraph<dim>::Cell &cell;
      std::array<double, (1 << dim)>       phi;
      std::array<double, (1 << dim)>       w;
      const Fluids                        &fluids;
      PressureEnrichment                   enrichment;
    };



    /// Adds the integrals of everything at one point.
    /// @param phi, gradient of the level set there
    template <int dim>
    void
    add_all(CutCell<dim>                 &cut,
            Sums<dim>                    &sums,
            const Task<dim>              &task,
            const Q1::Point<dim>         &point,
            const double                  weight,
            const bool                    negative,
            const double                  phi,
            const dealii::Tensor<1, dim> &gradient)
    {
      const unsigned int fluid     = negative ? 0 : 1;
      const double       density   = task.fluids[fluid].density;
      const bool         is_denser = fluid == task.fluids.denser();
      add_point(cut, point, weight, density);
      if (is_denser)
        for (unsigned int i = 0; i < point.values.size(); ++i)
          {
            cut.denser_measure[i] += weight * point.values[i];
            cut.denser_gradient[i] += weight * point.gradients[i];
          }
      const auto enrich = [&](const Star<dim> &star) {
        add_enrichment(cut, point, star, weight, density);
        if (is_denser)
          for (unsigned int i = 0; i < point.values.size(); ++i)
            cut.denser_star_load[i] += weight * star.gradients[i];
      };
      if (task.enrichment == PressureEnrichment::gradient)
        {
          const double sign          = negative ? -1. : 1.;
          const auto   kink_gradient = sign * gradient;
          enrich(kink_functions<dim>(point, task.w, sign * phi, kink_gradient));
          for (unsigned int i = 0; i < sums.kink.size(); ++i)
            sums.kink[i] += (weight * point.values[i]) * kink_gradient;
        }
      if (task.enrichment == PressureEnrichment::discontinuous)
        {
          enrich(jump_functions<dim>(point, task.phi, negative));
          if (!negative)
            add_second_gradients(cut, point, weight);
          for (unsigned int i = 0; i < point.values.size(); ++i)
            for (unsigned int j = 0; j < point.values.size(); ++j)
              sums.gradient[i][j] +=
                (weight * point.values[i]) * point.gradients[j];
        }
    }



    /// Adds the integrals of a parallelepiped: the shape functions are Q1.
    template <int dim>
    void
    integrate_in_reference_cell(CutCell<dim>    &cut,
                                Sums<dim>       &sums,
                                const Task<dim> &task)
    {
      const auto at = [&](const dealii::Point<dim> &xi) {
        return Q1::evaluate<dim>(task.cell,
                                 Q1::values<dim>(xi),
                                 Q1::reference_gradients<dim>(xi));
      };
      for (const auto &simplex : SimplexCut::divide<dim>(task.phi))
        {
          const auto reference_gradient = SimplexCut::gradient(simplex);
          SimplexCut::cut(simplex, [&](const auto &piece) {
            const bool negative = SimplexCut::is_negative(piece);
            for (const auto &q : SimplexCut::quadrature(piece))
              {
                const auto   point = at(q.xi);
                const double value =
                  simplex.phi[0] +
                  reference_gradient * (q.xi - simplex.corners[0]);
                add_all<dim>(cut,
                             sums,
                             task,
                             point,
                             q.weight * point.determinant,
                             negative,
                             value,
                             point.covariant * reference_gradient);
              }
            if (task.enrichment == PressureEnrichment::discontinuous)
              for_each_interface_point(
                piece, [&](const dealii::Point<dim> &xi, const auto &vector) {
                  const auto point = at(xi);
                  add_jump(cut,
                           point.values,
                           point.determinant * (point.covariant * vector));
                });
          });
        }
    }



    /// The same for any other cell: the shape functions are linear in each
    /// simplex, as the level set is.
    template <int dim>
    void
    integrate_in_space(CutCell<dim>    &cut,
                       Sums<dim>       &sums,
                       const Task<dim> &task)
    {
      const Q1::SimplexShape<dim> shape(task.cell.vertices);
      SimplexCut::cut_in_space<dim>(
        shape,
        task.phi,
        [&](const auto &piece, const auto &simplex, const auto &part) {
          Q1::Point<dim> point;
          point.values    = shape.values(piece.simplex, piece.middle);
          point.gradients = shape.gradients(piece.simplex, simplex);
          dealii::Tensor<1, dim> gradient;
          for (unsigned int v = 0; v < task.phi.size(); ++v)
            gradient += task.phi[v] * point.gradients[v];
          add_all<dim>(cut,
                       sums,
                       task,
                       point,
                       piece.measure,
                       piece.negative,
                       piece.phi,
                       gradient);
          if (task.enrichment == PressureEnrichment::discontinuous)
            for_each_interface_point(
              part, [&](const dealii::Point<dim> &b, const auto &vector) {
                std::array<double, dim + 1> barycentric{{1.}};
                dealii::Tensor<1, dim>      in_space;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    barycentric[d + 1] = b[d];
                    barycentric[0] -= b[d];
                    in_space += vector[d] * simplex.gradients[d + 1];
                  }
                // from the unit simplex to this one
                constexpr double unit = dim == 2 ? .5 : 1. / 6.;
                add_jump(cut,
                         shape.values(piece.simplex, barycentric),
                         simplex.measure / unit * in_space);
              });
        });
    }



    /**
     * @brief Lets jumps be integrated as exactly as the standard functions:
     * what fluid 0 has is what fluid 1 does not have of the whole cell. Adds
     * what jumps move.
     */
    template <int dim>
    void
    finish_jumps(CutCell<dim>    &cut,
                 const Task<dim> &task,
                 const Sums<dim> &sums)
    {
      constexpr unsigned int n = 1 << dim;
      for (unsigned int j = 0; j < n; ++j)
        {
          std::array<double, n> one{};
          one[j]           = 1.;
          const auto whole = continuous_gradient<dim>(task.cell, one);
          for (unsigned int i = 0; i < n; ++i)
            if (task.phi[j] >= 0)
              cut.star_gradient[i][j] -= whole[i] - sums.gradient[i][j];
        }
      // What jumps move: with the masses of this cell alone they move more.
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int i = 0; i < n; ++i)
            cut.star_response[j][k] += cut.star_jump[n * i + j] *
                                       cut.star_jump[n * i + k] /
                                       (n * cut.mass[i]);
    }



    /// Normal, fractions and mean viscosities.
    template <int dim>
    void
    set_laminate(CutCell<dim>                         &cut,
                 const typename CellGraph<dim>::Cell  &cell,
                 const std::array<double, (1 << dim)> &phi,
                 const Fluids                         &fluids)
    {
      const auto point = Q1::middle<dim>(cell);
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
                     const PressureEnrichment              enrichment)
  {
    constexpr unsigned int n = 1 << dim;
    CutCell<dim>           cut{};
    Task<dim>              task{cell, phi_in, w_in, fluids, enrichment};
    cut.cell = index;
    for (unsigned int v = 0; v < n; ++v)
      {
        task.phi[v] /= length;
        task.w[v] /= length;
      }
    set_laminate(cut, cell, task.phi, fluids);
    if (enrichment == PressureEnrichment::discontinuous)
      {
        cut.star_jump.resize(n * n);
        cut.second_gradients.resize(n * n);
      }

    Sums<dim> sums;
    if (Q1::is_parallelepiped<dim>(cell))
      integrate_in_reference_cell(cut, sums, task);
    else
      integrate_in_space(cut, sums, task);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          cut.laplace[j][i]           = cut.laplace[i][j];
          cut.mass_matrix[j][i]       = cut.mass_matrix[i][j];
          cut.laplace_star_star[j][i] = cut.laplace_star_star[i][j];
        }
    if (enrichment == PressureEnrichment::none)
      return cut;
    cut.star_response = cut.laplace_star_star;
    if (enrichment == PressureEnrichment::gradient)
      balance_uniform_kink(cut, sums.kink, cell, task.w);
    else
      finish_jumps(cut, task, sums);
    double trace = 0, star_trace = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        trace += cut.laplace[i][i];
        star_trace += cut.laplace_star_star[i][i];
      }
    cut.enriched = star_trace > negligible * trace &&
                   (enrichment == PressureEnrichment::gradient ||
                    (cut.negative_fraction > least_side &&
                     cut.negative_fraction < 1. - least_side));
    return cut;
  }



  template CutCell<2>
  integrate_cut_cell<2>(const unsigned int,
                        const CellGraph<2>::Cell &,
                        const std::array<double, 4> &,
                        const std::array<double, 4> &,
                        const double,
                        const Fluids &,
                        const PressureEnrichment);
  template CutCell<3>
  integrate_cut_cell<3>(const unsigned int,
                        const CellGraph<3>::Cell &,
                        const std::array<double, 8> &,
                        const std::array<double, 8> &,
                        const double,
                        const Fluids &,
                        const PressureEnrichment);
} // namespace Thalweg
