#ifndef thalweg_fields_vertex_values_h
#define thalweg_fields_vertex_values_h

#include <thalweg/fields/lagrange_space.h>
#include <thalweg/fields/node_space.h>

namespace Thalweg
{
  /**
   * @brief Copies a field's values at the vertices to a Q1 field.
   * @param space of @p source, on the same mesh as @p nodes
   * @param source ghosted
   * @param destination ghosted and consistent afterwards
   * @param n_components 1 or dim
   */
  template <int dim>
  void
  copy_to_vertices(const LagrangeSpace<dim> &space,
                   const Vector             &source,
                   const NodeSpace<dim>     &nodes,
                   Vector                   &destination,
                   const unsigned int        n_components);
} // namespace Thalweg

#endif
