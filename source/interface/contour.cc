// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/core/send_plain.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_simplices.h>
#include <thalweg/interface/contour.h>
#include <thalweg/interface/simplex_cut.h>

#include <algorithm>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// A point of the contour by its way from the first corner of the cell, and
    /// the faces of the cell that it lies on, bit by bit.
    template <int dim>
    struct Zero
    {
      dealii::Tensor<1, dim> way;
      unsigned int           faces;
    };



    /// Points where the level set vanishes on the edges of simplex @p s, in
    /// circular order.
    template <int dim>
    std::vector<Zero<dim>>
    zeros(const SimplexCut::Simplex<dim> &simplex, const unsigned int s)
    {
      const auto            &division = Q1::Division<dim>::instance();
      const auto            &phi      = simplex.phi;
      std::vector<Zero<dim>> points;
      for (unsigned int i = 0; i < dim + 1; ++i)
        for (unsigned int j = 0; j < dim + 1; ++j)
          if (phi[i] < 0 && phi[j] >= 0)
            {
              const auto edge = simplex.corners[j] - simplex.corners[i];
              Zero<dim>  zero;
              zero.way = simplex.corners[i] + phi[i] / (phi[i] - phi[j]) * edge;
              zero.faces = division.faces[division.corners[s][j]];
              if (phi[j] > 0)
                zero.faces &= division.faces[division.corners[s][i]];
              points.push_back(zero);
            }
      if (points.size() == 4)
        std::swap(points[2], points[3]);
      return points;
    }



    /// Which faces of a cell end the domain, bit by bit.
    template <int dim>
    unsigned int
    boundary_faces(const CellGraph<dim> &graph, const unsigned int cell)
    {
      unsigned int faces = 0;
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        if (graph.at_boundary(cell, f))
          faces |= 1u << f;
      return faces;
    }



    template <int dim>
    Facet<dim>
    make_facet(const std::array<Zero<dim>, dim> &zeros,
               const ContourPatch<dim>          &patch)
    {
      Facet<dim> facet;
      facet.origin     = patch.vertices[0];
      unsigned int all = patch.boundary_faces;
      for (unsigned int i = 0; i < dim; ++i)
        {
          facet.corners[i] = zeros[i].way;
          all &= zeros[i].faces;
        }
      // A facet that lies in a face of the boundary as a whole does not go
      // on there.
      for (unsigned int i = 0; i < dim; ++i)
        {
          unsigned int side = patch.boundary_faces & ~all;
          for (unsigned int j = 0; j < dim; ++j)
            if (j != i)
              side &= zeros[j].faces;
          if (side != 0)
            facet.open_sides |= 1u << i;
        }
      return facet;
    }



    /// What a rank tells about one of its nodes.
    template <int dim>
    struct Message
    {
      dealii::types::global_dof_index node;
      ContourPatch<dim>               patch;
    };
  } // namespace



  template <int dim>
  std::vector<Facet<dim>>
  facets(const ContourPatch<dim> &patch)
  {
    auto vertices = patch.vertices;
    for (auto &vertex : vertices)
      vertex = dealii::Point<dim>(vertex - patch.vertices[0]);
    const auto simplices = SimplexCut::divide<dim>(vertices, patch.phi);
    std::vector<Facet<dim>> result;
    for (unsigned int s = 0; s < simplices.size(); ++s)
      {
        const auto points = zeros<dim>(simplices[s], s);
        for (unsigned int last = dim - 1; last < points.size(); ++last)
          {
            std::array<Zero<dim>, dim> corners;
            corners[0] = points[0];
            for (unsigned int i = 1; i < dim; ++i)
              corners[i] = points[last - (dim - 1) + i];
            result.push_back(make_facet<dim>(corners, patch));
          }
      }
    return result;
  }



  template <int dim>
  Contour<dim>::Contour(const NodeSpace<dim> &space, const Vector &phi)
    : space(space)
    , n_owned(phi.locally_owned_size())
    , of_node(n_owned + phi.get_partitioner()->n_ghost_indices())
  {
    collect(phi);
    update_ghosts();
    join_dependent_nodes();
  }



  template <int dim>
  unsigned int
  Contour<dim>::add(const ContourPatch<dim> &patch)
  {
    const auto of_patch = facets(patch);
    all_facets.insert(all_facets.end(), of_patch.begin(), of_patch.end());
    first_facet.push_back(all_facets.size());
    balls.push_back(ball_around(of_patch));
    patches.push_back(patch);
    return patches.size() - 1;
  }



  template <int dim>
  typename Contour<dim>::Ball
  Contour<dim>::ball_around(const std::vector<Facet<dim>> &of_patch) const
  {
    Ball ball;
    if (!of_patch.empty())
      ball.origin = of_patch.front().origin;
    for (const auto &facet : of_patch)
      for (const auto &corner : facet.corners)
        ball.center += corner / (dim * static_cast<double>(of_patch.size()));
    for (const auto &facet : of_patch)
      for (const auto &corner : facet.corners)
        ball.radius = facet.open_sides != 0
                        ? std::numeric_limits<double>::infinity()
                        : std::max(ball.radius, (corner - ball.center).norm());
    return ball;
  }



  template <int dim>
  void
  Contour<dim>::collect(const Vector &phi)
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      {
        ContourPatch<dim> patch;
        patch.phi = gather<dim>(phi, space.nodes(c));
        const auto [smallest, largest] =
          std::minmax_element(patch.phi.begin(), patch.phi.end());
        if (*smallest >= 0 || *largest < 0)
          continue;
        patch.cell           = graph.cell(c).global_index;
        patch.vertices       = graph.cell(c).vertices;
        patch.boundary_faces = boundary_faces(graph, c);
        const unsigned int p = add(patch);
        for (const unsigned int node : space.nodes(c))
          if (node < n_owned)
            of_node[node].push_back(p);
      }
  }



  template <int dim>
  void
  Contour<dim>::update_ghosts()
  {
    const auto &dofs = space.scalar();
    if (dealii::Utilities::MPI::n_mpi_processes(dofs.get_communicator()) == 1)
      return;

    const auto &partitioner = space.scalar_layout();
    std::map<unsigned int, std::vector<Message<dim>>> messages;
    auto         range    = partitioner.import_indices().begin();
    unsigned int in_range = 0;
    for (const auto &[rank, n] : partitioner.import_targets())
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int node = range->first + in_range++;
          for (const unsigned int p : of_node[node])
            messages[rank].push_back(
              {partitioner.local_to_global(node), patches[p]});
          if (range->first + in_range == range->second)
            {
              ++range;
              in_range = 0;
            }
        }

    for (unsigned int node = n_owned; node < of_node.size(); ++node)
      of_node[node].clear();
    std::map<dealii::types::global_cell_index, unsigned int> known;
    for (const auto &[rank, list] :
         send_plain(dofs.get_communicator(), messages))
      for (const auto &[node, patch] : list)
        {
          // Images in a periodic domain have their cell's number too.
          auto entry = known.find(patch.cell);
          if (entry == known.end() ||
              patches[entry->second].vertices[0] != patch.vertices[0])
            entry = known.insert_or_assign(patch.cell, add(patch)).first;
          of_node[partitioner.global_to_local(node)].push_back(entry->second);
        }
  }



  template <int dim>
  void
  Contour<dim>::tell(const unsigned int            from,
                     const unsigned int            to,
                     const dealii::Tensor<1, dim> &offset)
  {
    if (to >= n_owned)
      return;
    constexpr double same  = 1e-12;
    auto            &list  = of_node[to];
    const auto       known = of_node[from];
    for (const unsigned int p : known)
      {
        ContourPatch<dim> image = patches[p];
        for (auto &vertex : image.vertices)
          vertex += offset;
        const double size = image.vertices[0].distance(image.vertices.back());
        const auto   is_image = [&](const unsigned int other) {
          return patches[other].cell == image.cell &&
                 patches[other].vertices[0].distance(image.vertices[0]) <
                   same * size + coordinate_round_off(image.vertices[0]);
        };
        if (std::none_of(list.begin(), list.end(), is_image))
          list.push_back(offset == dealii::Tensor<1, dim>() ? p : add(image));
      }
  }



  template <int dim>
  void
  Contour<dim>::join_dependent_nodes()
  {
    // Through periodic boundaries first to the node that stands for the
    // others, then back; hanging nodes learn of the coarse cells beside them.
    for (const bool to_master : {true, false})
      {
        for (const auto &[node, master, weight] : space.dependences().all())
          {
            const auto masters    = space.hanging_masters(node);
            const bool is_hanging = masters.first != masters.second;
            if (!is_hanging)
              tell(to_master ? node : master,
                   to_master ? master : node,
                   (to_master ? 1. : -1.) *
                     (space.position(master) - space.position(node)));
            else if (!to_master)
              tell(master, node, dealii::Tensor<1, dim>());
          }
        update_ghosts();
      }
  }



  template <int dim>
  void
  Contour<dim>::find_nearest(const unsigned int        patch,
                             const dealii::Point<dim> &x,
                             FacetDistance            &nearest) const
  {
    if (balls[patch].distance(x) >= nearest.distance)
      return;
    for (unsigned int f = first_facet[patch]; f < first_facet[patch + 1]; ++f)
      if (distance_bound(all_facets[f], x) < nearest.distance)
        {
          const auto here = distance<dim>(all_facets[f], x);
          if (here.distance < nearest.distance)
            nearest = here;
        }
  }



  template <int dim>
  void
  Contour<dim>::collect_nearest(const unsigned int        patch,
                                const dealii::Point<dim> &x,
                                const FacetDistance      &nearest,
                                std::vector<Facet<dim>>  &facets) const
  {
    const double limit = (1. + same_distance) * nearest.distance;
    if (balls[patch].distance(x) > limit)
      return;
    for (unsigned int f = first_facet[patch]; f < first_facet[patch + 1]; ++f)
      if (distance_bound(all_facets[f], x) <= limit &&
          distance<dim>(all_facets[f], x).distance <= limit)
        facets.push_back(all_facets[f]);
  }



  template std::vector<Facet<2>>
  facets<2>(const ContourPatch<2> &);
  template std::vector<Facet<3>>
  facets<3>(const ContourPatch<3> &);
  THALWEG_INSTANTIATE(Contour)
} // namespace Thalweg
