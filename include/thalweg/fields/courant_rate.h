// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_courant_rate_h
#define thalweg_fields_courant_rate_h

#include <thalweg/fields/node_space.h>

namespace Thalweg
{
  /// The Courant number of a step of one second, 1/s; infinity if a velocity
  /// is no finite number. Collective.
  /// @param velocity at the nodes of @p space, ghosted, m/s
  template <int dim>
  double
  courant_rate(const NodeSpace<dim> &space, const Vector &velocity);
} // namespace Thalweg

#endif
