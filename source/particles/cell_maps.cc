// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_maps.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  using namespace CellPolynomial;


  template <int dim>
  CellMaps<dim>::CellMaps(const CellGraph<dim> &graph)
    : graph(graph)
  {
    if (graph.all_axis_parallel())
      return;
    shape.resize(graph.n_cells());
    for (unsigned int i = 0; i < graph.n_cells(); ++i)
      shape[i] = shape_of(graph.cell(i));
  }


  template <int dim>
  typename CellMaps<dim>::Polynomial
  CellMaps<dim>::shape_of(const typename CellGraph<dim>::Cell &cell)
  {
    Polynomial shape;
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int c = 0; c < dim; ++c)
        shape[v * dim + c] = cell.vertices[v][c] - cell.vertices[0][c];
    to_polynomial<dim>(shape);
    return shape;
  }


  template <int dim>
  bool
  CellMaps<dim>::find_reference(const Polynomial  &shape,
                                const Coordinates &way,
                                Coordinates       &reference)
  {
    reference.fill(0.5);
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        Coordinates residual = evaluate(shape, reference);
        for (unsigned int d = 0; d < dim; ++d)
          residual[d] = way[d] - residual[d];
        const Coordinates change =
          solve<dim>(gradient<dim>(shape, reference), residual);
        double size = 0;
        for (unsigned int d = 0; d < dim; ++d)
          {
            reference[d] += change[d];
            size = std::max(size, std::abs(change[d]));
          }
        if (!is_finite<dim>(reference))
          return false;
        // Newton's method has doubled its digits by now
        if (size < 1e-9)
          return true;
      }
    return false;
  }

  template <int dim>
  unsigned int
  CellMaps<dim>::nearest_child(
    const std::array<int, CellGraph<dim>::n_face_children> &children,
    const Place                                            &place) const
  {
    int    nearest          = children[0];
    double nearest_distance = std::numeric_limits<double>::max();
    for (const int child : children)
      {
        Coordinates reference;
        if (!to_reference(child, place, reference))
          continue;
        double outside = 0;
        for (unsigned int d = 0; d < dim; ++d)
          outside = std::max({outside, -reference[d], reference[d] - 1.});
        if (outside < nearest_distance)
          {
            nearest          = child;
            nearest_distance = outside;
          }
      }
    return nearest;
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::CellMaps)
