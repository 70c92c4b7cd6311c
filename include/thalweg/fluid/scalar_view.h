// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_scalar_view_h
#define thalweg_fluid_scalar_view_h

#include <thalweg/fields/node_space.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// At nodes of this rank where a scalar is given, by boundary: what flows out
  /// through an area in a second, and the area.
  using BoundaryFluxes = std::map<dealii::types::boundary_id,
                                  std::vector<std::pair<double, double>>>;

  /// What a method with a scalar offers under "scalars", on each mesh anew.
  template <int dim>
  struct ScalarView
  {
    const NodeSpace<dim> &space;
    Vector                field{}; ///< at the nodes, ghosted and consistent
    /// Likewise which part is molten; empty where nothing melts.
    Vector molten{};
    /// The names of the boundaries where the value is given.
    std::map<dealii::types::boundary_id, std::string> given{};
    /// What flows out there, at a time in s. Collective.
    std::function<BoundaryFluxes(const double)> fluxes{};
  };
} // namespace Thalweg

#endif
