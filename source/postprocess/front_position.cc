// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_extent.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// The foremost point of fluid 0.
    template <int dim>
    class FrontPosition : public TableOutput<dim>
    {
    public:
      FrontPosition()
        : TableOutput<dim>("front_position.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(limits.empty() ||
                      (limits.size() == 2 && limits[0] <= limits[1]),
                    dealii::ExcMessage(
                      "The 'Band' of the front position must be two "
                      "coordinates, the lesser one first, or empty."));
        if (outline.fills_domain && !limits.empty())
          check_reach(outline.mesh,
                      axis_number(band_direction),
                      limits[0],
                      limits[1],
                      "The 'Band' of the front position");
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Direction",
                    direction,
                    "",
                    "Where the front moves to; with a minus it is the least "
                    "coordinate that counts.",
                    dealii::Patterns::Selection(
                      std::string(axis_names<dim>) +
                      (dim == 2 ? "|-x|-y" : "|-x|-y|-z")));
        section.add("Band direction",
                    band_direction,
                    "",
                    "The axis along which 'Band' is measured.",
                    dealii::Patterns::Selection(axis_names<dim>));
        section.add("Band",
                    limits,
                    "m",
                    "Two coordinates; only fluid between them counts, for "
                    "example near the floor. Empty: all of it.",
                    dealii::Patterns::List(dealii::Patterns::Double(), 0, 2));
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        return {std::string("front ") + direction.back() + " [m]"};
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        Band band;
        if (!limits.empty())
          band = {axis_number(band_direction), limits[0], limits[1]};
        return {phase_extent(solution,
                             axis_number(direction),
                             direction[0] == '-' ? -1. : 1.,
                             band)};
      }


      std::string         direction      = "x";
      std::string         band_direction = "y";
      std::vector<double> limits;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   FrontPosition,
                   "front position",
                   "how far the first fluid reaches in a direction; writes "
                   "front_position.csv.")
} // namespace Thalweg
