// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_vertex_values_h
#define thalweg_fields_vertex_values_h

#include <thalweg/fields/lagrange_space.h>
#include <thalweg/fields/node_space.h>

namespace Thalweg
{
  /**
   * @brief Copies a field's values at the vertices to a Q1 field.
   * @param space of @p source
   * @param source ghosted
   * @param vertices on the same mesh: a NodeSpace, or a LagrangeSpace of
   *   degree 1
   * @param destination ghosted and consistent afterwards
   * @param n_components 1 or dim
   */
  template <int dim, typename VertexSpace>
  void
  copy_to_vertices(const LagrangeSpace<dim> &space,
                   const Vector             &source,
                   const VertexSpace        &vertices,
                   Vector                   &destination,
                   const unsigned int        n_components);
} // namespace Thalweg

#endif
