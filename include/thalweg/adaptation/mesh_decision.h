// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_mesh_decision_h
#define thalweg_adaptation_mesh_decision_h

#include <thalweg/adaptation/refinement_criterion.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <vector>

namespace Thalweg
{
  /// How indicators become decisions.
  enum class MarkingStrategy
  {
    fraction_of_cells,
    fraction_of_error,
    target_number,
    threshold
  };

  struct DecisionParameters
  {
    MarkingStrategy strategy           = MarkingStrategy::fraction_of_error;
    double          refined_fraction   = 0.3;
    double          coarsened_fraction = 0.05;
    double          refine_threshold   = 1.;
    double          coarsen_threshold  = 0.;
    unsigned int    target_n_cells     = 10000;
    unsigned int    maximal_n_cells    = 0; ///< 0: no limit
  };

  /**
   * @brief Decides for each cell whether it becomes finer (1), coarser (-1) or
   * remains (0). Collective.
   *
   * Levels come first: a cell below CellWishes::at_least is refined, one above
   * at_most coarsened. What the indicators decide about the others is read off
   * a histogram of them over all processes, in classes two per cent wide: so
   * many of the best and of the worst classes are taken that the numbers come
   * nearest to what the strategy asks for. Classes are taken as a whole, for
   * which reason cells that differ by round-off only are treated alike, and all
   * sums are made of whole numbers, which is why the number of processes does
   * not matter. Cells with no indicator at all are coarsened where levels
   * allow it.
   *
   * @param level the level of each cell
   * @param wishes at_least not above at_most
   * @param n_children of a refined cell, 2^dim
   */
  std::vector<signed char>
  decide(const MPI_Comm                    communicator,
         const DecisionParameters         &parameters,
         const std::vector<unsigned char> &level,
         const CellWishes                 &wishes,
         const unsigned int                n_children);
} // namespace Thalweg

#endif
