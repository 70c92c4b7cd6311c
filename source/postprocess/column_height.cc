#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/phase_extent.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

namespace Thalweg
{
  namespace
  {
    /// The highest point of fluid 0 in a plane, such as a wall.
    template <int dim>
    class ColumnHeight : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
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
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &) override
      {
        AssertThrow(normal != vertical,
                    dealii::ExcMessage(
                      "The plane of the column height must be parallel to "
                      "the 'Vertical direction': 'Plane normal' may not be " +
                      vertical + " too."));
        file.open(context, "column_height.csv", {"time [s]", "height [m]"});
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (schedule.is_due(solution.time, solution.last_step))
          file.write_row(
            context,
            {solution.time,
             phase_extent(solution,
                          axis_number(vertical),
                          1.,
                          {axis_number(normal), position, position}) -
               floor});
      }

    private:
      std::string normal   = "x";
      double      position = 0.;
      std::string vertical = "y";
      double      floor    = 0.;
      Schedule    schedule;
      CsvFile     file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ColumnHeight,
                   "column height",
                   "the highest point of the first fluid in a plane, for "
                   "example at a wall; writes column_height.csv.")
} // namespace Thalweg
