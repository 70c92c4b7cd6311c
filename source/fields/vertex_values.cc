// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/vertex_values.h>

namespace Thalweg
{
  namespace
  {
    /// The place of a vertex among the nodes of a cell.
    template <int dim>
    unsigned int
    corner(const LagrangeSpace<dim> &space, const unsigned int vertex)
    {
      unsigned int place = 0, stride = 1;
      for (unsigned int d = 0; d < dim; ++d, stride *= space.degree() + 1)
        place += ((vertex >> d) & 1u) * space.degree() * stride;
      return place;
    }
  } // namespace



  template <int dim, typename VertexSpace>
  void
  copy_to_vertices(const LagrangeSpace<dim> &space,
                   const Vector             &source,
                   const VertexSpace        &vertices,
                   Vector                   &destination,
                   const unsigned int        n_components)
  {
    destination.zero_out_ghost_values();
    const unsigned int n_owned =
      destination.locally_owned_size() / n_components;
    for (unsigned int c = 0; c < vertices.mesh().graph().n_cells(); ++c)
      for (unsigned int v = 0; v < (1u << dim); ++v)
        {
          const unsigned int to   = vertices.nodes(c)[v];
          const unsigned int from = space.nodes(c)[corner(space, v)];
          if (to < n_owned)
            for (unsigned int i = 0; i < n_components; ++i)
              destination.local_element(n_components * to + i) =
                source.local_element(n_components * from + i);
        }
    vertices.interpolate(destination, n_components);
  }



#define INSTANTIATE(dim, VertexSpace)                             \
  template void copy_to_vertices<dim>(const LagrangeSpace<dim> &, \
                                      const Vector &,             \
                                      const VertexSpace<dim> &,   \
                                      Vector &,                   \
                                      const unsigned int);
  INSTANTIATE(2, NodeSpace)
  INSTANTIATE(3, NodeSpace)
  INSTANTIATE(2, LagrangeSpace)
  INSTANTIATE(3, LagrangeSpace)
#undef INSTANTIATE
} // namespace Thalweg
