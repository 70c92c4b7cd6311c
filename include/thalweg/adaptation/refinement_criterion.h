// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_refinement_criterion_h
#define thalweg_adaptation_refinement_criterion_h

#include <thalweg/core/registry.h>
#include <thalweg/methods/solution_view.h>
#include <thalweg/postprocess/postprocessor.h>

#include <vector>

namespace Thalweg
{
  /// Between which levels the mesh adapts; the coarse mesh is level 0.
  struct LevelRange
  {
    unsigned int minimum = 0;
    unsigned int maximum = 0;
  };

  /// What criteria want of the mesh: an entry for each locally owned cell, in
  /// the order of the CellGraph.
  struct CellWishes
  {
    static constexpr unsigned char any_level = 255;

    /// No wishes for @p n_cells cells.
    explicit CellWishes(const unsigned int n_cells = 0)
      : indicator(n_cells, 0.)
      , at_least(n_cells, 0)
      , at_most(n_cells, any_level)
    {}

    /// How much a smaller cell would help, not negative; 0: not at all.
    std::vector<double> indicator;
    /// The level below which a cell must not be.
    std::vector<unsigned char> at_least;
    /// The level above which it must not be, as far as nobody else wants it.
    std::vector<unsigned char> at_most;
  };

  /**
   * @brief Something that says where the mesh should be finer or coarser.
   *
   * A criterion that gives levels must agree with itself: the children of a
   * cell that it wants to be finer may not all be allowed to become that cell
   * again, or the mesh would change for ever.
   */
  template <int dim>
  class RefinementCriterion
  {
  public:
    virtual ~RefinementCriterion() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Checks the parameters; collective over the processes of the mesh.
    /// @throws dealii::ExcMessage
    virtual void
    check(const RunOutline<dim> &, const LevelRange &) const
    {}

    /**
     * @brief Looks at the solution. Collective.
     * @param solution on the mesh that is going to change
     * @param levels between which it may change
     * @param time_ahead the next time step, in s; 0 if it is not known
     * @param wishes with no wishes in them yet
     */
    virtual void
    evaluate(const SolutionView<dim> &solution,
             const LevelRange        &levels,
             const double             time_ahead,
             CellWishes              &wishes) = 0;

    /// Whether the mesh must adapt before a step of @p dt seconds, without
    /// which the step would be wrong. Collective; the same on all processes.
    virtual bool
    is_violated(const SolutionView<dim> &, const LevelRange &, const double)
    {
      return false;
    }
  };

  /**
   * @brief A criterion that looks at a flow: at that of the method which its
   * parameter "Method" names, or at the only one.
   */
  template <int dim>
  class FlowCriterion : public RefinementCriterion<dim>
  {
  public:
    void
    declare_parameters(const Section &section) final;

    void
    check(const RunOutline<dim> &outline, const LevelRange &levels) const final;

    void
    evaluate(const SolutionView<dim> &solution,
             const LevelRange        &levels,
             const double             time_ahead,
             CellWishes              &wishes) final;

    bool
    is_violated(const SolutionView<dim> &solution,
                const LevelRange        &levels,
                const double             dt) final;

  protected:
    /// Declares all parameters but "Method".
    virtual void
    declare_for_flow(const Section &section) = 0;

    /// check() for the flow.
    virtual void
    check_for_flow(const FlowOutline<dim> &, const LevelRange &) const
    {}

    /// evaluate() for the flow.
    virtual void
    evaluate_for_flow(const FlowView<dim> &flow,
                      const LevelRange    &levels,
                      const double         time_ahead,
                      CellWishes          &wishes) = 0;

    /// is_violated() for the flow.
    virtual bool
    is_violated_for_flow(const FlowView<dim> &,
                         const LevelRange &,
                         const double)
    {
      return false;
    }

  private:
    std::string method;
  };
} // namespace Thalweg

#endif
