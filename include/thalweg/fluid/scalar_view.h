// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_scalar_view_h
#define thalweg_fluid_scalar_view_h

#include <thalweg/fields/node_space.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// What a method with a scalar offers under "scalars", on each mesh anew.
  template <int dim>
  struct ScalarView
  {
    std::string           unit; ///< of the scalar, as the user wrote it
    const NodeSpace<dim> &space;
    Vector                field; ///< at the nodes, ghosted and consistent

    /// The names of the boundaries where the value is given.
    std::map<dealii::types::boundary_id, std::string> given{};
    /// What flows out where the value is given, by boundary: at each node of
    /// this rank the flux through an area in a second, and its area.
    std::map<dealii::types::boundary_id, std::vector<std::pair<double, double>>>
      fluxes{};
  };
} // namespace Thalweg

#endif
