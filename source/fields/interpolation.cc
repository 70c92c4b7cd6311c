#include <thalweg/fields/interpolation.h>

#include <deal.II/lac/vector.h>

namespace Thalweg
{
  template <int dim>
  void
  interpolate_function(const NodeSpace<dim>        &space,
                       const dealii::Function<dim> &function,
                       Vector                      &vector)
  {
    const CellGraph<dim>  &graph        = space.mesh().graph();
    const unsigned int     n_components = function.n_components;
    dealii::Vector<double> value(n_components);
    vector.zero_out_ghost_values();
    std::vector<bool> done(vector.locally_owned_size() / n_components, false);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (unsigned int v = 0; v < graph.n_vertices; ++v)
        {
          const unsigned int node = space.nodes(c)[v];
          if (node >= done.size() || done[node])
            continue;
          done[node] = true;
          function.vector_value(graph.cell(c).vertices[v], value);
          for (unsigned int i = 0; i < n_components; ++i)
            vector.local_element(n_components * node + i) = value[i];
        }
    space.interpolate(vector, n_components);
  }



  template void
  interpolate_function<2>(const NodeSpace<2> &,
                          const dealii::Function<2> &,
                          Vector &);
  template void
  interpolate_function<3>(const NodeSpace<3> &,
                          const dealii::Function<3> &,
                          Vector &);
} // namespace Thalweg
