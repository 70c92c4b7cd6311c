#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/phase_extent.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

namespace Thalweg
{
  namespace
  {
    /// The foremost point of fluid 0.
    template <int dim>
    class FrontPosition : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
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
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &) override
      {
        AssertThrow(limits.empty() ||
                      (limits.size() == 2 && limits[0] <= limits[1]),
                    dealii::ExcMessage(
                      "The 'Band' of the front position must be two "
                      "coordinates, the lesser one first, or empty."));
        if (!limits.empty())
          band = {axis_number(band_direction), limits[0], limits[1]};
        file.open(context,
                  "front_position.csv",
                  {"time [s]",
                   std::string("front ") + direction.back() + " [m]"});
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (schedule.is_due(solution.time, solution.last_step))
          file.write_row(context,
                         {solution.time,
                          phase_extent(solution,
                                       axis_number(direction),
                                       direction[0] == '-' ? -1. : 1.,
                                       band)});
      }

    private:
      std::string         direction      = "x";
      std::string         band_direction = "y";
      std::vector<double> limits;
      Schedule            schedule;
      Band                band;
      CsvFile             file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   FrontPosition,
                   "front position",
                   "how far the first fluid reaches in a direction; writes "
                   "front_position.csv.")
} // namespace Thalweg
