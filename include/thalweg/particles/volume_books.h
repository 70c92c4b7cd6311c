// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_volume_books_h
#define thalweg_particles_volume_books_h

#include <thalweg/core/archive.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <array>
#include <map>
#include <vector>

namespace Thalweg
{
  /// Volumes of both fluids, m^dim.
  using FluidVolumes = std::array<double, 2>;

  /// The sum over the cells of all ranks. Collective.
  FluidVolumes
  sum_over_ranks(const std::vector<FluidVolumes> &volumes_of_cells,
                 const MPI_Comm                   communicator);

  /**
   * @brief What of each fluid was there at the start, has come in and gone
   * out since; the same on all ranks.
   *
   * What is inside is what particles carry, and what came in and has no
   * particle yet: inside = start + in - out - lost, to round-off.
   */
  struct VolumeBooks
  {
    /// What passed a boundary so far.
    struct Passage
    {
      FluidVolumes in{};
      FluidVolumes out{};
    };

    FluidVolumes                                  start{};
    FluidVolumes                                  lost{};
    std::map<dealii::types::boundary_id, Passage> boundaries;
    /// What has left according to the velocity, but is still carried by
    /// particles inside (positive), or the other way around.
    FluidVolumes owed{};

    /// What came in through all boundaries.
    FluidVolumes
    in() const;

    /// What went out through all boundaries.
    FluidVolumes
    out() const;

    /// What must be inside.
    FluidVolumes
    inside() const;

    /// Adds what each rank counted during a step. Collective; all ranks have
    /// the same boundaries.
    void
    add(const VolumeBooks &of_rank, const MPI_Comm communicator);

    void
    keep(const Archive &archive);
  };
} // namespace Thalweg

#endif
