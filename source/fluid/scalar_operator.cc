// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/scalar_operator.h>
#include <thalweg/materials/laminate.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Which part of a cell is of the first fluid.
    template <int dim>
    double
    part_of_first(const PhaseField<dim> &phase, const unsigned int cell)
    {
      const int cut = phase.cut_index(cell);
      return cut >= 0 ? phase.cut_cells()[cut].negative_fraction
                      : 1. - phase.fluid_number(cell);
    }
  } // namespace



  template <int dim>
  ScalarOperator<dim>::ScalarOperator(const NodeSpace<dim> &space)
    : space(space)
    , couplings(space.mesh().graph().n_owned_cells())
  {
    for (Vector *vector : {&mass,
                           &volume,
                           &diagonal,
                           &shift,
                           &preconditioner.inverse_diagonal,
                           &work})
      space.initialize_scalar(*vector);
    const auto &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto measures = integrals.node_measures(graph.cell(c));
        for (unsigned int i = 0; i < n_vertices; ++i)
          volume.local_element(space.nodes(c)[i]) += measures[i];
      }
    space.fold(volume, 1);
    volume.zero_out_ghost_values();
  }



  template <int dim>
  void
  ScalarOperator<dim>::set_couplings(const unsigned int     cell,
                                     const PhaseField<dim> &phase,
                                     const Material        &conductivity)
  {
    const auto  &geometry = space.mesh().graph().cell(cell);
    const auto   laplace  = integrals.laplace(geometry);
    const double part     = part_of_first(phase, cell);
    const double along    = arithmetic_mean(part, conductivity);
    const double excess   = harmonic_mean(part, conductivity) - along;
    std::array<double, n_vertices> across{}; // int grad N_i . n
    const int                      cut = phase.cut_index(cell);
    if (cut >= 0)
      {
        const auto gradients = integrals.gradient_integrals(geometry);
        for (unsigned int i = 0; i < n_vertices; ++i)
          across[i] = gradients[i] * phase.cut_cells()[cut].normal;
      }
    auto &pairs = couplings[cell];
    for (unsigned int i = 1, k = 0; i < n_vertices; ++i)
      for (unsigned int j = 0; j < i; ++j, ++k)
        {
          pairs[k] = -along * laplace[i][j];
          if (cut >= 0)
            pairs[k] -= excess / geometry.measure * across[i] * across[j];
        }
  }



  template <int dim>
  void
  ScalarOperator<dim>::update(const PhaseField<dim> &phase,
                              const Material        &capacity,
                              const Material        &conductivity)
  {
    lump(phase, capacity, mass);
    diagonal = 0.;
    for (unsigned int c = 0; c < couplings.size(); ++c)
      {
        set_couplings(c, phase, conductivity);
        const auto &nodes = space.nodes(c);
        for (unsigned int i = 1, k = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < i; ++j, ++k)
            for (const unsigned int node : {nodes[i], nodes[j]})
              diagonal.local_element(node) += couplings[c][k];
      }
    space.fold(diagonal, 1);
    diagonal.zero_out_ghost_values();
  }



  template <int dim>
  void
  ScalarOperator<dim>::find_majorant(Vector &row_sums) const
  {
    row_sums.zero_out_ghost_values();
    row_sums = 0.;
    for (unsigned int c = 0; c < couplings.size(); ++c)
      {
        const auto &nodes = space.nodes(c);
        for (unsigned int i = 1, k = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < i; ++j, ++k)
            for (const unsigned int node : {nodes[i], nodes[j]})
              row_sums.local_element(node) += 2. * std::abs(couplings[c][k]);
      }
    space.fold(row_sums, 1);
    row_sums.zero_out_ghost_values();
  }



  template <int dim>
  void
  ScalarOperator<dim>::lump(const PhaseField<dim> &phase,
                            const Material        &material,
                            Vector                &amount) const
  {
    const auto &graph = space.mesh().graph();
    amount            = 0.;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto   measures = integrals.node_measures(graph.cell(c));
        const double mean = arithmetic_mean(part_of_first(phase, c), material);
        for (unsigned int i = 0; i < n_vertices; ++i)
          amount.local_element(space.nodes(c)[i]) += mean * measures[i];
      }
    space.fold(amount, 1);
    amount.zero_out_ghost_values();
  }



  template <int dim>
  void
  ScalarOperator<dim>::set_step(const double               tau,
                                const Vector              &exchange,
                                const std::vector<bool>   &is_given,
                                const std::vector<double> &slopes)
  {
    is_fixed        = is_given;
    Vector &inverse = preconditioner.inverse_diagonal;
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      {
        const double slope = slopes.empty() ? 1. : slopes[n];
        is_fixed[n] = is_fixed[n] || space.is_dependent(n) || slope == 0.;
        shift.local_element(n) =
          is_fixed[n]
            ? 0.
            : mass.local_element(n) / (tau * slope) + exchange.local_element(n);
        inverse.local_element(n) =
          is_fixed[n]
            ? 1.
            : 1. / (shift.local_element(n) + diagonal.local_element(n));
      }
  }



  template <int dim>
  void
  ScalarOperator<dim>::add_diffusion(const Vector &scalar, Vector &result) const
  {
    for (unsigned int c = 0; c < couplings.size(); ++c)
      {
        const auto                    &nodes = space.nodes(c);
        const auto                    &pairs = couplings[c];
        std::array<double, n_vertices> s, gain{};
        for (unsigned int i = 0; i < n_vertices; ++i)
          s[i] = scalar.local_element(nodes[i]);
        for (unsigned int i = 1, k = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < i; ++j, ++k)
            {
              const double flow = pairs[k] * (s[j] - s[i]);
              gain[i] += flow;
              gain[j] -= flow;
            }
        for (unsigned int i = 0; i < n_vertices; ++i)
          result.local_element(nodes[i]) += gain[i];
      }
  }



  template <int dim>
  void
  ScalarOperator<dim>::diffuse(Vector &result, const Vector &scalar) const
  {
    result.zero_out_ghost_values();
    result = 0.;
    add_diffusion(scalar, result);
    space.fold(result, 1);
    result.zero_out_ghost_values();
  }



  template <int dim>
  void
  ScalarOperator<dim>::vmult(Vector &result, const Vector &increment) const
  {
    work.zero_out_ghost_values();
    work.copy_locally_owned_data_from(increment);
    space.interpolate(work, 1);
    diffuse(result, work);
    for (unsigned int n = 0; n < is_fixed.size(); ++n)
      result.local_element(n) =
        is_fixed[n] ? increment.local_element(n)
                    : shift.local_element(n) * increment.local_element(n) -
                        result.local_element(n);
  }



  THALWEG_INSTANTIATE(ScalarOperator)
} // namespace Thalweg
