#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>
#include <thalweg/postprocess/vertical_line.h>

namespace Thalweg
{
  namespace
  {
    /// How much of fluid 0 stands above given places.
    template <int dim>
    class WaterHeightGauges : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
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
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        AssertThrow(!positions.empty(),
                    dealii::ExcMessage(
                      "'water height gauges' has no 'Positions'; give some "
                      "or take it off the list."));
        std::vector<std::string> columns{"time [s]"};
        for (std::size_t g = 0; g < positions.size(); ++g)
          {
            std::string place;
            for (const double coordinate : positions[g])
              place += dealii::Utilities::to_string(coordinate) + " ";
            AssertThrow(
              cut_line(solution, point(g), axis_number(vertical)).length > 0.,
              dealii::ExcMessage("The water height gauge at " + place +
                                 "does not meet the mesh; move it inside."));
            const std::string number = " " + std::to_string(g) + " [m]";
            columns.push_back("wet height" + number);
            columns.push_back("top" + number);
          }
        file.open(context, "water_height_gauges.csv", columns);
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        std::vector<double> row{solution.time};
        for (std::size_t g = 0; g < positions.size(); ++g)
          {
            const LineContent content =
              cut_line(solution, point(g), axis_number(vertical));
            row.push_back(content.wet_length);
            row.push_back(content.wet_length > 0. ? content.top - floor : 0.);
          }
        file.write_row(context, row);
      }

    private:
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
      Schedule                         schedule;
      CsvFile                          file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   WaterHeightGauges,
                   "water height gauges",
                   "the total height of the first fluid above given places, "
                   "and its top; writes water_height_gauges.csv.")
} // namespace Thalweg
