// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/adaptive_refinement.h>
#include <thalweg/adaptation/flag_setting.h>
#include <thalweg/mesh/cell_count.h>

#include <algorithm>
#include <set>

namespace Thalweg
{
  namespace
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    using dealii::Patterns::Selection;


    const std::map<std::string, MarkingStrategy> strategies{
      {"fraction of cells", MarkingStrategy::fraction_of_cells},
      {"fraction of error", MarkingStrategy::fraction_of_error},
      {"target number of cells", MarkingStrategy::target_number},
      {"threshold", MarkingStrategy::threshold}};



    void
    declare_strategy(const Section      &section,
                     std::string        &strategy,
                     DecisionParameters &decision)
    {
      section.add(
        "Strategy",
        strategy,
        "",
        "Which cells the indicators refine and coarsen, among those for which "
        "no criterion prescribes a level. `fraction of cells`: so many of all "
        "of these; `fraction of error`: those with the largest and the "
        "smallest indicators, which together have so much of their sum; "
        "`target number of cells`: as many as bring the mesh nearest to that "
        "number; `threshold`: those with indicators above and below given "
        "values, to within one per cent. Cells with no indicator become as "
        "coarse as they may.",
        Selection("fraction of cells|fraction of error|target number of "
                  "cells|threshold"));
      section.add("Refined fraction",
                  decision.refined_fraction,
                  "",
                  "For the strategies with fractions.",
                  Double(0, 1));
      section.add("Coarsened fraction",
                  decision.coarsened_fraction,
                  "",
                  "For the strategies with fractions.",
                  Double(0, 1));
      section.add("Refinement threshold",
                  decision.refine_threshold,
                  "",
                  "For the strategy with thresholds: a value of the weighted "
                  "indicators, which are not scaled by their maximum then.",
                  Double(0));
      section.add("Coarsening threshold",
                  decision.coarsen_threshold,
                  "",
                  "For the strategy with thresholds.",
                  Double(0));
      section.add("Target number of cells",
                  decision.target_n_cells,
                  "",
                  "For the strategy of this name.",
                  Integer(1));
      section.add("Maximal number of cells",
                  decision.maximal_n_cells,
                  "",
                  "Indicators do not refine beyond about this number; levels "
                  "that a criterion prescribes are kept all the same. 0: no "
                  "limit.",
                  Integer(0));
    }
  } // namespace



  template <int dim>
  void
  AdaptiveRefinement<dim>::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Refinement").enter("Adaptive");
    section.add("Criteria",
                names,
                "",
                "What changes the mesh during the run, separated by commas; "
                "nothing: it stays as it is. A level that a criterion "
                "prescribes comes before indicators, and a lower bound before "
                "an upper one." +
                  Registry<RefinementCriterion<dim>>::description(),
                dealii::Patterns::List(
                  Selection(Registry<RefinementCriterion<dim>>::names())));
    section.add("Interval",
                interval,
                "steps",
                "The mesh adapts after every so many steps, and in between "
                "where the interface would leave its refined band.",
                Integer(1));
    section.add("Minimum level",
                levels.minimum,
                "",
                "No cell is coarser; the coarse mesh has level 0, and 'Global "
                "levels' is where the run starts.",
                Integer(0, highest_level<dim>));
    section.add("Maximum level",
                levels.maximum,
                "",
                "No cell is finer.",
                Integer(0, highest_level<dim>));
    section.add("Initial adaptations",
                initial_adaptations_,
                "",
                "How often the mesh adapts to the initial conditions before "
                "the first step; -1: as many times as there are levels.",
                Integer(-1));
    section.add("Combination",
                combination,
                "",
                "What counts of the indicators of several criteria. Before, "
                "each one is divided by its maximum over the mesh (unless the "
                "strategy is 'threshold') and multiplied by its weight.",
                Selection("maximum|weighted sum"));
    declare_strategy(section, strategy, decision);
    for (const auto &[name, entry] :
         Registry<RefinementCriterion<dim>>::entries())
      {
        const Section own       = section.enter(name);
        Weighted     &criterion = criteria[name];
        criterion.criterion     = entry.make();
        criterion.criterion->declare_parameters(own);
        own.add("Weight",
                criterion.weight,
                "",
                "Of this criterion's indicator among those of others.",
                Double(0));
        own.add("Ignore below",
                criterion.ignore_below,
                "",
                "Smaller indicators, in the criterion's own unit, count as "
                "zero, so that a fluid at rest is not refined for the errors "
                "of the linear solvers.",
                Double(0));
      }
  }



  template <int dim>
  void
  AdaptiveRefinement<dim>::check(const RunOutline<dim> &outline) const
  {
    if (!is_active())
      return;
    AssertThrow(levels.maximum > levels.minimum,
                dealii::ExcMessage(
                  "'Refinement/Adaptive/Maximum level' is " +
                  std::to_string(levels.maximum) + ", and the minimum level " +
                  std::to_string(levels.minimum) +
                  "; with criteria the maximum must be above the minimum."));
    AssertThrow(decision.refined_fraction + decision.coarsened_fraction <= 1.,
                dealii::ExcMessage(
                  "The sum of 'Refinement/Adaptive/Refined fraction' and "
                  "'Coarsened fraction' is above 1."));
    AssertThrow(decision.coarsen_threshold < decision.refine_threshold ||
                  strategy != "threshold",
                dealii::ExcMessage(
                  "'Refinement/Adaptive/Coarsening threshold' must be below "
                  "'Refinement threshold', best by a factor of four or more."));
    AssertThrow(std::set<std::string>(names.begin(), names.end()).size() ==
                  names.size(),
                dealii::ExcMessage(
                  "A criterion stands twice in 'Refinement/Adaptive/"
                  "Criteria'."));
    for (const std::string &name : names)
      criteria.at(name).criterion->check(outline, levels);
  }



  template <int dim>
  unsigned int
  AdaptiveRefinement<dim>::initial_adaptations() const
  {
    if (!is_active())
      return 0;
    return initial_adaptations_ < 0 ? levels.maximum - levels.minimum
                                    : initial_adaptations_;
  }



  template <int dim>
  bool
  AdaptiveRefinement<dim>::must_adapt(const SolutionView<dim> &solution,
                                      const double             dt_next) const
  {
    return std::any_of(names.begin(), names.end(), [&](const auto &name) {
      return criteria.at(name).criterion->is_violated(solution,
                                                      levels,
                                                      dt_next);
    });
  }



  template <int dim>
  CellWishes
  AdaptiveRefinement<dim>::combined_wishes(const SolutionView<dim> &solution,
                                           const double time_ahead) const
  {
    const unsigned int n_cells = solution.mesh.graph().n_owned_cells();
    CellWishes         all(n_cells);
    for (const std::string &name : names)
      {
        const Weighted &weighted = criteria.at(name);
        CellWishes      own(n_cells);
        weighted.criterion->evaluate(solution, levels, time_ahead, own);
        double largest = 0.;
        for (double &indicator : own.indicator)
          {
            if (!(indicator >= weighted.ignore_below))
              indicator = 0.;
            largest = std::max(largest, indicator);
          }
        largest = dealii::Utilities::MPI::max(
          largest, solution.mesh.triangulation().get_communicator());
        const double factor = strategy == "threshold" || largest == 0.
                                ? weighted.weight
                                : weighted.weight / largest;
        for (unsigned int c = 0; c < n_cells; ++c)
          {
            const double indicator = factor * own.indicator[c];
            all.indicator[c]       = combination == "maximum"
                                       ? std::max(all.indicator[c], indicator)
                                       : all.indicator[c] + indicator;
            all.at_least[c]        = std::max(all.at_least[c], own.at_least[c]);
            all.at_most[c]         = std::min(all.at_most[c], own.at_most[c]);
          }
      }
    const unsigned char minimum = levels.minimum, maximum = levels.maximum;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        all.at_least[c] = std::clamp(all.at_least[c], minimum, maximum);
        all.at_most[c]  = std::clamp(all.at_most[c], all.at_least[c], maximum);
      }
    return all;
  }



  template <int dim>
  bool
  AdaptiveRefinement<dim>::mark(Mesh<dim>               &mesh,
                                const SolutionView<dim> &solution,
                                const double             dt_next) const
  {
    const CellWishes wishes =
      combined_wishes(solution,
                      dt_next > 0. ? dt_next : solution.moment.time_step);
    const CellGraph<dim>      &graph = mesh.graph();
    std::vector<unsigned char> level(graph.n_owned_cells());
    for (unsigned int c = 0; c < level.size(); ++c)
      level[c] = graph.iterator(c)->level();
    DecisionParameters chosen = decision;
    chosen.strategy           = strategies.at(strategy);
    return set_flags(mesh,
                     decide(mesh.triangulation().get_communicator(),
                            chosen,
                            level,
                            wishes,
                            1u << dim));
  }



  THALWEG_INSTANTIATE(AdaptiveRefinement)
} // namespace Thalweg
