#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

namespace Thalweg
{
  namespace
  {
    /// Where the fluids are on average, and how fast they move.
    template <int dim>
    class CenterOfMass : public Postprocessor<dim>
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
          for (const std::string quantity : {"center", "velocity"})
            for (unsigned int d = 0; d < dim; ++d)
              columns.push_back(solution.fluids[f].name + " " + quantity + " " +
                                "xyz"[d] +
                                (quantity == "center" ? " [m]" : " [m/s]"));
        file.open(context, "center_of_mass.csv", columns);
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        const auto          phases = integrate_phases(solution);
        std::vector<double> row{solution.time};
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          for (const auto &moment :
               {phases[f].moment_of_position, phases[f].moment_of_velocity})
            for (unsigned int d = 0; d < dim; ++d)
              row.push_back(moment[d] / phases[f].volume);
        file.write_row(context, row);
      }

    private:
      Schedule schedule;
      CsvFile  file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   CenterOfMass,
                   "center of mass",
                   "each fluid's centre of mass and its velocity; writes "
                   "center_of_mass.csv.")
} // namespace Thalweg
