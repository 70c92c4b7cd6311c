#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// Where the fluids are on average, and how fast they move.
    template <int dim>
    class CenterOfMass : public TableOutput<dim>
    {
    public:
      CenterOfMass()
        : TableOutput<dim>("center_of_mass.csv")
      {}

    private:
      std::vector<std::string>
      columns(const SolutionView<dim> &solution) override
      {
        std::vector<std::string> names;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          for (const std::string quantity : {"center", "velocity"})
            for (unsigned int d = 0; d < dim; ++d)
              names.push_back(solution.fluids[f].name + " " + quantity + " " +
                              "xyz"[d] +
                              (quantity == "center" ? " [m]" : " [m/s]"));
        return names;
      }


      std::vector<double>
      row(const SolutionView<dim> &solution) override
      {
        const auto          phases = integrate_phases(solution);
        std::vector<double> values;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          for (const auto &moment :
               {phases[f].moment_of_position, phases[f].moment_of_velocity})
            for (unsigned int d = 0; d < dim; ++d)
              values.push_back(moment[d] / phases[f].volume);
        return values;
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   CenterOfMass,
                   "center of mass",
                   "each fluid's centre of mass and its velocity; writes "
                   "center_of_mass.csv.")
} // namespace Thalweg
