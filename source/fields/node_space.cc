// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/node_space.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim>
  NodeSpace<dim>::NodeSpace(const Mesh<dim> &mesh)
    : LagrangeSpace<dim>(mesh, 1, mesh.mapping())
  {
    const CellGraph<dim> &graph = mesh.graph();
    vertex_nodes.resize(graph.n_cells());
    // The lexicographic order of two nodes a direction is that of vertices.
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      std::copy_n(LagrangeSpace<dim>::nodes(c),
                  n_vertices,
                  vertex_nodes[c].begin());

    const auto &all = this->dependences().all();
    for (unsigned int first = 0, end = 0; first < all.size(); first = end)
      {
        while (end < all.size() && all[end].node == all[first].node)
          ++end;
        if (end > first + 1)
          hanging[all[first].node] = {first, end};
      }
    dealii::Point<dim> unknown;
    for (unsigned int d = 0; d < dim; ++d)
      unknown[d] = std::numeric_limits<double>::quiet_NaN();
    node_positions.assign(this->dependences().n_nodes(), unknown);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        node_positions[vertex_nodes[c][v]] = graph.cell(c).vertices[v];
    ask_for_positions();
  }



  template <int dim>
  NodeSpace<dim>::~NodeSpace() = default;



  template <int dim>
  void
  NodeSpace<dim>::ask_for_positions()
  {
    Vector positions;
    initialize_velocity(positions);
    for (unsigned int i = 0; i < positions.locally_owned_size(); ++i)
      positions.local_element(i) = node_positions[i / dim][i % dim];
    positions.update_ghost_values();
    for (unsigned int n = 0; n < node_positions.size(); ++n)
      if (std::isnan(node_positions[n][0]))
        for (unsigned int d = 0; d < dim; ++d)
          node_positions[n][d] = positions.local_element(dim * n + d);
  }



  template <int dim>
  void
  NodeSpace<dim>::copy_to_cells(const Vector      &velocity,
                                CellVelocity<dim> &cells) const
  {
    cells.resize(vertex_nodes.size());
    for (unsigned int c = 0; c < vertex_nodes.size(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        for (unsigned int d = 0; d < dim; ++d)
          cells[c][dim * v + d] =
            velocity.local_element(dim * vertex_nodes[c][v] + d);
  }



  template <int dim>
  void
  NodeSpace<dim>::copy_to_cells(const Vector      &scalar,
                                CellField<dim, 1> &cells) const
  {
    cells.resize(vertex_nodes.size());
    for (unsigned int c = 0; c < vertex_nodes.size(); ++c)
      for (unsigned int v = 0; v < n_vertices; ++v)
        cells[c][v] = scalar.local_element(vertex_nodes[c][v]);
  }



  THALWEG_INSTANTIATE(NodeSpace)
} // namespace Thalweg
