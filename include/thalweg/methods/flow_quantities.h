// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_flow_quantities_h
#define thalweg_methods_flow_quantities_h

#include <thalweg/interface/phase_field.h>
#include <thalweg/methods/flow_view.h>

#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Kinetic and potential energy, momentum and the largest speed in
   * each fluid, with the names of their columns in the statistics. Collective.
   *
   * Integrals of a flow in spaces of its own are exact on straight cells;
   * else they are lumped at the vertices.
   * @param gravity m/s^2; the potential is zero at the origin
   */
  template <int dim>
  std::vector<std::pair<std::string, double>>
  flow_quantities(const FlowView<dim>          &solution,
                  const PhaseField<dim>        &phase,
                  const dealii::Tensor<1, dim> &gravity);
} // namespace Thalweg

#endif
