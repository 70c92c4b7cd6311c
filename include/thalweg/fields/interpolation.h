// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_interpolation_h
#define thalweg_fields_interpolation_h

#include <thalweg/fields/lagrange_space.h>
#include <thalweg/fields/node_space.h>

#include <deal.II/base/function.h>

#include <functional>

namespace Thalweg
{
  /// Sets a scalar (one component) or a velocity (dim components) to the
  /// values of @p function at the nodes; ghosts and dependent nodes too.
  template <int dim>
  void
  interpolate_function(const NodeSpace<dim>        &space,
                       const dealii::Function<dim> &function,
                       Vector                      &vector);

  /// The same in a space of any degree, at the nodes of its mapping.
  template <int dim>
  void
  interpolate_function(const LagrangeSpace<dim>    &space,
                       const dealii::Function<dim> &function,
                       Vector                      &vector);

  /// Calls @p visit with each owned node and its position, once.
  template <int dim>
  void
  for_each_owned_node(
    const LagrangeSpace<dim> &space,
    const std::function<void(const unsigned int, const dealii::Point<dim> &)>
      &visit);
} // namespace Thalweg

#endif
