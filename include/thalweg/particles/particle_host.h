// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_particle_host_h
#define thalweg_particles_particle_host_h

#include <thalweg/particles/population.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief What a method with particles offers others from its creation on,
   * under "particles": they may let its particles carry more.
   *
   * Whatever is added goes along with the particles: through cells, to other
   * ranks and meshes, into checkpoints and files. Where particles merge, their
   * volumes are the weights of its mean. New particles have
   * Population::unknown of it, until who has added it gives them a value.
   */
  template <int dim>
  class ParticleHost
  {
  public:
    virtual ~ParticleHost() = default;

    /// Before there are particles. @param inflow what comes in has of it.
    /// @return its place in the properties of a particle.
    /// @throws dealii::ExcMessage if there is one of that name
    virtual unsigned int
    add_property(const std::string &name, const InflowValue<dim> &inflow) = 0;

    virtual Population<dim> &
    population() = 0;

    /// Drops and bubbles, which carry the same; nullptr where there can be
    /// none.
    virtual const Population<dim> *
    dispersed() const
    {
      return nullptr;
    }
  };
} // namespace Thalweg

#endif
