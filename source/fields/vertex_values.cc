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



  template <int dim>
  void
  copy_to_vertices(const LagrangeSpace<dim> &space,
                   const Vector             &source,
                   const NodeSpace<dim>     &nodes,
                   Vector                   &destination,
                   const unsigned int        n_components)
  {
    destination.zero_out_ghost_values();
    const unsigned int n_owned =
      destination.locally_owned_size() / n_components;
    for (unsigned int c = 0; c < nodes.mesh().graph().n_cells(); ++c)
      for (unsigned int v = 0; v < (1u << dim); ++v)
        {
          const unsigned int to   = nodes.nodes(c)[v];
          const unsigned int from = space.nodes(c)[corner(space, v)];
          if (to < n_owned)
            for (unsigned int i = 0; i < n_components; ++i)
              destination.local_element(n_components * to + i) =
                source.local_element(n_components * from + i);
        }
    nodes.interpolate(destination, n_components);
  }



#define INSTANTIATE(dim)                                          \
  template void copy_to_vertices<dim>(const LagrangeSpace<dim> &, \
                                      const Vector &,             \
                                      const NodeSpace<dim> &,     \
                                      Vector &,                   \
                                      const unsigned int);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
