// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/refinement_criterion.h>

namespace Thalweg
{
  template <int dim>
  void
  FlowCriterion<dim>::declare_parameters(const Section &section)
  {
    declare_for_flow(section);
    declare_flow_choice(section, method);
  }



  template <int dim>
  void
  FlowCriterion<dim>::check(const RunOutline<dim> &outline,
                            const LevelRange      &levels) const
  {
    check_for_flow(outline.flow(method), levels);
  }



  template <int dim>
  void
  FlowCriterion<dim>::evaluate(const SolutionView<dim> &solution,
                               const LevelRange        &levels,
                               const double             time_ahead,
                               CellWishes              &wishes)
  {
    evaluate_for_flow(solution.flow(method), levels, time_ahead, wishes);
  }



  template <int dim>
  bool
  FlowCriterion<dim>::is_violated(const SolutionView<dim> &solution,
                                  const LevelRange        &levels,
                                  const double             dt)
  {
    return is_violated_for_flow(solution.flow(method), levels, dt);
  }



  THALWEG_INSTANTIATE(FlowCriterion)
} // namespace Thalweg
