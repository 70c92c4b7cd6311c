// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/swept_interface.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    using dealii::Patterns::List;

    /// Distances that are equal but for round-off and tolerances of solvers
    /// are equal, in finest cells.
    constexpr double round_off = .01;



    /// Bands around the interface, each with a level.
    template <int dim>
    class InterfaceDistance : public FlowCriterion<dim>
    {
    public:
      void
      declare_for_flow(const Section &section) override
      {
        section.add("Widths",
                    widths,
                    "finest cells",
                    "How far from the interface a band reaches on each side, "
                    "in edges of cells of the maximum level; several bands, "
                    "separated by commas.",
                    List(Double(0), 1));
        section.add("Levels below maximum",
                    levels_below,
                    "",
                    "For each band, by how many levels its cells may be "
                    "coarser than the maximum level.",
                    List(Integer(0), 1));
        section.add("Steps ahead",
                    steps_ahead,
                    "steps",
                    "The bands enclose the way, too, that the flow will carry "
                    "the interface in so many time steps. The mesh adapts "
                    "before its interval is over if the interface would leave "
                    "the first band in the next step.",
                    Double(1));
      }



      void
      check_for_flow(const FlowOutline<dim> &outline,
                     const LevelRange       &levels) const override
      {
        AssertThrow(outline.fluids.size() == 2,
                    dealii::ExcMessage(
                      "The criterion 'interface distance' needs two fluids: "
                      "write 'Number = 2' in the section 'Fluids', or choose "
                      "other criteria."));
        AssertThrow(widths.size() == levels_below.size(),
                    dealii::ExcMessage(
                      "The criterion 'interface distance' has " +
                      std::to_string(widths.size()) + " 'Widths' but " +
                      std::to_string(levels_below.size()) +
                      " 'Levels below maximum'; write one of each for every "
                      "band."));
        for (const unsigned int below : levels_below)
          AssertThrow(below <= levels.maximum - levels.minimum,
                      dealii::ExcMessage(
                        "'Levels below maximum' of the criterion 'interface "
                        "distance' has " +
                        std::to_string(below) +
                        ", which is below the minimum level."));
      }



      void
      evaluate_for_flow(const FlowView<dim> &solution,
                        const LevelRange    &levels,
                        const double         time_ahead,
                        CellWishes          &wishes) override
      {
        const SweptInterface<dim> interface(solution,
                                            levels,
                                            steps_ahead * time_ahead,
                                            widest() + round_off);
        const CellGraph<dim>     &graph = solution.mesh.graph();
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          for (unsigned int b = 0; b < widths.size(); ++b)
            {
              const unsigned char level = levels.maximum - levels_below[b];
              if (wishes.at_least[c] < level &&
                  is_in_band(interface, graph, c, levels, level, widths[b]))
                wishes.at_least[c] = level;
            }
      }



      bool
      is_violated_for_flow(const FlowView<dim> &solution,
                           const LevelRange    &levels,
                           const double         dt) override
      {
        const double              margin = std::min(.5, widths[0] / 2.);
        const SweptInterface<dim> interface(solution, levels, dt, margin);
        const CellGraph<dim>     &graph = solution.mesh.graph();
        const int                 level = levels.maximum - levels_below[0];
        bool                      is_violated = false;
        for (unsigned int c = 0; c < graph.n_owned_cells() && !is_violated; ++c)
          is_violated = graph.iterator(c)->level() < level &&
                        is_in_band(interface, graph, c, levels, level, margin);
        return dealii::Utilities::MPI::logical_or(
          is_violated, solution.mesh.triangulation().get_communicator());
      }

    private:
      double
      widest() const
      {
        return *std::max_element(widths.begin(), widths.end());
      }



      /**
       * @brief Whether a cell belongs to a band with cells of level @p level.
       *
       * A cell that has this level already is judged by its parent: if the
       * parent would be refined again, its children may not vanish into it.
       */
      static bool
      is_in_band(const SweptInterface<dim> &interface,
                 const CellGraph<dim>      &graph,
                 const unsigned int         c,
                 const LevelRange          &levels,
                 const int                  level,
                 const double               width)
      {
        typename dealii::Triangulation<dim>::cell_iterator cell =
          graph.iterator(c);
        if (cell->level() == level && level > 0)
          cell = cell->parent();
        return interface.is_near(cell->bounding_box(),
                                 (width + round_off) *
                                   edge_on_level(graph, c, levels.maximum));
      }



      std::vector<double>       widths       = {3.};
      std::vector<unsigned int> levels_below = {0};
      double                    steps_ahead  = 1.;
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   InterfaceDistance,
                   "interface distance",
                   "prescribes levels in bands around the interface, and "
                   "along the way that it is about to go.")
} // namespace Thalweg
