// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/interface/contour.h>
#include <thalweg/interface/redistance.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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



    /// The cells around each owned node, ghost cells too.
    class CellsOfNodes
    {
    public:
      template <int dim>
      CellsOfNodes(const NodeSpace<dim> &space, const unsigned int n_owned)
        : first(n_owned + 1, 0)
      {
        const unsigned int n_cells  = space.mesh().graph().n_cells();
        const auto         for_each = [&](const auto &visit) {
          for (unsigned int c = 0; c < n_cells; ++c)
            for (const unsigned int node : space.nodes(c))
              if (node < n_owned)
                visit(c, node);
        };
        for_each(
          [&](unsigned int, const unsigned int node) { ++first[node + 1]; });
        std::partial_sum(first.begin(), first.end(), first.begin());
        cells.resize(first.back());
        auto next = first;
        for_each([&](const unsigned int c, const unsigned int node) {
          cells[next[node]++] = c;
        });
      }

      const unsigned int *
      begin(const unsigned int node) const
      {
        return cells.data() + first[node];
      }

      const unsigned int *
      end(const unsigned int node) const
      {
        return cells.data() + first[node + 1];
      }

    private:
      std::vector<unsigned int> first;
      std::vector<unsigned int> cells;
    };



    /// Where the two rings of cells around a node end before the contour does,
    /// what is nearest in them is too far away. If the projected level set
    /// there is the distance from the plane of the facets at that end, the
    /// contour goes on in it.
    template <int dim>
    double
    beyond_the_end(const std::vector<Facet<dim>> &facets,
                   const dealii::Point<dim>      &x,
                   const double                   distance,
                   const double                   projected)
    {
      const double beyond = distance_beyond_end<dim>(facets, x);
      return std::abs(std::abs(projected) - beyond) <= same_distance * distance
               ? std::min(beyond, distance)
               : distance;
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
    const Contour<dim>  contour(space, phi);
    const unsigned int  n_owned  = phi.locally_owned_size();
    std::vector<double> distance = limits(space, n_owned);

    const CellsOfNodes cells(space, n_owned);
    // The last round in which each patch was looked at: those around a node
    // share most of them, and each counts once.
    std::vector<unsigned int> seen_in(contour.n_patches(), 0);
    unsigned int              round          = 0;
    const auto                for_each_patch = [&](const unsigned int node,
                                    const auto        &visit) {
      const auto look_from = [&](const unsigned int from) {
        for (const unsigned int patch : contour.patches_at(from))
          if (seen_in[patch] != round)
            {
              seen_in[patch] = round;
              visit(patch);
            }
      };
      ++round;
      // A node's own cells first: what is farther is refused at once.
      look_from(node);
      for (const unsigned int *c = cells.begin(node); c != cells.end(node); ++c)
        for (const unsigned int neighbor : space.nodes(*c))
          look_from(neighbor);
    };
    std::vector<Facet<dim>> facets;
    for (unsigned int node = 0; node < n_owned; ++node)
      {
        if (phi.local_element(node) == 0.)
          {
            distance[node] = 0.;
            continue;
          }
        const auto   &x = space.position(node);
        FacetDistance nearest{distance[node], false};
        for_each_patch(node, [&](const unsigned int patch) {
          contour.find_nearest(patch, x, nearest);
        });
        distance[node] = nearest.distance;
        if (!nearest.on_side)
          continue;
        facets.clear();
        for_each_patch(node, [&](const unsigned int patch) {
          contour.collect_nearest(patch, x, nearest, facets);
        });
        distance[node] =
          beyond_the_end(facets, x, nearest.distance, phi.local_element(node));
      }

    phi.zero_out_ghost_values();
    for (unsigned int n = 0; n < n_owned; ++n)
      phi.local_element(n) = std::copysign(distance[n], phi.local_element(n));
    space.interpolate(phi, 1);
  }



  THALWEG_INSTANTIATE(Redistance)
} // namespace Thalweg
