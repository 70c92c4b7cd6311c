// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_phase_integrals_h
#define thalweg_postprocess_phase_integrals_h

#include <thalweg/methods/flow_view.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace Thalweg
{
  /// What integration over the part of a fluid yields.
  template <int dim>
  struct PhaseIntegrals
  {
    double                 volume = 0.;        ///< m^dim
    dealii::Tensor<1, dim> moment_of_position; ///< of x dx, m^(dim+1)
    dealii::Tensor<1, dim> moment_of_velocity; ///< of v dx, m^(dim+1)/s
  };

  /**
   * @brief Integrals over each fluid, cut at the piecewise linear level set
   * of SimplexCut; volumes are exact for it on axis-parallel cells.
   * Collective.
   */
  template <int dim>
  std::array<PhaseIntegrals<dim>, 2>
  integrate_phases(const FlowView<dim> &solution);
} // namespace Thalweg

#endif
