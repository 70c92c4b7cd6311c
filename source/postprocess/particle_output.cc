// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/particles/data_out.h>

namespace Thalweg
{
  namespace
  {
    /// The particles for ParaView.
    template <int dim>
    class ParticleOutput : public SeriesOutput<dim>
    {
    public:
      ParticleOutput()
        : SeriesOutput<dim>("particles")
      {}

    private:
      void
      write(Context &context, const SolutionView<dim> &solution) override
      {
        using namespace dealii::DataComponentInterpretation;
        std::vector<std::string>                 names(dim, "velocity");
        std::vector<DataComponentInterpretation> interpretations(
          dim, component_is_part_of_vector);
        for (const char *name : {"level_set", "volume"})
          {
            names.push_back(name);
            interpretations.push_back(component_is_scalar);
          }

        dealii::Particles::DataOut<dim> data;
        data.build_patches(solution.population.handler(),
                           names,
                           interpretations);
        this->record.write(context, data, solution.time, solution.step);
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ParticleOutput,
                   "particles",
                   "the particles with number, velocity, level set and volume, "
                   "for ParaView; writes particles.pvd.")
} // namespace Thalweg
