// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// A table of what follows from the integrals over each fluid.
    template <int dim>
    class PhaseTable : public TableOutput<dim>
    {
    public:
      using TableOutput<dim>::TableOutput;

    private:
      /// The columns of a fluid, without its name.
      virtual std::vector<std::string>
      quantities() const = 0;

      /// As many values.
      virtual std::vector<double>
      values(const PhaseIntegrals<dim> &phase) const = 0;


      std::vector<std::string>
      columns(const FlowView<dim> &solution) override
      {
        std::vector<std::string> names;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          for (const std::string &quantity : quantities())
            names.push_back(solution.fluids[f].name + " " + quantity);
        return names;
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        const auto          phases = integrate_phases(solution);
        std::vector<double> all;
        for (unsigned int f = 0; f < solution.fluids.size(); ++f)
          for (const double value : values(phases[f]))
            all.push_back(value);
        return all;
      }
    };


    /// The volume of each fluid.
    template <int dim>
    class PhaseVolume : public PhaseTable<dim>
    {
    public:
      PhaseVolume()
        : PhaseTable<dim>("phase_volume.csv")
      {}

    private:
      std::vector<std::string>
      quantities() const override
      {
        return {"volume [" + length_unit(dim) + "]"};
      }


      std::vector<double>
      values(const PhaseIntegrals<dim> &phase) const override
      {
        return {phase.volume};
      }
    };


    /// Where the fluids are on average, and how fast they move.
    template <int dim>
    class CenterOfMass : public PhaseTable<dim>
    {
    public:
      CenterOfMass()
        : PhaseTable<dim>("center_of_mass.csv")
      {}

    private:
      std::vector<std::string>
      quantities() const override
      {
        std::vector<std::string> names;
        for (unsigned int d = 0; d < dim; ++d)
          names.push_back(std::string("center ") + "xyz"[d] + " [m]");
        for (unsigned int d = 0; d < dim; ++d)
          names.push_back(std::string("velocity ") + "xyz"[d] + " [m/s]");
        return names;
      }


      std::vector<double>
      values(const PhaseIntegrals<dim> &phase) const override
      {
        std::vector<double> result;
        for (unsigned int d = 0; d < dim; ++d)
          result.push_back(phase.moment_of_position[d] / phase.volume);
        for (unsigned int d = 0; d < dim; ++d)
          result.push_back(phase.moment_of_velocity[d] / phase.volume);
        return result;
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   PhaseVolume,
                   "phase volume",
                   "the volume of each fluid (in 2D its area); writes "
                   "phase_volume.csv.")
  THALWEG_REGISTER(Postprocessor,
                   CenterOfMass,
                   "center of mass",
                   "each fluid's centre of mass and its velocity; writes "
                   "center_of_mass.csv.")
} // namespace Thalweg
