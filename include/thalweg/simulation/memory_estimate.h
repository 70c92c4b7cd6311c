// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_memory_estimate_h
#define thalweg_simulation_memory_estimate_h

#include <deal.II/base/mpi.h>

namespace Thalweg
{
  /**
   * @brief How much memory cells and particles take, and whether the machines
   * have so much.
   *
   * The estimate is what runs of two fluids were measured to take at the
   * least: meshes that are refused are hopeless, others may still be too large.
   */
  class MemoryEstimate
  {
  public:
    /**
     * Collective.
     * @param communicator the processes of the run
     * @param dim the dimension
     * @param particles_per_cell at the start, or as population control wants
     * @param limit in GB; 0: what the machines have
     */
    MemoryEstimate(const MPI_Comm communicator,
                   const int      dim,
                   const double   particles_per_cell,
                   const double   limit);

    /// The most cells for which there is memory.
    double
    most_cells() const;

    /// @throws dealii::ExcMessage with both numbers if there is too little
    /// memory for so many cells
    void
    check(const double n_cells) const;

  private:
    double bytes_per_cell;
    double particles_per_cell;
    double limit; ///< bytes
    bool   is_given;
  };
} // namespace Thalweg

#endif
