// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/dispersed_phase.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

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
      for (const auto &particle : population.in_cell(cell))
        {
          const auto         properties = particle.properties();
          const unsigned int fluid      = Population<dim>::fluid_of(properties);
          content.volumes[fluid] += properties[Population<dim>::volume_offset];
          ++content.numbers[fluid];
        }
    }



    /// Adds what @p acceleration brings in @p time to a velocity.
    template <int dim>
    void
    accelerate(double *const                  properties,
               const std::array<double, dim> &acceleration,
               const double                   time)
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
            accelerate<dim>(particle.properties.data(),
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
    for (const auto &particle : particles.in_cell(cell))
      {
        const unsigned int fluid =
          Population<dim>::fluid_of(particle.properties());
        if (!is_possible[fluid])
          continue;
        const double phi = Q1::value<dim>(values, particle.reference());
        if (fluid == 0 ? phi > far : phi < -far)
          migration.add(particle.index_in(particles.all()), cell);
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
  void
  DispersedPhase<dim>::take(Population<dim>            &population,
                            Migration                  &migration,
                            const DispersedMotion<dim> &motion,
                            const double                ahead)
  {
    std::vector<unsigned int> cells;
    for (unsigned int i = 0; i < migration.particles.size(); ++i)
      {
        const auto particle   = population.all()[migration.particles[i]];
        const auto properties = particle.properties();
        // One that only marks the fluid is neither drop nor bubble.
        if (!(properties[Population<dim>::volume_offset] > 0))
          continue;
        cells.push_back(migration.cells[i]);
        double *const row = migration.rows.append(particle);
        if (Population<dim>::fluid_of(properties) == 0)
          accelerate<dim>(row,
                          motion.acceleration(particle.position(),
                                              Population<dim>::velocity_of(
                                                properties)),
                          ahead);
      }
    population.remove(migration.particles);
    migration.cells.swap(cells);
  }



  template <int dim>
  void
  DispersedPhase<dim>::exchange(Population<dim>            &particles,
                                const CellField<dim, 1>    &level_set,
                                const DispersedMotion<dim> &motion,
                                const double                velocity_ahead)
  {
    const auto &graph = population.mesh().graph();
    Migration   going(particles), coming(population), unseen(particles);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto dispersed = std::as_const(population).in_cell(c);
        unseen.clear();
        find_unseen(particles, c, level_set, unseen);
        if (unseen.particles.empty() && dispersed.empty())
          continue;
        const auto stays = fill(particles, c);
        for (const unsigned int p : unseen.particles)
          if (!stays[Population<dim>::fluid_of(
                std::as_const(particles).all()[p].properties())])
            going.add(p, c);
        for (const auto &particle : dispersed)
          if (stays[Population<dim>::fluid_of(particle.properties())])
            coming.add(particle.index_in(population.all()), c);
      }
    take(particles, going, motion, -velocity_ahead);
    take(population, coming, motion, velocity_ahead);
    population.insert(going.rows, going.cells);
    particles.insert(coming.rows, coming.cells);
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
    for (const auto &particle : population.particles())
      {
        const auto properties = particle.properties();
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
