// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_population_h
#define thalweg_particles_population_h

#include <thalweg/core/archive.h>
#include <thalweg/mesh/mesh.h>

#include <deal.II/particles/particle_handler.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The particles: deal.II's ParticleHandler, and what each of them
   * carries.
   *
   * Properties of a particle, in this order: its velocity (dim components,
   * m/s), its level set value, negative in the denser fluid (dimension of
   * length, or just a sign, as the chosen interface representation says), the
   * volume of fluid that it carries (m^dim; zero is allowed: such a particle
   * only marks the fluid), and the number of that fluid. It keeps its fluid,
   * whatever becomes of the level set. Reference coordinates are always those
   * in the particle's cell.
   */
  template <int dim>
  class Population
  {
  public:
    static constexpr unsigned int velocity_offset  = 0;
    static constexpr unsigned int level_set_offset = dim;
    static constexpr unsigned int volume_offset    = dim + 1;
    static constexpr unsigned int fluid_offset     = dim + 2;
    static constexpr unsigned int n_properties     = dim + 3;

    using Handler  = dealii::Particles::ParticleHandler<dim>;
    using Iterator = typename Handler::particle_iterator;

    explicit Population(const Mesh<dim> &mesh);

    /// The number of the fluid that a particle belongs to.
    template <typename Properties>
    static unsigned int
    fluid_of(const Properties &properties)
    {
      return properties[fluid_offset] == 0. ? 0 : 1;
    }

    template <typename Properties>
    static std::array<double, dim>
    velocity_of(const Properties &properties)
    {
      std::array<double, dim> velocity;
      for (unsigned int d = 0; d < dim; ++d)
        velocity[d] = properties[velocity_offset + d];
      return velocity;
    }

    /// Gives a particle a level set value and the fluid that this says.
    template <typename Properties>
    static void
    set_level_set(Properties &&properties, const double value)
    {
      properties[level_set_offset] = value;
      properties[fluid_offset]     = value < 0 ? 0. : 1.;
    }

    Handler &
    handler()
    {
      return particle_handler;
    }

    const Handler &
    handler() const
    {
      return particle_handler;
    }

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    /**
     * @brief The next free particle id of this rank.
     *
     * Ids are unique over all ranks and do not depend on what other ranks
     * do: each rank has every n-th number for itself.
     * @throws dealii::ExcMessage when the ids are exhausted
     */
    dealii::types::particle_index
    next_id();

    /// From now on next_id() uses numbers from @p first_free on; to be called
    /// with the same number on all ranks, when particles with other ids were
    /// inserted.
    void
    reserve_ids_below(const dealii::types::particle_index first_free);

    /// Names which ids were given so far. Collective.
    void
    keep(const Archive &archive);

    /// The number of particles on all ranks. Collective.
    dealii::types::particle_index
    n_global_particles() const;

    /// What the particles of each owned cell of the graph carry of both
    /// fluids, m^dim.
    std::vector<std::array<double, 2>>
    volumes_of_cells() const;

  private:
    const Mesh<dim>              &mesh_;
    Handler                       particle_handler;
    dealii::types::particle_index first_id  = 0;
    dealii::types::particle_index n_created = 0;
  };
} // namespace Thalweg

#endif
