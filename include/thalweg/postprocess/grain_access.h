// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_grain_access_h
#define thalweg_postprocess_grain_access_h

#include <thalweg/methods/grain_view.h>
#include <thalweg/methods/solution_view.h>

#include <algorithm>
#include <map>
#include <string>

namespace Thalweg
{
  /// Refuses a run without grains. @param model the postprocessor
  /// @throws dealii::ExcMessage
  template <int dim>
  void
  check_grains(const RunOutline<dim> &outline, const std::string &model)
  {
    AssertThrow(outline.offered.has("", "grains"),
                dealii::ExcMessage(
                  "No method of this run has grains. Take '" + model +
                  "' out of 'Postprocess/Models', or add a method to "
                  "'Methods/Names': 'sand: grains'."));
  }

  /// The grains of all methods that have some, by the methods' names.
  template <int dim>
  std::map<std::string, const GrainView *>
  all_grains(const SolutionView<dim> &solution)
  {
    return solution.ports->template all<const GrainView>("grains");
  }

  /// The beginning of the names of a method's files.
  inline std::string
  grain_file_name(std::string method)
  {
    std::replace(method.begin(), method.end(), ' ', '_');
    return method.empty() ? "grains" : method;
  }
} // namespace Thalweg

#endif
