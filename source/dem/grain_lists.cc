// SPDX-License-Identifier: LGPL-2.1-or-later
// How the lists of a GrainSystem are made.
#include <thalweg/core/send_plain.h>
#include <thalweg/dem/grain_system.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace Thalweg
{
  namespace
  {
    /// A grain's number and, in sets that travel, how much belongs to it.
    struct TravellingGrain
    {
      GrainRecord   grain;
      std::uint32_t n_contacts, n_walls;
    };



    /// Sends grains with all that they remember. Collective.
    /// @param to the rank of each grain of @p set
    /// @return those that came
    GrainSet
    send_grains(const MPI_Comm                 communicator,
                const GrainSet                &set,
                const std::vector<GrainOwner> &to,
                const int                      rank)
    {
      std::map<unsigned int, std::vector<TravellingGrain>> grains;
      std::map<unsigned int, std::vector<ContactRecord>>   contacts;
      std::map<unsigned int, std::vector<WallMemory>>      walls;
      for (std::size_t g = 0; g < set.grains.size(); ++g)
        if (to[g].rank >= 0 && to[g].rank != rank)
          {
            const unsigned int r    = to[g].rank;
            GrainRecord        sent = set.grains[g];
            sent.cell               = to[g].cell;
            const auto &begin       = set.contacts.begin;
            grains[r].push_back({sent,
                                 begin[g + 1] - begin[g],
                                 set.wall_begin[g + 1] - set.wall_begin[g]});
            for (std::uint32_t c = begin[g]; c < begin[g + 1]; ++c)
              contacts[r].push_back(set.contacts.contacts[c]);
            for (std::uint32_t w = set.wall_begin[g]; w < set.wall_begin[g + 1];
                 ++w)
              walls[r].push_back(set.walls[w]);
          }
      const auto came          = send_plain(communicator, grains);
      auto       came_contacts = send_plain(communicator, contacts);
      auto       came_walls    = send_plain(communicator, walls);
      GrainSet   result;
      for (const auto &[r, list] : came)
        {
          const ContactRecord *contact = came_contacts[r].data();
          const WallMemory    *wall    = came_walls[r].data();
          for (const auto &[grain, n_contacts, n_walls] : list)
            {
              result.append(grain, contact, n_contacts, wall, n_walls);
              contact += n_contacts;
              wall += n_walls;
            }
        }
      return result;
    }



    /// What grains of all ranks have in common.
    GrainExtent
    extent_of(const MPI_Comm communicator, const std::vector<GrainRecord> &own)
    {
      constexpr double far = std::numeric_limits<double>::max();
      // Minima: places, minus places, radius, minus radius.
      double ends[8] = {far, far, far, far, far, far, far, far};
      for (const GrainRecord &grain : own)
        {
          const double values[8] = {grain.reference.x,
                                    grain.reference.y,
                                    grain.reference.z,
                                    -grain.reference.x,
                                    -grain.reference.y,
                                    -grain.reference.z,
                                    grain.r,
                                    -grain.r};
          for (unsigned int k = 0; k < 8; ++k)
            ends[k] = std::min(ends[k], values[k]);
        }
      MPI_Allreduce(MPI_IN_PLACE, ends, 8, MPI_DOUBLE, MPI_MIN, communicator);
      if (ends[6] == far)
        return {{0., 0., 0.}, {1., 1., 1.}, .1, .1};
      return {{ends[0], ends[1], ends[2]},
              {-ends[3], -ends[4], -ends[5]},
              ends[6],
              -ends[7]};
    }



    /// The order of grains by the keys of their cells and their numbers, images
    /// behind.
    struct Ordered
    {
      GrainCells::Key key;
      std::uint64_t   id;
      std::uint32_t   image;
      std::uint32_t   source; ///< own ones first, then the halo

      bool
      operator<(const Ordered &other) const
      {
        if (key != other.key)
          return key < other.key;
        if (id != other.id)
          return id < other.id;
        return image < other.image;
      }
    };
  } // namespace



  void
  GrainSystem::distribute(GrainSet &set)
  {
    std::vector<GrainPlace> places;
    for (const GrainRecord &grain : set.grains)
      places.push_back({grain.reference, grain.r});
    std::vector<GrainOwner> owners = locator->locate(places);
    int                     rank;
    MPI_Comm_rank(communicator, &rank);
    bool changes = false;
    for (std::size_t g = 0; g < owners.size(); ++g)
      {
        if (owners[g].rank < 0)
          gone.push_back({set.grains[g],
                          owners[g].boundary,
                          owners[g].rank == GrainOwner::lost});
        if (owners[g].rank == rank)
          set.grains[g].cell = owners[g].cell;
        else
          changes = true;
      }
    const GrainSet came =
      n_ranks > 1 ? send_grains(communicator, set, owners, rank) : GrainSet();
    if (!changes && came.grains.empty())
      return;
    GrainSet result;
    for (std::size_t g = 0; g < owners.size(); ++g)
      if (owners[g].rank == rank)
        result.append(set, g);
    for (std::size_t g = 0; g < came.grains.size(); ++g)
      result.append(came, g);
    std::swap(set, result);
  }



  void
  GrainSystem::arrange(const GrainSet &set)
  {
    const std::size_t   n_own  = set.grains.size();
    const GrainExtent   extent = extent_of(communicator, set.grains);
    std::vector<double> inverse_mass(n_own);
    skin         = settings.skin * extent.smallest;
    inner_margin = settings.inner_margin * skin;
    linked_cells.set_up(extent, skin);
    for (std::size_t g = 0; g < n_own; ++g)
      inverse_mass[g] = 1. / mass(set.grains[g].material, set.grains[g].r);
    const std::vector<HaloGrain> others =
      halo.make(set.grains, inverse_mass, skin);

    std::vector<Ordered> order;
    order.reserve(n_own + others.size());
    for (const GrainRecord &g : set.grains)
      order.push_back({linked_cells.key(g.reference, g.r),
                       g.id,
                       0,
                       static_cast<std::uint32_t>(order.size())});
    for (const HaloGrain &g : others)
      order.push_back({linked_cells.key(g.reference, g.r),
                       g.id,
                       g.image,
                       static_cast<std::uint32_t>(order.size())});
    std::sort(order.begin(), order.end());

    const std::size_t n = order.size();
    arrays.resize(n);
    std::vector<GrainCells::Key> key(n);
    std::vector<std::int32_t>    row(n, -1);
    std::vector<std::uint32_t> own(n_own), of_halo(others.size()), rows_of_own;
    own_places.clear();
    own_cells.clear();
    for (std::size_t i = 0; i < n; ++i)
      {
        key[i]                     = order[i].key;
        const std::uint32_t source = order[i].source;
        arrays.own[i]              = source < n_own;
        if (source < n_own)
          {
            set_own(i, set.grains[source], inverse_mass[source]);
            row[i]      = source;
            own[source] = i;
            rows_of_own.push_back(source);
          }
        else
          {
            set_halo(i, others[source - n_own]);
            of_halo[source - n_own] = i;
          }
      }
    halo.set_places(own, of_halo);
    find_at_references(key);
    make_contacts(set, row, rows_of_own);
  }



  void
  GrainSystem::set_own(const std::size_t  i,
                       const GrainRecord &g,
                       const double       inverse_mass)
  {
    const Vec3 nothing{0., 0., 0.};
    arrays.place[i]  = {g.x, g.r};
    arrays.motion[i] = {is_in_step ? g.force : g.v,
                        inverse_mass,
                        is_in_step ? g.torque : g.w,
                        0.};
    arrays.load[i] = {is_in_step ? nothing : g.force,
                      0.,
                      is_in_step ? nothing : g.torque,
                      0.};
    const double inverse_inertia =
      settings.spins ? inverse_mass / (inertia_factor() * g.r * g.r) : 0.;
    arrays.momentum[i]  = {g.v, inverse_mass, g.w, inverse_inertia};
    arrays.reference[i] = g.reference;
    arrays.id[i]        = g.id;
    arrays.material[i]  = g.material;
    own_places.push_back(i);
    own_cells.push_back(g.cell);
  }



  void
  GrainSystem::set_halo(const std::size_t i, const HaloGrain &g)
  {
    const Vec3 nothing{0., 0., 0.};
    arrays.place[i]     = {g.x, g.r};
    arrays.motion[i]    = {g.v, g.inverse_mass, g.w, 0.};
    arrays.load[i]      = {nothing, 0., nothing, 0.};
    arrays.reference[i] = g.reference;
    arrays.id[i]        = g.id;
    arrays.material[i]  = g.material;
  }



  void
  GrainSystem::find_at_references(const std::vector<GrainCells::Key> &key)
  {
    // Lists do not depend on where grains have gone since.
    std::vector<GrainPlace> now(arrays.place);
    for (std::size_t i = 0; i < arrays.size(); ++i)
      arrays.place[i].x = arrays.reference[i];
    find_pairs(linked_cells, arrays.place, key, arrays.own, skin, neighbours);
    walls.place_facets(&MovingWall::reference);
    wall_list.make(arrays, walls, skin);
    arrays.place.swap(now);
    walls.place_facets(&MovingWall::now);
    moving_facets = walls.moving_among(wall_list.facet);
  }



  void
  GrainSystem::make_contacts(const GrainSet                   &set,
                             const std::vector<std::int32_t>  &row,
                             const std::vector<std::uint32_t> &order_of_own)
  {
    near.clear(arrays.size());
    halo.refresh(arrays);
    prune();
    near.remember(arrays.id, row, set.contacts);
    std::size_t o = 0;
    for (std::size_t w = 0; w < wall_list.grain.size(); ++w)
      {
        while (own_places[o] != wall_list.grain[w])
          ++o;
        const std::uint32_t g = order_of_own[o];
        wall_list.remember(w,
                           set.walls.data() + set.wall_begin[g],
                           set.wall_begin[g + 1] - set.wall_begin[g]);
      }
  }
} // namespace Thalweg
