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
    // The last node that looked at each patch: those around a node share most
    // of them, and each counts once.
    std::vector<unsigned int> seen_by(contour.n_patches(), n_owned);
    const auto look_at = [&](const unsigned int from, const unsigned int node) {
      for (const unsigned int patch : contour.patches_at(from))
        if (seen_by[patch] != node)
          {
            seen_by[patch] = node;
            distance[node] =
              contour.distance(patch, space.position(node), distance[node]);
          }
    };
    for (unsigned int node = 0; node < n_owned; ++node)
      {
        // A node's own cells first: what is farther is refused at once.
        look_at(node, node);
        for (const unsigned int *c = cells.begin(node); c != cells.end(node);
             ++c)
          for (const unsigned int neighbor : space.nodes(*c))
            look_at(neighbor, node);
      }

    phi.zero_out_ghost_values();
    for (unsigned int n = 0; n < n_owned; ++n)
      phi.local_element(n) = std::copysign(distance[n], phi.local_element(n));
    space.interpolate(phi, 1);
  }



  THALWEG_INSTANTIATE(Redistance)
} // namespace Thalweg
