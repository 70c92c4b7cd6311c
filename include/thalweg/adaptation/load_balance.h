// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_load_balance_h
#define thalweg_adaptation_load_balance_h

#include <thalweg/core/compat_weights.h>
#include <thalweg/core/section.h>
#include <thalweg/methods/solution_view.h>

#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// How much work the processes have compared with each other: the greatest
  /// over the mean, 1 at best.
  struct Imbalance
  {
    double total     = 1.; ///< weighted as in the section "Load balance"
    double cells     = 1.;
    double particles = 1.;
    double cut_cells = 1.;

    /// Names and values of the columns of the statistics.
    std::vector<std::pair<std::string, double>>
    columns() const;
  };

  /**
   * @brief How much work a cell is, and when the cells are distributed over
   * the processes anew: the section "Load balance".
   *
   * Works on the particles and cut cells that were counted last, since the
   * triangulation asks for weights while it is changing.
   */
  template <int dim>
  class LoadBalance
  {
  public:
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// @throws dealii::ExcMessage if no cell would have any weight
    void
    check() const;

    /// Counts particles and cut cells; to be called before each change or
    /// repartitioning of the mesh. Collective.
    void
    count(const SolutionView<dim> &solution);

    /**
     * @brief The weight of a cell, or of what will become of it.
     *
     * What is known are the cells that were counted; others count as empty.
     * A child gets its share of its parent's particles and half the weight of
     * a cut cell, as half of the children of a cut cell are cut on average; a
     * parent has the particles of all its children. Weights are multiples of a
     * thousandth of an empty cell's, or coarser where that would not fit into
     * an int, which is what p4est takes.
     */
    unsigned int
    weight(const CellIterator &cell, const Compat::CellFate fate) const;

    /// Compares the processes. Collective.
    Imbalance
    imbalance(const SolutionView<dim> &solution) const;

    /**
     * @brief Whether to distribute the cells anew when @p step steps were
     * made: the imbalance is looked at every so many steps, and must be above
     * the threshold and above what single cells make unavoidable. Collective.
     */
    bool
    is_due(const SolutionView<dim> &solution, const unsigned int step) const;

  private:
    struct Load
    {
      unsigned int n_particles = 0;
      bool         is_cut      = false;
    };

    Load
    load(const SolutionView<dim> &solution, const unsigned int cell) const;

    double
    cost(const double n_cells,
         const double n_particles,
         const double n_cut_cells) const
    {
      return cell_weight * n_cells + particle_weight * n_particles +
             cut_cell_weight * n_cut_cells;
    }

    double       cell_weight     = 1.;
    double       particle_weight = 0.04;
    double       cut_cell_weight = 2.;
    double       threshold       = 1.1;
    unsigned int interval        = 10;

    /// By active_cell_index().
    std::vector<Load> loads;
    double            scale = 1000.; ///< weight per cost
  };
} // namespace Thalweg

#endif
