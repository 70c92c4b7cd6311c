#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// The volume of each fluid.
    template <int dim>
    class PhaseVolume : public TableOutput<dim>
    {
    public:
      PhaseVolume()
        : TableOutput<dim>("phase_volume.csv")
      {}

    private:
      std::vector<std::string>
      columns(const SolutionView<dim> &solution) override
      {
        std::vector<std::string> names;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          names.push_back(solution.fluids[f].name + " volume [" +
                          length_unit(dim) + "]");
        return names;
      }


      std::vector<double>
      row(const SolutionView<dim> &solution) override
      {
        const auto          phases = integrate_phases(solution);
        std::vector<double> values;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          values.push_back(phases[f].volume);
        return values;
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   PhaseVolume,
                   "phase volume",
                   "the volume of each fluid (in 2D its area); writes "
                   "phase_volume.csv.")
} // namespace Thalweg
