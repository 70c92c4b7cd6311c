// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_adaptive_refinement_h
#define thalweg_adaptation_adaptive_refinement_h

#include <thalweg/adaptation/mesh_decision.h>
#include <thalweg/adaptation/refinement_criterion.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief When and where the mesh changes during a run: the section
   * "Refinement/Adaptive".
   *
   * Decisions do not depend on the number of processes, nor on round-off in
   * the indicators.
   */
  template <int dim>
  class AdaptiveRefinement
  {
  public:
    /// Declares "Refinement/Adaptive" below @p root, with all criteria.
    void
    declare_parameters(const Section &root);

    /// Checks the parameters, also those of the chosen criteria. Collective.
    /// @throws dealii::ExcMessage
    void
    check(const RunOutline<dim> &outline) const;

    /// Whether the mesh adapts at all.
    bool
    is_active() const
    {
      return !names.empty();
    }

    /// Whether it is time to adapt when @p step steps were made.
    bool
    is_due(const unsigned int step) const
    {
      return is_active() && step > 0 && step % interval == 0;
    }

    /// Whether the mesh must adapt before a step of @p dt_next seconds, due or
    /// not. Collective; the same on all processes.
    bool
    must_adapt(const SolutionView<dim> &solution, const double dt_next) const;

    /// How often the mesh should be adapted to the initial state, unless it
    /// stays as it is earlier.
    unsigned int
    initial_adaptations() const;

    /**
     * @brief Sets the flags for refinement and coarsening. Collective.
     *
     * Each cell changes by one level at most. Flags are those that
     * prepare_coarsening_and_refinement() leaves, ghost cells have those of
     * their owners, and a cell is flagged for coarsening only with all its
     * siblings.
     *
     * @param mesh gets the flags
     * @param solution on @p mesh
     * @param dt_next the next step in s; 0: as long as the last one
     * @return whether any flag is set on any process
     */
    bool
    mark(Mesh<dim>               &mesh,
         const SolutionView<dim> &solution,
         const double             dt_next = 0.) const;

  private:
    struct Weighted
    {
      std::unique_ptr<RefinementCriterion<dim>> criterion;
      double                                    weight       = 1.;
      double                                    ignore_below = 1e-6;
    };

    /// What all criteria together want.
    CellWishes
    combined_wishes(const SolutionView<dim> &solution,
                    const double             time_ahead) const;

    LevelRange                      levels;
    std::vector<std::string>        names;
    std::map<std::string, Weighted> criteria;
    unsigned int                    interval             = 1;
    std::string                     combination          = "maximum";
    std::string                     strategy             = "fraction of error";
    int                             initial_adaptations_ = -1;
    DecisionParameters              decision;
  };
} // namespace Thalweg

#endif
