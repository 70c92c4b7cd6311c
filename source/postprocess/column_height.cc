// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_extent.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// The highest point of fluid 0 in a plane, such as a wall.
    template <int dim>
    class ColumnHeight : public TableOutput<dim>
    {
    public:
      ColumnHeight()
        : TableOutput<dim>("column_height.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(normal != vertical,
                    dealii::ExcMessage(
                      "The plane of the column height must be parallel to "
                      "the 'Vertical direction': 'Plane normal' may not be " +
                      vertical + " too."));
        if (outline.fills_domain)
          check_reach(outline.mesh,
                      axis_number(normal),
                      position,
                      position,
                      "The plane of the column height");
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Plane normal",
                    normal,
                    "",
                    "The axis that is normal to the plane.",
                    dealii::Patterns::Selection(axis_names<dim>));
        section.add("Plane position",
                    position,
                    "m",
                    "The plane's coordinate along its normal.");
        section.add("Vertical direction",
                    vertical,
                    "",
                    "The axis along which the height is measured.",
                    dealii::Patterns::Selection(axis_names<dim>));
        section.add("Floor",
                    floor,
                    "m",
                    "The coordinate from which the height is measured.");
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        return {"height [m]"};
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        return {phase_extent(solution,
                             axis_number(vertical),
                             1.,
                             {axis_number(normal), position, position}) -
                floor};
      }


      std::string normal   = "x";
      double      position = 0.;
      std::string vertical = "y";
      double      floor    = 0.;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ColumnHeight,
                   "column height",
                   "the highest point of the first fluid in a plane, for "
                   "example at a wall; writes column_height.csv.")
} // namespace Thalweg
