// What a walk prepares once for each cell, and the inverse of general cells'
// maps; the walking itself is in streamline_walk.cc.
#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_polynomial.h>
#include <thalweg/particles/streamline_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  using namespace CellPolynomial;


  template <int dim>
  StreamlineWalk<dim>::StreamlineWalk(const CellGraph<dim>    &graph,
                                      const CellVelocity<dim> &velocity,
                                      const Settings          &settings,
                                      const double             direction)
    : cell_graph(graph)
    , scheme(settings.scheme)
    , greatest_way(settings.substep)
    , direction(direction)
  {
    AssertDimension(velocity.size(), graph.n_cells());
    for (const auto &[boundary, kind] : settings.walls)
      if (kind == WallKind::open)
        {
          open.resize(std::max<std::size_t>(open.size(), boundary + 1), false);
          open[boundary] = true;
        }

    if (!graph.all_axis_parallel())
      {
        shape.resize(graph.n_cells());
        for (unsigned int i = 0; i < graph.n_cells(); ++i)
          {
            for (unsigned int v = 0; v < n_vertices; ++v)
              for (unsigned int c = 0; c < dim; ++c)
                shape[i][v * dim + c] = graph.cell(i).vertices[v][c];
            to_polynomial<dim>(shape[i]);
          }
      }

    flow.reserve(graph.n_cells());
    for (unsigned int i = 0; i < graph.n_cells(); ++i)
      flow.push_back(prepare(i, velocity[i]));
  }


  template <int dim>
  typename StreamlineWalk<dim>::Flow
  StreamlineWalk<dim>::prepare(const unsigned int cell,
                               const Polynomial  &nodal_velocity) const
  {
    const auto &geometry = cell_graph.cell(cell);
    Flow        result;
    double      fastest = 0;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        Coordinates velocity, vertex;
        for (unsigned int d = 0; d < dim; ++d)
          {
            velocity[d] = direction * nodal_velocity[v * dim + d];
            vertex[d]   = (v >> d) & 1;
          }
        Coordinates rate;
        if (geometry.axis_parallel)
          {
            for (unsigned int d = 0; d < dim; ++d)
              rate[d] = velocity[d] * geometry.inverse_extent[d];
            velocity = rate;
          }
        else
          rate = solve<dim>(gradient<dim>(shape[cell], vertex), velocity);
        for (unsigned int d = 0; d < dim; ++d)
          {
            result.velocity[v * dim + d] = velocity[d];
            fastest                      = std::max(fastest, std::abs(rate[d]));
          }
      }
    to_polynomial<dim>(result.velocity);
    result.longest_substep =
      fastest > 0 ? greatest_way / fastest : std::numeric_limits<double>::max();
    return result;
  }


  template <int dim>
  bool
  StreamlineWalk<dim>::find_reference(const unsigned int cell,
                                      const Coordinates &position,
                                      Coordinates       &reference) const
  {
    reference.fill(0.5);
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        Coordinates residual = evaluate(shape[cell], reference);
        for (unsigned int d = 0; d < dim; ++d)
          residual[d] = position[d] - residual[d];
        const Coordinates change =
          solve<dim>(gradient<dim>(shape[cell], reference), residual);
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
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::StreamlineWalk)
