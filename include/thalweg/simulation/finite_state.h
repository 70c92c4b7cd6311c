// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_finite_state_h
#define thalweg_simulation_finite_state_h

#include <thalweg/methods/solution_view.h>

namespace Thalweg
{
  /**
   * @brief Stops a run whose fields or particles are no finite numbers.
   *
   * A process that finds one throws alone.
   * @throws dealii::ExcMessage that says what it is, where and when
   */
  template <int dim>
  void
  check_finite(const SolutionView<dim> &solution);
} // namespace Thalweg

#endif
