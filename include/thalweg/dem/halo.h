// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_halo_h
#define thalweg_dem_halo_h

#include <thalweg/dem/grain_record.h>

#include <mpi.h>

namespace Thalweg
{
  /// A grain of another rank, or the image of one behind a periodic boundary.
  struct HaloGrain
  {
    std::uint64_t id;
    Vec3          x, v, w, reference;
    double        r, inverse_mass;
    std::uint32_t material;
    std::uint32_t image; ///< 0, or which of Halo's shifts it is moved by
  };

  /**
   * @brief The grains around those of a rank, found by where they are, whatever
   * cells lie between, and sent again in each step.
   *
   * Pairs across borders are computed by both ranks, with the same bits:
   * nothing is sent back.
   */
  class Halo
  {
  public:
    /// @param shifts by which images are moved, m; that of no image is not
    ///   among them
    Halo(const MPI_Comm communicator, const std::vector<Vec3> &shifts);

    /**
     * @brief Finds the grains that others need. Collective.
     * @param own this rank's grains, found by their references
     * @param inverse_mass of each, 1/kg
     * @param skin up to how far apart neighbours are, m
     * @return those that this rank needs
     */
    std::vector<HaloGrain>
    make(const std::vector<GrainRecord> &own,
         const std::vector<double>      &inverse_mass,
         const double                    skin);

    /// Says where in GrainArrays the grains of the last make() are.
    /// @param own place of each of this rank's, @param halo of each in the halo
    void
    set_places(const std::vector<std::uint32_t> &own,
               const std::vector<std::uint32_t> &halo);

    /// Brings the halo's places and motions up to date. Collective.
    void
    refresh(GrainArrays &grains);

    std::size_t
    n_received() const
    {
      return halo_places.size();
    }

  private:
    /// What each step sends of a grain.
    struct Message
    {
      Vec3 x, v, w;
    };

    /// A grain that is sent.
    struct Sent
    {
      std::uint32_t grain; ///< among the own ones, then its place
      std::uint32_t image;
    };

    /// A rank with which grains are exchanged.
    struct Neighbour
    {
      int                  rank;
      std::vector<Sent>    sent;
      std::size_t          begin_received = 0, n_received = 0;
      std::vector<Message> to_send, received;
    };

    /// A box around some grains, by their references.
    struct Box
    {
      Vec3   lower, upper; ///< m
      double largest;      ///< radius, m
    };

    /// Boxes around the grains of a rank: the first one around all.
    static std::vector<Box>
    boxes_around(const std::vector<GrainRecord> &own);

    /// Fills the neighbours' lists. @param begin of each rank's boxes
    void
    select(const std::vector<GrainRecord> &own,
           const std::vector<Box>         &boxes,
           const std::vector<int>         &begin,
           const double                    skin);

    MPI_Comm                   communicator;
    int                        rank, n_ranks;
    std::vector<Vec3>          shifts; ///< the first one is none
    std::vector<Neighbour>     neighbours;
    std::vector<std::uint32_t> halo_places;
    std::vector<MPI_Request>   requests;
  };
} // namespace Thalweg

#endif
