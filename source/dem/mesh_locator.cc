// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/core/send_plain.h>
#include <thalweg/dem/mesh_locator.h>
#include <thalweg/dem/points.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Sides of cells are as thick as this part of the mesh's size.
    constexpr double thickness = 1e-12;
  } // namespace



  template <int dim>
  MeshLocator<dim>::MeshLocator(const Mesh<dim>                  &mesh,
                                const std::vector<BoundaryFacet> &boundary,
                                const std::set<unsigned int>     &open)
    : mesh(mesh)
    , boundary(boundary)
    , open(open)
    , size(mesh.box().first.distance(mesh.box().second))
  {
    for (const BoundaryFacet &side : boundary)
      {
        facets.push_back(side.facet);
        facets.back().is_solid = false;
      }
    fill_bins();
    int n_ranks;
    MPI_Comm_size(mesh.triangulation().get_communicator(), &n_ranks);
    std::vector<double> own(2 * dim);
    for (unsigned int d = 0; d < dim; ++d)
      {
        own[d]       = lower[d];
        own[dim + d] = upper[d];
      }
    rank_boxes.resize(2 * dim * n_ranks);
    MPI_Allgather(own.data(),
                  2 * dim,
                  MPI_DOUBLE,
                  rank_boxes.data(),
                  2 * dim,
                  MPI_DOUBLE,
                  mesh.triangulation().get_communicator());
  }



  template <int dim>
  void
  MeshLocator<dim>::fill_bins()
  {
    const CellGraph<dim> &graph = mesh.graph();
    const unsigned int    n     = graph.n_owned_cells();
    const double          far   = std::numeric_limits<double>::max();
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = far;
        upper[d] = -far;
      }
    for (unsigned int c = 0; c < n; ++c)
      {
        const auto &cell = graph.cell(c);
        auto        low = cell.vertices[0], high = low;
        for (const auto &vertex : cell.vertices)
          for (unsigned int d = 0; d < dim; ++d)
            {
              low[d]  = std::min(low[d], vertex[d]);
              high[d] = std::max(high[d], vertex[d]);
            }
        for (unsigned int d = 0; d < dim; ++d)
          {
            low[d] -= thickness * size;
            high[d] += thickness * size;
            lower[d] = std::min(lower[d], low[d]);
            upper[d] = std::max(upper[d], high[d]);
          }
        boxes.emplace_back(low, high);
        shapes.push_back(cell.axis_parallel
                           ? typename CellMaps<dim>::Polynomial()
                           : CellMaps<dim>::shape_of(cell));
      }
    std::size_t  n_all  = 1;
    const double along  = std::pow(4. * n + 1., 1. / dim);
    double       volume = 1.;
    for (unsigned int d = 0; d < dim && n > 0; ++d)
      volume *= upper[d] - lower[d];
    const double mean = std::pow(volume, 1. / dim);
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_bins[d] =
          n == 0 ? 1
                 : 1 + static_cast<std::size_t>(
                         std::min(1000., along * (upper[d] - lower[d]) / mean));
        n_all *= n_bins[d];
      }
    bins.resize(n_all);
    for (unsigned int c = 0; c < n; ++c)
      {
        // All bins between those of the two corners.
        std::array<std::size_t, dim> first, last, at;
        std::size_t                  b0 = bin(boxes[c].first);
        std::size_t                  b1 = bin(boxes[c].second);
        for (unsigned int d = 0; d < dim; ++d)
          {
            first[d] = b0 % n_bins[d];
            last[d]  = b1 % n_bins[d];
            b0 /= n_bins[d];
            b1 /= n_bins[d];
          }
        at = first;
        for (bool more = true; more;)
          {
            std::size_t index = 0;
            for (int d = dim - 1; d >= 0; --d)
              index = index * n_bins[d] + at[d];
            bins[index].push_back(c);
            more = false;
            for (unsigned int d = 0; d < dim && !more; ++d)
              if (at[d] < last[d])
                {
                  ++at[d];
                  more = true;
                }
              else
                at[d] = first[d];
          }
      }
  }



  template <int dim>
  std::size_t
  MeshLocator<dim>::bin(const dealii::Point<dim> &x) const
  {
    std::size_t index = 0;
    for (int d = dim - 1; d >= 0; --d)
      {
        const double part = (x[d] - lower[d]) / (upper[d] - lower[d]);
        const double at   = std::floor(part * n_bins[d]);
        index =
          index * n_bins[d] +
          static_cast<std::size_t>(std::min(std::max(at, 0.), n_bins[d] - 1.));
      }
    return index;
  }



  template <int dim>
  bool
  MeshLocator<dim>::is_in(const std::uint32_t c, const Vec3 &place) const
  {
    const auto x = as_point<dim>(place);
    for (unsigned int d = 0; d < dim; ++d)
      if (x[d] < boxes[c].first[d] || x[d] > boxes[c].second[d])
        return false;
    const auto &cell = mesh.graph().cell(c);
    if (cell.axis_parallel)
      return true;
    typename CellMaps<dim>::Coordinates way, reference;
    for (unsigned int d = 0; d < dim; ++d)
      way[d] = x[d] - cell.vertices[0][d];
    if (!CellMaps<dim>::find_reference(shapes[c], way, reference))
      return false;
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(reference[d] - .5) > .5 + 1e-9)
        return false;
    return true;
  }



  template <int dim>
  std::uint32_t
  MeshLocator<dim>::find_here(const Vec3 &place) const
  {
    const auto x = as_point<dim>(place);
    for (unsigned int d = 0; d < dim; ++d)
      if (!(x[d] >= lower[d] && x[d] <= upper[d]))
        return nowhere;
    for (const std::uint32_t c : bins[bin(x)])
      if (is_in(c, place))
        return c;
    return nowhere;
  }



  template <int dim>
  void
  MeshLocator<dim>::ask_others(const std::vector<Vec3> &places,
                               std::vector<GrainOwner> &owners) const
  {
    const MPI_Comm     communicator = mesh.triangulation().get_communicator();
    const unsigned int n_ranks      = rank_boxes.size() / (2 * dim);
    if (n_ranks == 1)
      return;
    struct Question
    {
      std::uint32_t number, cell;
      Vec3          x;
    };
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    std::map<unsigned int, std::vector<Question>> questions, answers;
    for (std::uint32_t i = 0; i < places.size(); ++i)
      if (owners[i].rank < 0)
        for (unsigned int r = 0; r < n_ranks; ++r)
          {
            const auto    x   = as_point<dim>(places[i]);
            const double *box = rank_boxes.data() + 2 * dim * r;
            bool          may = r != rank;
            for (unsigned int d = 0; d < dim; ++d)
              may = may && x[d] >= box[d] && x[d] <= box[dim + d];
            if (may)
              questions[r].push_back({i, nowhere, places[i]});
          }
    for (auto &[r, list] : send_plain(communicator, questions))
      for (Question question : list)
        {
          question.cell = find_here(question.x);
          if (question.cell != nowhere)
            answers[r].push_back(question);
        }
    // In the order of the ranks: the first one that has it.
    for (const auto &[r, list] : send_plain(communicator, answers))
      for (const Question &answer : list)
        if (owners[answer.number].rank < 0)
          owners[answer.number] = {static_cast<int>(r), answer.cell};
  }



  template <int dim>
  std::vector<GrainOwner>
  MeshLocator<dim>::locate(const std::vector<GrainPlace> &places) const
  {
    const int rank = dealii::Utilities::MPI::this_mpi_process(
      mesh.triangulation().get_communicator());
    std::vector<GrainOwner> owners(places.size(), {GrainOwner::lost, nowhere});
    std::vector<Vec3>       at(places.size());
    const auto              look = [&]() {
      for (std::size_t i = 0; i < places.size(); ++i)
        if (owners[i].rank < 0)
          if (const auto cell = find_here(at[i]); cell != nowhere)
            owners[i] = {rank, cell};
      ask_others(at, owners);
    };
    for (std::size_t i = 0; i < places.size(); ++i)
      at[i] = places[i].x;
    look();
    // Those outside belong to the nearest place of the boundary.
    std::vector<std::size_t> gone;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (owners[i].rank < 0)
        {
          double      nearest = std::numeric_limits<double>::max();
          std::size_t face    = 0;
          for (std::size_t f = 0; f < facets.size(); ++f)
            if (const double distance = distance_from(facets[f], at[i]);
                distance < nearest)
              {
                nearest = distance;
                face    = f;
              }
          if (open.count(boundary[face].boundary) > 0)
            owners[i] = {GrainOwner::left, nowhere, boundary[face].boundary};
          else if (nearest > 2. * places[i].r)
            owners[i].boundary = boundary[face].boundary;
          else
            {
              bool       is_inside;
              const Vec3 foot =
                nearest_in_polygon(facets[face], at[i], is_inside);
              at[i] = foot + (.5 * thickness * size) * facets[face].normal;
              continue;
            }
          gone.push_back(i);
        }
    std::vector<GrainOwner> of_gone;
    for (const std::size_t i : gone)
      {
        of_gone.push_back(owners[i]);
        // Nobody has these.
        at[i] = {std::nan(""), 0., 0.};
      }
    look();
    for (std::size_t k = 0; k < gone.size(); ++k)
      owners[gone[k]] = of_gone[k];
    return owners;
  }



  template <int dim>
  std::vector<char>
  MeshLocator<dim>::have_room(const std::vector<GrainPlace> &places) const
  {
    double largest = 0.;
    for (const GrainPlace &place : places)
      largest = std::max(largest, place.r);
    const FacetFinder          finder(facets, largest);
    std::vector<char>          room(places.size(), 0);
    std::vector<std::uint32_t> near;
    for (std::size_t i = 0; i < places.size(); ++i)
      {
        if (find_here(places[i].x) == nowhere)
          continue;
        near.clear();
        finder.append_near(places[i].x, places[i].r * (1. - 1e-9), near);
        room[i] = std::none_of(near.begin(), near.end(), [&](const auto f) {
          return open.count(boundary[f].boundary) == 0;
        });
      }
    MPI_Allreduce(MPI_IN_PLACE,
                  room.data(),
                  room.size(),
                  MPI_CHAR,
                  MPI_MAX,
                  mesh.triangulation().get_communicator());
    return room;
  }



  template <int dim>
  Vec3
  MeshLocator<dim>::wrap(const Vec3 &x) const
  {
    Vec3       shift{0., 0., 0.};
    const auto at = as_point<dim>(x);
    for (const PeriodicPair &pair : mesh.periodic_pairs())
      {
        const unsigned int d    = pair.direction;
        const double       low  = mesh.box().first[d];
        const double       high = mesh.box().second[d];
        const double       way  = at[d] < low     ? high - low
                                  : at[d] >= high ? low - high
                                                  : 0.;
        (d == 0 ? shift.x : d == 1 ? shift.y : shift.z) = way;
      }
    return shift;
  }



  template <int dim>
  std::vector<Vec3>
  MeshLocator<dim>::shifts(const Mesh<dim> &mesh)
  {
    std::vector<Vec3> all{{0., 0., 0.}};
    for (const PeriodicPair &pair : mesh.periodic_pairs())
      {
        const unsigned int d      = pair.direction;
        const double       length = mesh.box().second[d] - mesh.box().first[d];
        const std::size_t  before = all.size();
        for (const double sign : {-1., 1.})
          for (std::size_t s = 0; s < before; ++s)
            {
              Vec3 shift                                      = all[s];
              (d == 0 ? shift.x : d == 1 ? shift.y : shift.z) = sign * length;
              all.push_back(shift);
            }
      }
    all.erase(all.begin());
    return all;
  }



  THALWEG_INSTANTIATE(MeshLocator)
} // namespace Thalweg
