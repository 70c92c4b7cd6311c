// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/point_patches.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    void
    write_population(const Population<dim> &population,
                     const FlowView<dim>   &solution,
                     Context               &context,
                     PvdRecord             &record)
    {
      std::vector<std::string> names{"id"};
      names.insert(names.end(), dim, "velocity");
      for (const char *name : {"level_set", "volume", "fluid"})
        names.emplace_back(name);
      for (const std::string &name : population.added_properties())
        names.push_back(name);
      PointPatches<dim> data(names, population.n_particles());
      std::size_t       i = 0;
      for (const auto &particle : population.particles())
        {
          auto &numbers = data.set(i++, particle.position());
          numbers(0, 0) = particle.id();
          for (unsigned int k = 0; k < population.row_length(); ++k)
            numbers(1 + k, 0) = particle.properties()[k];
        }
      record.write(context, data, solution.time, solution.step);
    }



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
      write(Context &context, const FlowView<dim> &solution) override
      {
        write_population(solution.population, solution, context, this->record);
      }
    };



    /// Drops and bubbles for ParaView.
    template <int dim>
    class DispersedOutput : public SeriesOutput<dim>
    {
    public:
      DispersedOutput()
        : SeriesOutput<dim>("dispersed")
      {}

      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(outline.has_dispersed,
                    dealii::ExcMessage(
                      "There are neither drops nor bubbles in this run, see "
                      "'Particles/Spray': take 'dispersed' out of "
                      "'Postprocess/Models'."));
      }

    private:
      void
      write(Context &context, const FlowView<dim> &solution) override
      {
        write_population(*solution.dispersed, solution, context, this->record);
      }
    };
  } // namespace

  THALWEG_REGISTER(
    Postprocessor,
    ParticleOutput,
    "particles",
    "the particles with number, velocity, level set, volume and fluid, "
    "for ParaView; writes particles.pvd.")
  THALWEG_REGISTER(
    Postprocessor,
    DispersedOutput,
    "dispersed",
    "drops and bubbles that the mesh does not see, in the same way; "
    "writes dispersed.pvd.")
} // namespace Thalweg
