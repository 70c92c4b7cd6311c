// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/dispersed_phase.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// How far from the interface the mesh sees nothing of the other fluid,
    /// in parts of the shortest edge.
    constexpr double beyond = .5;



    /// What there is of both fluids in a cell.
    struct Content
    {
      std::array<double, 2>       volumes{}; ///< m^dim
      std::array<unsigned int, 2> numbers{};
    };



    template <int dim>
    void
    add(const Population<dim> &population,
        const unsigned int     cell,
        Content               &content)
    {
      for (const auto &particle : population.handler().particles_in_cell(
             population.mesh().graph().iterator(cell)))
        {
          const auto         properties = particle.get_properties();
          const unsigned int fluid      = Population<dim>::fluid_of(properties);
          content.volumes[fluid] += properties[Population<dim>::volume_offset];
          ++content.numbers[fluid];
        }
    }



    /// Adds what @p acceleration brings in @p time to a velocity.
    template <int dim>
    void
    accelerate(std::array<double, Population<dim>::n_properties> &properties,
               const std::array<double, dim>                     &acceleration,
               const double                                       time)
    {
      for (unsigned int d = 0; d < dim; ++d)
        properties[Population<dim>::velocity_offset + d] +=
          time * acceleration[d];
    }

  } // namespace



  template <int dim>
  DispersedPhase<dim>::DispersedPhase(
    Population<dim>                                      &population,
    const ConvectionParameters                           &parameters,
    const std::map<dealii::types::boundary_id, WallKind> &walls)
    : population(population)
    , settings(walk_settings(parameters, walls))
  {}



  template <int dim>
  ConvectionReport
  DispersedPhase<dim>::move(const CellField<dim, 1>       &level_set,
                            const CellVelocity<dim>       &velocity,
                            const DispersedMotion<dim>    &motion,
                            const double                   dt,
                            const double                   velocity_ahead,
                            std::vector<NewParticle<dim>> &landed)
  {
    const auto &graph = population.mesh().graph();
    const StreamlineWalk<dim, DispersedField<dim>> walk(
      graph,
      DispersedField<dim>(graph, level_set, velocity, settings.substep, motion),
      settings);
    Dispersal<dim> dispersal = disperse_along(population, walk, dt);
    for (unsigned int i = 0; i < dispersal.landed.size(); ++i)
      {
        NewParticle<dim> &particle = dispersal.landed[i];
        // It is inside of its own fluid from now on.
        double &own = particle.properties[Population<dim>::level_set_offset];
        const double phi =
          Q1::value<dim>(level_set[particle.cell], particle.reference);
        if (Population<dim>::fluid_of(particle.properties) == 0)
          {
            own = std::min(own, phi);
            accelerate<dim>(particle.properties,
                            dispersal.accelerations[i],
                            velocity_ahead - (dt - particle.time));
          }
        else
          {
            own = std::max(own, phi);
            const auto v =
              Q1::value<dim, dim>(velocity[particle.cell], particle.reference);
            std::copy(v.begin(),
                      v.end(),
                      particle.properties.begin() +
                        Population<dim>::velocity_offset);
          }
      }
    landed                           = std::move(dispersal.landed);
    dispersal.report.dispersed_exits = std::move(dispersal.report.exits);
    dispersal.report.exits.clear();
    return dispersal.report;
  }



  template <int dim>
  void
  DispersedPhase<dim>::find_unseen(const Population<dim>   &particles,
                                   const unsigned int       cell,
                                   const CellField<dim, 1> &level_set,
                                   Migration               &migration) const
  {
    const auto  &graph  = particles.mesh().graph();
    const auto  &values = level_set[cell];
    const double far    = beyond * graph.cell(cell).edges().first;
    const auto [least, most] =
      std::minmax_element(values.begin(), values.end());
    const std::array<bool, 2> is_possible{{*most > far, *least < -far}};
    if (!is_possible[0] && !is_possible[1])
      return;
    const auto inside =
      particles.handler().particles_in_cell(graph.iterator(cell));
    for (auto particle = inside.begin(); particle != inside.end(); ++particle)
      {
        const unsigned int fluid =
          Population<dim>::fluid_of(particle->get_properties());
        if (!is_possible[fluid])
          continue;
        const double phi =
          Q1::value<dim>(values, particle->get_reference_location());
        if (fluid == 0 ? phi > far : phi < -far)
          migration.add(particle, cell);
      }
  }



  template <int dim>
  std::array<bool, 2>
  DispersedPhase<dim>::fill(const Population<dim> &particles,
                            const unsigned int     cell) const
  {
    Content content;
    add(particles, cell, content);
    add(population, cell, content);
    // A single particle that carries much is still seen by nobody.
    const double measure = particles.mesh().graph().cell(cell).measure;
    return {
      {content.volumes[0] >= measure && content.numbers[0] > content.numbers[1],
       content.volumes[1] >= measure &&
         content.numbers[1] > content.numbers[0]}};
  }



  template <int dim>
  std::vector<ParticleRecord<dim>>
  DispersedPhase<dim>::take(Population<dim>            &population,
                            const Migration            &migration,
                            const DispersedMotion<dim> &motion,
                            const double                ahead)
  {
    std::vector<ParticleRecord<dim>> records;
    for (const Iterator &particle : migration.particles)
      {
        ParticleRecord<dim> record = record_of(*particle);
        if (Population<dim>::fluid_of(record.properties) == 0)
          accelerate<dim>(record.properties,
                          motion.acceleration(record.position,
                                              Population<dim>::velocity_of(
                                                record.properties)),
                          ahead);
        records.push_back(record);
      }
    const MPI_Comm communicator =
      population.mesh().triangulation().get_communicator();
    if (dealii::Utilities::MPI::max(records.size(), communicator) > 0)
      population.handler().remove_particles(migration.particles);
    return records;
  }



  template <int dim>
  void
  DispersedPhase<dim>::give(Population<dim>                        &population,
                            const Migration                        &migration,
                            const std::vector<ParticleRecord<dim>> &records)
  {
    const auto &mesh = population.mesh();
    for (unsigned int i = 0; i < records.size(); ++i)
      // One that only marks the fluid is neither drop nor bubble.
      if (records[i].properties[Population<dim>::volume_offset] > 0)
        population.handler().insert_particle(
          records[i].position,
          records[i].reference,
          records[i].id,
          mesh.graph().iterator(migration.cells[i]),
          dealii::ArrayView<const double>(records[i].properties.data(),
                                          records[i].properties.size()));
    const MPI_Comm communicator = mesh.triangulation().get_communicator();
    if (dealii::Utilities::MPI::max(records.size(), communicator) > 0)
      population.handler().update_cached_numbers();
  }



  template <int dim>
  void
  DispersedPhase<dim>::exchange(Population<dim>            &particles,
                                const CellField<dim, 1>    &level_set,
                                const DispersedMotion<dim> &motion,
                                const double                velocity_ahead)
  {
    const auto &graph = population.mesh().graph();
    Migration   going, coming, unseen;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto dispersed =
          population.handler().particles_in_cell(graph.iterator(c));
        unseen = Migration();
        find_unseen(particles, c, level_set, unseen);
        if (unseen.particles.empty() && dispersed.begin() == dispersed.end())
          continue;
        const auto stays = fill(particles, c);
        const auto fluid = [](const auto &particle) {
          return Population<dim>::fluid_of(particle->get_properties());
        };
        for (const Iterator &particle : unseen.particles)
          if (!stays[fluid(particle)])
            going.add(particle, c);
        for (auto p = dispersed.begin(); p != dispersed.end(); ++p)
          if (stays[fluid(p)])
            coming.add(p, c);
      }
    const auto gone = take(particles, going, motion, -velocity_ahead);
    const auto come = take(population, coming, motion, velocity_ahead);
    give(population, going, gone);
    give(particles, coming, come);
  }



  template <int dim>
  bool
  DispersedPhase<dim>::is_empty() const
  {
    return population.n_global_particles() == 0;
  }



  template <int dim>
  void
  DispersedPhase<dim>::limit(const PopulationControl<dim> &control)
  {
    control.limit(population);
  }



  template <int dim>
  std::array<double, 2>
  DispersedPhase<dim>::volumes() const
  {
    std::array<double, 2> sums{};
    for (const auto &particle : population.handler())
      {
        const auto properties = particle.get_properties();
        sums[Population<dim>::fluid_of(properties)] +=
          properties[Population<dim>::volume_offset];
      }
    const MPI_Comm communicator =
      population.mesh().triangulation().get_communicator();
    for (double &sum : sums)
      sum = dealii::Utilities::MPI::sum(sum, communicator);
    return sums;
  }



  THALWEG_INSTANTIATE(DispersedPhase)
} // namespace Thalweg
