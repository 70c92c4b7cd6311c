#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <deal.II/particles/data_out.h>

namespace Thalweg
{
  namespace
  {
    /// The particles for ParaView.
    template <int dim>
    class ParticleOutput : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        schedule.declare_parameters(section, "files");
      }


      void
      initialize(Context &context, const SolutionView<dim> &) override
      {
        record.open(context, "particles");
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        using namespace dealii::DataComponentInterpretation;
        std::vector<std::string>                 names(dim, "velocity");
        std::vector<DataComponentInterpretation> interpretations(
          dim, component_is_part_of_vector);
        names.push_back("level_set");
        interpretations.push_back(component_is_scalar);

        dealii::Particles::DataOut<dim> data;
        data.build_patches(solution.population.handler(),
                           names,
                           interpretations);
        record.write(context, data, solution.time, solution.step);
      }

    private:
      Schedule  schedule{0.05};
      PvdRecord record;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ParticleOutput,
                   "particles",
                   "the particles with number, velocity and level set, for "
                   "ParaView; writes particles.pvd.")
} // namespace Thalweg
