// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/scheduled_output.h>
#include <thalweg/postprocess/vertical_line.h>

namespace Thalweg
{
  namespace
  {
    /// How much of fluid 0 stands above given places.
    template <int dim>
    class WaterHeightGauges : public TableOutput<dim>
    {
    public:
      WaterHeightGauges()
        : TableOutput<dim>("water_height_gauges.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(!positions.empty(),
                    dealii::ExcMessage(
                      "'water height gauges' has no 'Positions'; give some "
                      "or take it off the list."));
        if (!outline.fills_domain)
          return;
        for (std::size_t g = 0; g < positions.size(); ++g)
          {
            std::string place;
            for (const double coordinate : positions[g])
              place += dealii::Utilities::to_string(coordinate) + " ";
            AssertThrow(
              meets_line(outline.mesh, point(g), axis_number(vertical)),
              dealii::ExcMessage("The water height gauge at " + place +
                                 "does not meet the mesh; move it inside. "
                                 "The mesh reaches " +
                                 outline.mesh.extent() + "."));
          }
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Vertical direction",
                    vertical,
                    "",
                    "The axis along which the gauges stand.",
                    dealii::Patterns::Selection(axis_names<dim>));
        section.add("Positions",
                    positions,
                    "m",
                    dim == 2 ? "The coordinate of each gauge along the other "
                               "axis, separated by semicolons."
                             : "The coordinates of each gauge along the other "
                               "two axes, separated by commas; gauges by "
                               "semicolons.",
                    dealii::Patterns::List(
                      dealii::Patterns::List(
                        dealii::Patterns::Double(), dim - 1, dim - 1, ","),
                      0,
                      dealii::Patterns::List::max_int_value,
                      ";"));
        section.add("Floor",
                    floor,
                    "m",
                    "The coordinate from which the top is measured.");
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        std::vector<std::string> names;
        for (std::size_t g = 0; g < positions.size(); ++g)
          for (const std::string quantity : {"wet height ", "top "})
            names.push_back(quantity + std::to_string(g) + " [m]");
        return names;
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        std::vector<double> values;
        for (std::size_t g = 0; g < positions.size(); ++g)
          {
            const LineContent content =
              cut_line(solution, point(g), axis_number(vertical));
            values.push_back(content.wet_length);
            values.push_back(content.wet_length > 0. ? content.top - floor
                                                     : 0.);
          }
        return values;
      }


      /// A point on gauge @p g.
      dealii::Point<dim>
      point(const std::size_t g) const
      {
        dealii::Point<dim> point;
        unsigned int       n = 0;
        for (unsigned int d = 0; d < dim; ++d)
          if (d != axis_number(vertical))
            point[d] = positions[g][n++];
        return point;
      }


      std::string                      vertical = "y";
      std::vector<std::vector<double>> positions;
      double                           floor = 0.;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   WaterHeightGauges,
                   "water height gauges",
                   "the total height of the first fluid above given places, "
                   "and its top; writes water_height_gauges.csv.")
} // namespace Thalweg
