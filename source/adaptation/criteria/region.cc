// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/refinement_criterion.h>
#include <thalweg/fields/expression.h>
#include <thalweg/postprocess/cell_access.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Levels as functions of space and time.
    template <int dim>
    class Region : public RefinementCriterion<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("At least",
                    least_text,
                    "",
                    "The level below which no cell may be: a function of the "
                    "cell's centre x, y, z and of t, for example 'if(x < 0.2, "
                    "5, 0)'.",
                    dealii::Patterns::Anything());
        section.add("At most",
                    most_text,
                    "",
                    "The level above which no cell may be, unless a criterion "
                    "prescribes it; a function of the same.",
                    dealii::Patterns::Anything());
        section.add("Fluid",
                    fluid,
                    "",
                    "The name of a fluid: both functions count only in cells "
                    "that have some of it. Nothing: they count everywhere.",
                    dealii::Patterns::Anything());
        declare_flow_choice(section, method);
      }



      void
      check(const RunOutline<dim> &outline, const LevelRange &) const override
      {
        parse_expression<dim>(least_text, 1, path + "At least");
        parse_expression<dim>(most_text, 1, path + "At most");
        if (!fluid.empty())
          outline.flow(method).fluids.index(fluid);
      }



      void
      evaluate(const SolutionView<dim> &solution,
               const LevelRange &,
               const double,
               CellWishes &wishes) override
      {
        if (least == nullptr)
          {
            least = parse_expression<dim>(least_text, 1, path + "At least");
            most  = parse_expression<dim>(most_text, 1, path + "At most");
          }
        least->set_time(solution.moment.time);
        most->set_time(solution.moment.time);
        for (unsigned int c = 0; c < wishes.at_least.size(); ++c)
          if (has_fluid(solution, c))
            look_at(solution.mesh.graph().iterator(c),
                    wishes.at_least[c],
                    wishes.at_most[c]);
      }

    private:
      /// A cell is judged by its parent's centre too: if the parent were to be
      /// refined again, its children may not vanish into it.
      void
      look_at(const typename CellGraph<dim>::CellIterator &cell,
              unsigned char                               &at_least,
              unsigned char                               &at_most) const
      {
        at_least = level(*least, cell->center());
        at_most  = level(*most, cell->center());
        if (cell->level() == 0)
          return;
        const auto          center = cell->parent()->center();
        const unsigned char own    = cell->level();
        at_least = std::max(at_least, std::min(own, level(*least, center)));
        at_most  = std::max(at_most, std::min(own, level(*most, center)));
      }



      static unsigned char
      level(const dealii::FunctionParser<dim> &function,
            const dealii::Point<dim>          &x)
      {
        const double highest = CellWishes::any_level;
        // Not a number must not become a level.
        return std::lround(std::max(0., std::min(highest, function.value(x))));
      }



      bool
      has_fluid(const SolutionView<dim> &solution,
                const unsigned int       cell) const
      {
        if (fluid.empty())
          return true;
        const FlowView<dim> &flow     = solution.flow(method);
        const bool           in_first = flow.fluids.index(fluid) == 0;
        const auto           phi      = cell_level_set(flow, cell);
        return std::any_of(phi.begin(), phi.end(), [&](const double value) {
          return (value < 0.) == in_first;
        });
      }



      static inline const std::string path = "Refinement/Adaptive/region/";

      std::string                                  least_text = "0";
      std::string                                  most_text  = "99";
      std::string                                  fluid;
      std::string                                  method;
      std::unique_ptr<dealii::FunctionParser<dim>> least, most;
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   Region,
                   "region",
                   "prescribes the lowest and the highest level as functions "
                   "of space and time, in all of the domain or in one fluid.")
} // namespace Thalweg
