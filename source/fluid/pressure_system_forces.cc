// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of a pressure and of what it balances on the nodes.
#include <thalweg/fields/gather.h>
#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/fluid/pressure_system.h>

namespace Thalweg
{
  template <int dim>
  void
  PressureSystem<dim>::subtract_gradient(const EnrichedPressure &pressure,
                                         Vector                 &force) const
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto                         &nodes = space.nodes(c);
        std::array<double, dim *(1 << dim)> result{};
        integrals.add_gradient(graph.cell(c),
                               gather<dim>(nodal(pressure), nodes),
                               result);
        if (const CutCell<dim> *cut = enriched_cell(c))
          {
            const auto q = gather<dim>(star(pressure), nodes);
            for (unsigned int v = 0; v < nodes.size(); ++v)
              for (unsigned int j = 0; j < nodes.size(); ++j)
                for (unsigned int d = 0; d < dim; ++d)
                  result[dim * v + d] += cut->star_gradient[v][j][d] * q[j];
          }
        for (unsigned int v = 0; v < nodes.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            force.local_element(dim * nodes[v] + d) -= result[dim * v + d];
      }
  }



  template <int dim>
  void
  PressureSystem<dim>::subtract_jump_forces(const EnrichedPressure &pressure,
                                            Vector                 &force) const
  {
    constexpr unsigned int n = 1 << dim;
    for (const CutCell<dim> &cut : phase.cut_cells())
      if (cut.enriched && !cut.star_jump.empty())
        {
          const auto &nodes = space.nodes(cut.cell);
          const auto  q     = gather<dim>(star(pressure), nodes);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int d = 0; d < dim; ++d)
                force.local_element(dim * nodes[i] + d) -=
                  cut.star_jump[n * i + j][d] * q[j];
        }
  }



  template <int dim>
  void
  PressureSystem<dim>::add_force_density(Vector &force) const
  {
    if (!forces.has_density())
      return;
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto measures = integrals.node_measures(graph.cell(c));
        const auto f        = forces.density(Q1::center<dim>(graph.cell(c)));
        for (unsigned int i = 0; i < measures.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            force.local_element(dim * space.nodes(c)[i] + d) +=
              measures[i] * f[d];
      }
  }



  template <int dim>
  void
  PressureSystem<dim>::add_tension(Vector &force) const
  {
    if (tension == nullptr)
      return;
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      if (const auto *tension_of_cell = tension->force(c))
        {
          std::array<double, dim *(1 << dim)> result{};
          integrals.add_gradient(graph.cell(c),
                                 tension_of_cell->pressures,
                                 result);
          const CutCell<dim> *cut = cut_cell(c);
          for (unsigned int v = 0; v < (1u << dim); ++v)
            for (unsigned int d = 0; d < dim; ++d)
              force.local_element(dim * space.nodes(c)[v] + d) +=
                result[dim * v + d] +
                (cut ? cut->denser_measure[v] * tension_of_cell->density[d]
                     : 0.);
        }
  }



  template <int dim>
  void
  PressureSystem<dim>::accelerate(const EnrichedPressure &pressure,
                                  const bool              with_forces,
                                  const NodalMass<dim>   &mass,
                                  Vector                 &result) const
  {
    result = 0.;
    subtract_gradient(pressure, result);
    if (with_forces)
      {
        add_force_density(result);
        add_tension(result);
      }
    space.fold(result, dim);
    mass.accelerate(result,
                    with_forces ? forces.uniform_acceleration()
                                : dealii::Tensor<1, dim>(),
                    with_forces ? &field : nullptr);
  }



#define THALWEG_INSTANTIATE_FORCES(dim)                                   \
  template void PressureSystem<dim>::subtract_gradient(                   \
    const EnrichedPressure &, Vector &) const;                            \
  template void PressureSystem<dim>::subtract_jump_forces(                \
    const EnrichedPressure &, Vector &) const;                            \
  template void PressureSystem<dim>::accelerate(const EnrichedPressure &, \
                                                const bool,               \
                                                const NodalMass<dim> &,   \
                                                Vector &) const;
  THALWEG_INSTANTIATE_FORCES(2)
  THALWEG_INSTANTIATE_FORCES(3)
#undef THALWEG_INSTANTIATE_FORCES
} // namespace Thalweg
