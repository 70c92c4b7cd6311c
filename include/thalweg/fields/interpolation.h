#ifndef thalweg_fields_interpolation_h
#define thalweg_fields_interpolation_h

#include <thalweg/fields/node_space.h>

#include <deal.II/base/function.h>

namespace Thalweg
{
  /// Sets a scalar (one component) or a velocity (dim components) to the
  /// values of @p function at the nodes; ghosts and dependent nodes too.
  template <int dim>
  void
  interpolate_function(const NodeSpace<dim>        &space,
                       const dealii::Function<dim> &function,
                       Vector                      &vector);
} // namespace Thalweg

#endif
