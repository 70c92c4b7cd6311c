// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/send_plain.h>
#include <thalweg/dem/halo.h>

#include <algorithm>
#include <map>

namespace Thalweg
{
  namespace
  {
    /// Boxes a rank has, so that few grains are sent that nobody needs.
    constexpr std::size_t most_boxes = 32;
    constexpr int         halo_tag   = 17;

    void
    enclose(Vec3 &lower, Vec3 &upper, const Vec3 &x)
    {
      lower = {std::min(lower.x, x.x),
               std::min(lower.y, x.y),
               std::min(lower.z, x.z)};
      upper = {std::max(upper.x, x.x),
               std::max(upper.y, x.y),
               std::max(upper.z, x.z)};
    }



    /// The square of the distance of a place from a box, m^2.
    double
    distance_square(const Vec3 &lower, const Vec3 &upper, const Vec3 &x)
    {
      const auto outside =
        [](const double low, const double high, const double at) {
          return std::max({0., low - at, at - high});
        };
      return norm_square({outside(lower.x, upper.x, x.x),
                          outside(lower.y, upper.y, x.y),
                          outside(lower.z, upper.z, x.z)});
    }
  } // namespace



  Halo::Halo(const MPI_Comm communicator, const std::vector<Vec3> &shifts_)
    : communicator(communicator)
    , shifts{{0., 0., 0.}}
  {
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);
    shifts.insert(shifts.end(), shifts_.begin(), shifts_.end());
  }



  std::vector<Halo::Box>
  Halo::boxes_around(const std::vector<GrainRecord> &own)
  {
    std::vector<Box> boxes;
    if (own.empty())
      return boxes;
    boxes.push_back({own[0].reference, own[0].reference, 0.});
    const std::size_t per_box = (own.size() + most_boxes - 1) / most_boxes;
    for (std::size_t i = 0; i < own.size(); ++i)
      {
        if (i % per_box == 0)
          boxes.push_back({own[i].reference, own[i].reference, 0.});
        for (Box *box : {&boxes.front(), &boxes.back()})
          {
            enclose(box->lower, box->upper, own[i].reference);
            box->largest = std::max(box->largest, own[i].r);
          }
      }
    return boxes;
  }



  void
  Halo::select(const std::vector<GrainRecord> &own,
               const std::vector<Box>         &boxes,
               const std::vector<int>         &begin,
               const double                    skin)
  {
    neighbours.clear();
    for (int r = 0; r < n_ranks; ++r)
      {
        Neighbour neighbour{r, {}, 0, 0, {}, {}};
        for (std::uint32_t s = r == rank ? 1 : 0; s < shifts.size(); ++s)
          for (std::uint32_t i = 0; i < own.size(); ++i)
            {
              const Vec3 x       = own[i].reference + shifts[s];
              const auto is_near = [&](const Box &box) {
                const double reach = own[i].r + box.largest + skin;
                return distance_square(box.lower, box.upper, x) <=
                       reach * reach;
              };
              if (begin[r] == begin[r + 1] || !is_near(boxes[begin[r]]))
                continue;
              if (std::any_of(boxes.begin() + begin[r] + 1,
                              boxes.begin() + begin[r + 1],
                              is_near))
                neighbour.sent.push_back({i, s});
            }
        neighbours.push_back(neighbour);
      }
  }



  std::vector<HaloGrain>
  Halo::make(const std::vector<GrainRecord> &own,
             const std::vector<double>      &inverse_mass,
             const double                    skin)
  {
    halo_places.clear();
    neighbours.clear();
    if (n_ranks == 1 && shifts.size() == 1)
      return {};
    const std::vector<Box> own_boxes = boxes_around(own);
    const int              n_bytes   = own_boxes.size() * sizeof(Box);
    std::vector<int>       bytes(n_ranks), begin_bytes(n_ranks + 1, 0);
    MPI_Allgather(&n_bytes, 1, MPI_INT, bytes.data(), 1, MPI_INT, communicator);
    for (int r = 0; r < n_ranks; ++r)
      begin_bytes[r + 1] = begin_bytes[r] + bytes[r];
    std::vector<Box> boxes(begin_bytes[n_ranks] / sizeof(Box));
    MPI_Allgatherv(own_boxes.data(),
                   n_bytes,
                   MPI_BYTE,
                   boxes.data(),
                   bytes.data(),
                   begin_bytes.data(),
                   MPI_BYTE,
                   communicator);
    for (int &begin : begin_bytes)
      begin /= sizeof(Box);
    select(own, boxes, begin_bytes, skin);
    std::map<unsigned int, std::vector<HaloGrain>> to_send;
    for (const Neighbour &neighbour : neighbours)
      for (const Sent &sent : neighbour.sent)
        {
          const GrainRecord &g     = own[sent.grain];
          const Vec3        &shift = shifts[sent.image];
          to_send[neighbour.rank].push_back({g.id,
                                             g.x + shift,
                                             g.v,
                                             g.w,
                                             g.reference + shift,
                                             g.r,
                                             inverse_mass[sent.grain],
                                             g.material,
                                             sent.image});
        }
    const auto             received = send_plain(communicator, to_send);
    std::vector<HaloGrain> all;
    for (Neighbour &neighbour : neighbours)
      {
        neighbour.begin_received = all.size();
        const auto list          = received.find(neighbour.rank);
        if (list != received.end())
          all.insert(all.end(), list->second.begin(), list->second.end());
        neighbour.n_received = all.size() - neighbour.begin_received;
        neighbour.to_send.resize(neighbour.sent.size());
        neighbour.received.resize(neighbour.n_received);
      }
    neighbours.erase(std::remove_if(neighbours.begin(),
                                    neighbours.end(),
                                    [](const Neighbour &neighbour) {
                                      return neighbour.sent.empty() &&
                                             neighbour.n_received == 0;
                                    }),
                     neighbours.end());
    return all;
  }



  void
  Halo::set_places(const std::vector<std::uint32_t> &own,
                   const std::vector<std::uint32_t> &halo)
  {
    for (Neighbour &neighbour : neighbours)
      for (Sent &sent : neighbour.sent)
        sent.grain = own[sent.grain];
    halo_places = halo;
  }



  void
  Halo::refresh(GrainArrays &grains)
  {
    if (neighbours.empty())
      return;
    requests.clear();
    for (Neighbour &neighbour : neighbours)
      {
        if (neighbour.rank != rank && neighbour.n_received > 0)
          MPI_Irecv(neighbour.received.data(),
                    neighbour.n_received * sizeof(Message),
                    MPI_BYTE,
                    neighbour.rank,
                    halo_tag,
                    communicator,
                    &requests.emplace_back());
        for (std::size_t k = 0; k < neighbour.sent.size(); ++k)
          {
            const auto [grain, image] = neighbour.sent[k];
            neighbour.to_send[k]      = {grains.place[grain].x + shifts[image],
                                         grains.motion[grain].v,
                                         grains.motion[grain].w};
          }
        if (neighbour.rank == rank)
          neighbour.received = neighbour.to_send;
        else if (!neighbour.sent.empty())
          MPI_Isend(neighbour.to_send.data(),
                    neighbour.to_send.size() * sizeof(Message),
                    MPI_BYTE,
                    neighbour.rank,
                    halo_tag,
                    communicator,
                    &requests.emplace_back());
      }
    MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    for (const Neighbour &neighbour : neighbours)
      for (std::size_t k = 0; k < neighbour.n_received; ++k)
        {
          const std::size_t to = halo_places[neighbour.begin_received + k];
          grains.place[to].x   = neighbour.received[k].x;
          grains.motion[to].v  = neighbour.received[k].v;
          grains.motion[to].w  = neighbour.received[k].w;
        }
  }
} // namespace Thalweg
