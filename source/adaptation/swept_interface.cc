// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/swept_interface.h>
#include <thalweg/core/send_plain.h>
#include <thalweg/interface/contour.h>
#include <thalweg/postprocess/cell_access.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// No interface is followed farther than this, in steps of a finest cell.
    constexpr double most_pieces = 500.;



    /// A box as plain memory.
    template <int dim>
    using Corners = std::array<dealii::Point<dim>, 2>;



    template <int dim>
    Corners<dim>
    nothing()
    {
      Corners<dim> box;
      for (unsigned int d = 0; d < dim; ++d)
        {
          box[0][d] = std::numeric_limits<double>::max();
          box[1][d] = std::numeric_limits<double>::lowest();
        }
      return box;
    }



    template <int dim>
    void
    include(Corners<dim> &box, const dealii::Point<dim> &x)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          box[0][d] = std::min(box[0][d], x[d]);
          box[1][d] = std::max(box[1][d], x[d]);
        }
    }



    template <int dim>
    bool
    touch(const Corners<dim> &a, const Corners<dim> &b, const double margin)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (a[0][d] > b[1][d] + margin || b[0][d] > a[1][d] + margin)
          return false;
      return true;
    }



    /// Around the interface in a cell, which must be cut.
    template <int dim>
    Corners<dim>
    piece_in_cell(const CellGraph<dim>                 &graph,
                  const unsigned int                    c,
                  const std::array<double, (1 << dim)> &phi)
    {
      ContourPatch<dim> patch;
      patch.cell           = graph.cell(c).global_index;
      patch.vertices       = graph.cell(c).vertices;
      patch.phi            = phi;
      patch.boundary_faces = 0;
      Corners<dim> box     = nothing<dim>();
      for (const Facet<dim> &facet : facets(patch))
        for (const auto &corner : facet.corners)
          include(box, facet.origin + corner);
      return box;
    }



    /// Around the particles in a cell that the level set does not cut which
    /// belong to the other fluid: threads and drops that are thinner than the
    /// cell; nothing if there are none.
    template <int dim>
    Corners<dim>
    strays_in_cell(const FlowView<dim> &solution,
                   const unsigned int   c,
                   const bool           is_negative)
    {
      Corners<dim> box = nothing<dim>();
      for (const auto &particle : solution.population.in_cell(c))
        if ((Population<dim>::fluid_of(particle.properties()) == 0) !=
            is_negative)
          include(box, particle.position());
      return box;
    }



    template <int dim>
    dealii::Tensor<1, dim>
    mean_velocity(const FlowView<dim> &solution, const unsigned int cell)
    {
      const auto            &nodes = solution.space.nodes(cell);
      dealii::Tensor<1, dim> sum;
      for (const unsigned int node : nodes)
        for (unsigned int d = 0; d < dim; ++d)
          sum[d] += solution.velocity.local_element(dim * node + d);
      return sum / static_cast<double>(nodes.size());
    }



    /// The boxes of this process's cut cells, with those along their way.
    template <int dim>
    std::vector<Corners<dim>>
    own_pieces(const FlowView<dim> &solution,
               const LevelRange    &levels,
               const double         time)
    {
      const CellGraph<dim>     &graph = solution.mesh.graph();
      std::vector<Corners<dim>> pieces;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto phi = cell_level_set(solution, c);
          const auto [smallest, largest] =
            std::minmax_element(phi.begin(), phi.end());
          const bool         is_cut = *smallest < 0 && *largest >= 0;
          const Corners<dim> piece =
            is_cut ? piece_in_cell(graph, c, phi)
                   : strays_in_cell(solution, c, *largest < 0);
          if (piece[0][0] > piece[1][0])
            continue;
          const dealii::Tensor<1, dim> way = time * mean_velocity(solution, c);
          const double       step = edge_on_level(graph, c, levels.maximum);
          const unsigned int n =
            std::ceil(std::min(way.norm() / step, most_pieces));
          pieces.push_back(piece);
          for (unsigned int i = 0; i < n; ++i)
            {
              Corners<dim> moved = nothing<dim>();
              for (const double part : {i / double(n), (i + 1.) / n})
                for (const auto &corner : piece)
                  include(moved, corner + part * way);
              pieces.push_back(moved);
            }
        }
      return pieces;
    }



    /// How far the images of a periodic domain lie from it, and that it
    /// belongs to them itself.
    template <int dim>
    std::vector<dealii::Tensor<1, dim>>
    image_offsets(const Mesh<dim> &mesh)
    {
      std::vector<dealii::Tensor<1, dim>> offsets(1);
      for (const auto &pair : mesh.periodic_pairs())
        {
          dealii::Tensor<1, dim> way;
          double                 place[2] = {0., 0.};
          for (const auto &cell :
               mesh.triangulation().cell_iterators_on_level(0))
            for (const unsigned int f : cell->face_indices())
              if (cell->at_boundary(f))
                for (const unsigned int side : {0, 1})
                  if (cell->face(f)->boundary_id() ==
                      (side == 0 ? pair.first : pair.second))
                    place[side] = cell->face(f)->center()[pair.direction];
          way[pair.direction] = place[1] - place[0];
          const std::size_t n = offsets.size();
          for (std::size_t i = 0; i < n; ++i)
            for (const double sign : {-1., 1.})
              offsets.push_back(offsets[i] + sign * way);
        }
      return offsets;
    }



    /// Sends pieces and their images to the processes within @p margin.
    template <int dim>
    std::vector<Corners<dim>>
    distribute(const Mesh<dim>                 &mesh,
               const std::vector<Corners<dim>> &pieces,
               const double                     margin)
    {
      const MPI_Comm communicator = mesh.triangulation().get_communicator();
      Corners<dim>   own          = nothing<dim>();
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        for (const auto &vertex : mesh.graph().cell(c).vertices)
          include(own, vertex);
      const auto domains =
        dealii::Utilities::MPI::all_gather(communicator, own);

      std::map<unsigned int, std::vector<Corners<dim>>> to_send;
      for (const auto &offset : image_offsets(mesh))
        {
          std::vector<Corners<dim>> images     = pieces;
          Corners<dim>              all_pieces = nothing<dim>();
          for (auto &image : images)
            for (auto &corner : image)
              {
                corner += offset;
                include(all_pieces, corner);
              }
          for (unsigned int rank = 0; rank < domains.size(); ++rank)
            if (touch(domains[rank], all_pieces, margin))
              for (const auto &image : images)
                if (touch(domains[rank], image, margin))
                  to_send[rank].push_back(image);
        }
      std::vector<Corners<dim>> all;
      for (const auto &[rank, list] : send_plain(communicator, to_send))
        all.insert(all.end(), list.begin(), list.end());
      return all;
    }



    template <int dim>
    double
    distance_square(const dealii::BoundingBox<dim> &a,
                    const dealii::BoundingBox<dim> &b)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double between =
            std::max({0.,
                      a.lower_bound(d) - b.upper_bound(d),
                      b.lower_bound(d) - a.upper_bound(d)});
          sum += between * between;
        }
      return sum;
    }
  } // namespace



  template <int dim>
  struct SweptInterface<dim>::Tree
  {
    dealii::RTree<Box> boxes;
  };



  template <int dim>
  SweptInterface<dim>::SweptInterface(const FlowView<dim> &solution,
                                      const LevelRange    &levels,
                                      const double         time,
                                      const double         reach)
    : tree(std::make_unique<Tree>())
  {
    if (solution.fluids.size() < 2)
      return;
    const CellGraph<dim> &graph   = solution.mesh.graph();
    double                longest = 0.;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      longest = std::max(longest, edge_on_level(graph, c, levels.maximum));
    longest = dealii::Utilities::MPI::max(
      longest, solution.mesh.triangulation().get_communicator());

    std::vector<Box> boxes;
    // Half as far again, since cells of one parent differ in size.
    for (const auto &[lower, upper] :
         distribute(solution.mesh,
                    own_pieces(solution, levels, time),
                    1.5 * reach * longest))
      boxes.emplace_back(std::make_pair(lower, upper));
    tree->boxes = dealii::pack_rtree(boxes);
  }



  template <int dim>
  SweptInterface<dim>::~SweptInterface() = default;



  template <int dim>
  bool
  SweptInterface<dim>::is_near(const Box &box, const double distance) const
  {
    namespace bgi = boost::geometry::index;
    Box wide      = box;
    wide.extend(distance);
    const auto is_within = [&](const Box &piece) {
      return distance_square(piece, box) <= distance * distance;
    };
    return tree->boxes.qbegin(bgi::intersects(wide) &&
                              bgi::satisfies(is_within)) != tree->boxes.qend();
  }



  template <int dim>
  double
  edge_on_level(const CellGraph<dim> &graph,
                const unsigned int    cell,
                const unsigned int    level)
  {
    return graph.cell(cell).edges().second *
           std::exp2(graph.iterator(cell)->level() - static_cast<int>(level));
  }



  THALWEG_INSTANTIATE(SweptInterface)
  template double
  edge_on_level<2>(const CellGraph<2> &,
                   const unsigned int,
                   const unsigned int);
  template double
  edge_on_level<3>(const CellGraph<3> &,
                   const unsigned int,
                   const unsigned int);
} // namespace Thalweg
