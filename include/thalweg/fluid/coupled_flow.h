// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_coupled_flow_h
#define thalweg_fluid_coupled_flow_h

#include <thalweg/fluid/enriched_matrix.h>

namespace Thalweg
{
  /**
   * @brief A velocity and an enriched pressure in one, or the rows of their
   * equations: owned values count. The blocks are the velocity, in m/s, and
   * those of an EnrichedPressure, in Pa.
   */
  using CoupledFlow = dealii::LinearAlgebra::distributed::BlockVector<double>;

  /// The velocity, or the momentum equation's rows.
  template <typename Coupled>
  inline auto &
  velocity(Coupled &flow)
  {
    return flow.block(0);
  }

  /// Makes @p flow zero.
  template <int dim>
  void
  initialize_coupled(const NodeSpace<dim> &space, CoupledFlow &flow)
  {
    flow.reinit(3);
    space.initialize_velocity(flow.block(0));
    for (unsigned int b = 1; b < flow.n_blocks(); ++b)
      space.initialize_scalar(flow.block(b));
    flow.collect_sizes();
  }

  /// Copies the owned values of the pressure, or of its rows, out of @p flow.
  inline void
  get_pressure(const CoupledFlow &flow, EnrichedPressure &pressure)
  {
    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      {
        pressure.block(b).zero_out_ghost_values();
        pressure.block(b).copy_locally_owned_data_from(flow.block(b + 1));
      }
  }

  /// The other way.
  inline void
  set_pressure(const EnrichedPressure &pressure, CoupledFlow &flow)
  {
    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      flow.block(b + 1).copy_locally_owned_data_from(pressure.block(b));
  }
} // namespace Thalweg

#endif
