#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

namespace Thalweg
{
  namespace
  {
    /// The volume of each fluid.
    template <int dim>
    class PhaseVolume : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        std::vector<std::string> columns{"time [s]"};
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          columns.push_back(solution.fluids[f].name + " volume [" +
                            length_unit(dim) + "]");
        file.open(context, "phase_volume.csv", columns);
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        const auto          phases = integrate_phases(solution);
        std::vector<double> row{solution.time};
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          row.push_back(phases[f].volume);
        file.write_row(context, row);
      }

    private:
      Schedule schedule;
      CsvFile  file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   PhaseVolume,
                   "phase volume",
                   "the volume of each fluid (in 2D its area); writes "
                   "phase_volume.csv.")
} // namespace Thalweg
