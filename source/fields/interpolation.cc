// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fields/interpolation.h>

#include <deal.II/fe/fe_values.h>
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



  template <int dim>
  void
  for_each_owned_node(
    const LagrangeSpace<dim> &space,
    const std::function<void(const unsigned int, const dealii::Point<dim> &)>
      &visit)
  {
    const auto                   &graph = space.mesh().graph();
    const dealii::Quadrature<dim> nodes(space.unit_nodes());
    dealii::FEValues<dim>         values(space.mapping(),
                                 space.scalar().get_fe(),
                                 nodes,
                                 dealii::update_quadrature_points);
    std::vector<bool>             done(space.n_owned_nodes(), false);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      {
        values.reinit(
          Compat::on_dof_handler(graph.iterator(c), space.scalar()));
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const unsigned int node = space.nodes(c)[i];
            if (node >= done.size() || done[node])
              continue;
            done[node] = true;
            visit(node, values.quadrature_point(i));
          }
      }
  }



  template <int dim>
  void
  interpolate_function(const LagrangeSpace<dim>    &space,
                       const dealii::Function<dim> &function,
                       Vector                      &vector)
  {
    const unsigned int     n_components = function.n_components;
    dealii::Vector<double> value(n_components);
    vector.zero_out_ghost_values();
    for_each_owned_node<dim>(
      space, [&](const unsigned int node, const dealii::Point<dim> &position) {
        function.vector_value(position, value);
        for (unsigned int i = 0; i < n_components; ++i)
          vector.local_element(n_components * node + i) = value[i];
      });
    space.interpolate(vector, n_components);
  }



#define INSTANTIATE(dim)                                                      \
  template void interpolate_function<dim>(const NodeSpace<dim> &,             \
                                          const dealii::Function<dim> &,      \
                                          Vector &);                          \
  template void interpolate_function<dim>(const LagrangeSpace<dim> &,         \
                                          const dealii::Function<dim> &,      \
                                          Vector &);                          \
  template void for_each_owned_node<dim>(                                     \
    const LagrangeSpace<dim> &,                                               \
    const std::function<void(const unsigned int, const dealii::Point<dim> &)> \
      &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
