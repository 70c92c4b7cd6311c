// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_journey_h
#define thalweg_particles_journey_h

#include <thalweg/core/send_plain.h>
#include <thalweg/particles/walker.h>

#include <deal.II/base/mpi.h>

#include <map>
#include <vector>

namespace Thalweg
{
  /// A walker and what it carries.
  template <typename WalkerType, typename Luggage>
  struct Traveller
  {
    WalkerType walker;
    Luggage    luggage;
  };

  /// A traveller on its way to the rank that owns its cell.
  template <typename TravellerType>
  struct TravellerInFlight
  {
    TravellerType                    traveller;
    dealii::types::global_cell_index cell;
  };

  /**
   * @brief Lets the travellers that stand in cells of other ranks walk on
   * there, with the time that is left and as often as it takes. Collective.
   *
   * @param walk a StreamlineWalk
   * @param communicator the ranks that share the mesh
   * @param travellers all of them have walked on this rank; on return those
   *   whose way ended on this rank, with their fate: first the ones that
   *   started here, then the others in an order that depends on the partition
   *   of the mesh alone
   * @param effort the work that this rank does is added to it
   */
  template <typename Walk, typename TravellerType>
  void
  walk_on_other_ranks(const Walk                 &walk,
                      const MPI_Comm              communicator,
                      std::vector<TravellerType> &travellers,
                      WalkEffort                 &effort)
  {
    using Flight  = TravellerInFlight<TravellerType>;
    namespace MPI = dealii::Utilities::MPI;
    if (MPI::n_mpi_processes(communicator) == 1)
      return;

    const auto &graph     = walk.graph();
    std::size_t first_new = 0;
    while (true)
      {
        std::map<unsigned int, std::vector<Flight>> departing;
        std::size_t                                 n_staying = first_new;
        for (std::size_t i = first_new; i < travellers.size(); ++i)
          if (travellers[i].walker.fate == Fate::elsewhere)
            {
              const auto &cell = graph.cell(travellers[i].walker.cell);
              departing[cell.owner].push_back(
                {travellers[i], cell.global_index});
            }
          else
            travellers[n_staying++] = travellers[i];
        travellers.resize(n_staying);
        first_new = n_staying;

        if (MPI::max(departing.empty() ? 0 : 1, communicator) == 0)
          return;

        for (const auto &[rank, arriving] : send_plain(communicator, departing))
          for (const Flight &flight : arriving)
            {
              TravellerType traveller = flight.traveller;
              traveller.walker.cell   = graph.owned_index(flight.cell);
              traveller.walker.fate   = Fate::under_way;
              walk.walk(traveller.walker, effort);
              travellers.push_back(traveller);
            }
      }
  }
} // namespace Thalweg

#endif
