// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_near_null_space_h
#define thalweg_fluid_near_null_space_h

#include <thalweg/fields/node_space.h>

namespace Thalweg
{
  /// The translations of a flow's velocity and its rotations about the middle
  /// of the nodes, which have no friction: owned values. Collective.
  template <int dim>
  std::vector<std::vector<double>>
  rigid_motions(const NodeSpace<dim> &space);
} // namespace Thalweg

#endif
