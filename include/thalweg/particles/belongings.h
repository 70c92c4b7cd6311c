// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_belongings_h
#define thalweg_particles_belongings_h

#include <thalweg/core/send_plain.h>
#include <thalweg/particles/particle_rows.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <vector>

namespace Thalweg
{
  /// Where the row of a particle lies that has set out.
  struct Origin
  {
    unsigned int rank;
    unsigned int index; ///< in the rows of that rank
  };

  /**
   * @brief What particles left behind when they set out on a journey, seen
   * from where they have arrived: particles take along nothing but where
   * their rows lie.
   */
  template <int dim>
  class Belongings
  {
  public:
    /**
     * @brief Fetches the rows of those that came from other ranks. Collective.
     * @param home the rows of those that set out on this rank; must outlive
     *   the object
     * @param travellers that have arrived on this rank, Traveller with an
     *   Origin for luggage, in the order of walk_on_other_ranks()
     */
    template <typename TravellerType>
    Belongings(const ParticleRows<dim>          &home,
               const MPI_Comm                    communicator,
               const std::vector<TravellerType> &travellers);

    /// Those of the i-th traveller.
    typename ParticleRows<dim>::ConstReference
    operator()(const unsigned int i, const Origin &origin) const
    {
      return i < n_from_here ? home[origin.index] : foreign[i - n_from_here];
    }

  private:
    const ParticleRows<dim> &home;
    unsigned int             n_from_here = 0;
    ParticleRows<dim>        foreign; ///< in the order of their travellers

    void
    fetch(const MPI_Comm                                           communicator,
          const std::map<unsigned int, std::vector<unsigned int>> &wanted,
          std::map<unsigned int, ParticleRows<dim>>               &rows) const;
  };



  template <int dim>
  template <typename TravellerType>
  Belongings<dim>::Belongings(const ParticleRows<dim>          &home,
                              const MPI_Comm                    communicator,
                              const std::vector<TravellerType> &travellers)
    : home(home)
    , n_from_here(travellers.size())
    , foreign(home.n_properties())
  {
    namespace MPI = dealii::Utilities::MPI;
    if (MPI::n_mpi_processes(communicator) == 1)
      return;
    const unsigned int here = MPI::this_mpi_process(communicator);
    // Behind the first from elsewhere there are some that have been there.
    n_from_here = std::find_if(travellers.begin(),
                               travellers.end(),
                               [here](const TravellerType &traveller) {
                                 return traveller.luggage.rank != here;
                               }) -
                  travellers.begin();
    std::map<unsigned int, std::vector<unsigned int>> wanted;
    for (unsigned int i = n_from_here; i < travellers.size(); ++i)
      wanted[travellers[i].luggage.rank].push_back(travellers[i].luggage.index);
    std::map<unsigned int, ParticleRows<dim>> rows;
    fetch(communicator, wanted, rows);
    std::map<unsigned int, std::size_t> next;
    for (unsigned int i = n_from_here; i < travellers.size(); ++i)
      {
        const unsigned int       rank   = travellers[i].luggage.rank;
        const ParticleRows<dim> &theirs = rows.at(rank);
        foreign.append(theirs[next[rank]++]);
      }
  }
} // namespace Thalweg

#endif
