#ifndef thalweg_particles_journey_h
#define thalweg_particles_journey_h

#include <thalweg/particles/streamline_walk.h>

#include <deal.II/base/mpi.h>

#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

namespace Thalweg
{
  /// A walker and what it carries.
  template <int dim, typename Luggage>
  struct Traveller
  {
    Walker<dim> walker;
    Luggage luggage;
  };

  /// A traveller on its way to the rank that owns its cell.
  template <int dim, typename Luggage>
  struct TravellerInFlight
  {
    Traveller<dim, Luggage> traveller;
    dealii::types::global_cell_index cell;
  };

  /**
   * @brief Sends lists of plain objects to some ranks. Collective.
   * @param to_send a list for each rank that is to get one
   * @return the list that each rank has sent, the own one included
   */
  template <typename T>
  std::map<unsigned int, std::vector<T>>
  send_plain(const MPI_Comm communicator,
             const std::map<unsigned int, std::vector<T>> &to_send)
  {
    static_assert(std::is_trivially_copyable<T>::value,
                  "Only plain memory can be sent like this.");
    std::map<unsigned int, std::vector<char>> bytes_to_send;
    for (const auto &[rank, list] : to_send)
    {
      auto &bytes = bytes_to_send[rank];
      bytes.resize(list.size() * sizeof(T));
      std::memcpy(bytes.data(), list.data(), bytes.size());
    }
    std::map<unsigned int, std::vector<T>> received;
    for (const auto &[rank, bytes] :
         dealii::Utilities::MPI::some_to_some(communicator, bytes_to_send))
    {
      auto &list = received[rank];
      list.resize(bytes.size() / sizeof(T));
      std::memcpy(list.data(), bytes.data(), bytes.size());
    }
    return received;
  }


  /**
   * @brief Lets all travellers walk to their end, across ranks. Collective.
   *
   * A traveller that comes to a cell of another rank goes on there with the
   * time that is left, as often as it takes.
   *
   * @param walk the streamlines
   * @param communicator the ranks that share the mesh
   * @param travellers on return those whose way ended on this rank, with
   *   their fate: first the ones that started here, then the others in an
   *   order that depends on the partition of the mesh alone
   * @return the work that this rank has done
   */
  template <int dim, typename Luggage>
  WalkEffort
  travel(const StreamlineWalk<dim> &walk,
         const MPI_Comm communicator,
         std::vector<Traveller<dim, Luggage>> &travellers)
  {
    using Flight = TravellerInFlight<dim, Luggage>;

    const auto &graph = walk.graph();
    const bool is_serial
      = dealii::Utilities::MPI::n_mpi_processes(communicator) == 1;
    WalkEffort effort;
    std::size_t first_new = 0;
    while (true)
    {
      std::map<unsigned int, std::vector<Flight>> departing;
      std::size_t n_staying = first_new;
      for (std::size_t i = first_new; i < travellers.size(); ++i)
      {
        walk.walk(travellers[i].walker, effort);
        if (travellers[i].walker.fate == Fate::elsewhere)
        {
          const auto &cell = graph.cell(travellers[i].walker.cell);
          departing[cell.owner].push_back({travellers[i], cell.global_index});
        }
        else
        {
          if (n_staying != i)
            travellers[n_staying] = travellers[i];
          ++n_staying;
        }
      }
      travellers.resize(n_staying);
      first_new = n_staying;

      if (is_serial
          || dealii::Utilities::MPI::max(departing.empty() ? 0 : 1,
                                         communicator)
               == 0)
        return effort;

      for (const auto &[rank, arriving] : send_plain(communicator, departing))
        for (const Flight &flight : arriving)
        {
          travellers.push_back(flight.traveller);
          travellers.back().walker.cell = graph.owned_index(flight.cell);
          travellers.back().walker.fate = Fate::under_way;
        }
    }
  }
} // namespace Thalweg

#endif
