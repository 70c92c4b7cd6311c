#include <thalweg/core/registry.h>
#include <thalweg/interface/contour.h>
#include <thalweg/interface/redistance.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Twice the longest diagonal of the cells around each owned node: no
    /// facet in two rings of cells around it is farther away than that.
    template <int dim>
    std::vector<double>
    limits(const NodeSpace<dim> &space, const unsigned int n_owned)
    {
      const CellGraph<dim> &graph = space.mesh().graph();
      std::vector<double>   limits(n_owned, 0.);
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        {
          const auto  &vertices = graph.cell(c).vertices;
          const double diagonal = vertices.front().distance(vertices.back());
          for (const unsigned int node : space.nodes(c))
            if (node < n_owned)
              limits[node] = std::max(limits[node], 2. * diagonal);
        }
      return limits;
    }
  } // namespace



  template <int dim>
  Redistance<dim>::Redistance(const NodeSpace<dim> &space)
    : space(space)
  {}



  template <int dim>
  void
  Redistance<dim>::apply(Vector &phi) const
  {
    const Contour<dim>    contour(space, phi);
    const CellGraph<dim> &graph    = space.mesh().graph();
    const unsigned int    n_owned  = phi.locally_owned_size();
    std::vector<double>   distance = limits(space, n_owned);

    const auto look_at = [&](const unsigned int from, const unsigned int node) {
      for (const unsigned int patch : contour.patches_at(from))
        distance[node] =
          contour.distance(patch, space.position(node), distance[node]);
    };
    // A node's own cells first: what is farther is refused at once.
    for (unsigned int node = 0; node < n_owned; ++node)
      look_at(node, node);
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (const unsigned int neighbor : space.nodes(c))
        if (!contour.patches_at(neighbor).empty())
          for (const unsigned int node : space.nodes(c))
            if (node < n_owned && node != neighbor)
              look_at(neighbor, node);

    phi.zero_out_ghost_values();
    for (unsigned int n = 0; n < n_owned; ++n)
      phi.local_element(n) = std::copysign(distance[n], phi.local_element(n));
    space.interpolate(phi, 1);
  }



  THALWEG_INSTANTIATE(Redistance)
} // namespace Thalweg
