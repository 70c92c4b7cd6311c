// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/journey.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/particle_storage.h>
#include <thalweg/particles/path_field.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Thalweg
{
  namespace
  {
    /// What a particle takes along.
    template <int dim>
    struct Particle
    {
      dealii::types::particle_index                     id;
      std::array<double, Population<dim>::n_properties> properties;
    };

    template <int dim, typename Field>
    using ParticleTraveller =
      Traveller<typename Field::WalkerType, Particle<dim>>;

    /// The numbers of the travellers that have arrived, cell by cell, and of
    /// the others.
    struct Arrivals
    {
      /// Of each cell and behind the last one.
      std::vector<unsigned int> begin;
      std::vector<unsigned int> travellers;
      std::vector<unsigned int> missing;
    };

    template <typename TravellerType>
    Arrivals
    arrivals(const std::vector<TravellerType> &travellers,
             const unsigned int                n_cells)
    {
      constexpr unsigned int nowhere = dealii::numbers::invalid_unsigned_int;
      Arrivals               arrivals;
      arrivals.begin.resize(n_cells + 1, 0);
      std::vector<unsigned int> cells(travellers.size(), nowhere);
      for (unsigned int i = 0; i < travellers.size(); ++i)
        if (travellers[i].walker.fate == Fate::arrived)
          {
            cells[i] = travellers[i].walker.cell;
            ++arrivals.begin[cells[i] + 1];
          }
        else
          arrivals.missing.push_back(i);
      for (unsigned int c = 0; c < n_cells; ++c)
        arrivals.begin[c + 1] += arrivals.begin[c];

      arrivals.travellers.resize(arrivals.begin[n_cells]);
      std::vector<unsigned int> end(arrivals.begin.begin(),
                                    arrivals.begin.end() - 1);
      for (unsigned int i = 0; i < cells.size(); ++i)
        if (cells[i] != nowhere)
          arrivals.travellers[end[cells[i]]++] = i;
      return arrivals;
    }

    template <int dim>
    std::array<double, 3>
    centre(const typename CellGraph<dim>::Cell &cell)
    {
      std::array<double, 3> centre{};
      for (const auto &vertex : cell.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          centre[d] += vertex[d] / cell.vertices.size();
      return centre;
    }

    /// Counts one that did not arrive.
    template <int dim, typename TravellerType>
    void
    count_missing(const CellGraph<dim> &graph,
                  const TravellerType  &traveller,
                  ConvectionReport     &report)
    {
      const auto &[walker, particle] = traveller;
      const unsigned int fluid = Population<dim>::fluid_of(particle.properties);
      const double volume = particle.properties[Population<dim>::volume_offset];
      if (walker.fate == Fate::left)
        {
          ++report.left[walker.boundary][fluid];
          report.exits.push_back({walker.cell, walker.face, fluid, volume});
        }
      else if (walker.fate == Fate::lost)
        {
          ++report.n_lost;
          report.lost_volume[fluid] += volume;
          if (particle.id < report.first_lost.id)
            report.first_lost = {particle.id,
                                 centre<dim>(graph.cell(walker.cell))};
        }
    }

    /// Makes a drop or a bubble of a traveller.
    template <int dim>
    void
    launch(const DispersedField<dim>                   &field,
           const dealii::Point<dim>                    &place,
           ParticleTraveller<dim, DispersedField<dim>> &traveller)
    {
      const auto &properties = traveller.luggage.properties;
      field.launch(traveller.walker,
                   place,
                   Population<dim>::fluid_of(properties),
                   Population<dim>::velocity_of(properties),
                   properties[Population<dim>::volume_offset]);
    }

    /// Copies all particles out of the population, and lets each walk as far
    /// as this rank reaches.
    template <int dim, typename Field>
    std::vector<ParticleTraveller<dim, Field>>
    depart(const Population<dim>            &population,
           const StreamlineWalk<dim, Field> &walk,
           const double                      dt,
           WalkEffort                       &effort,
           ScatterCount                     &scatter)
    {
      const auto &handler = population.handler();
      const auto &graph   = population.mesh().graph();

      std::vector<ParticleTraveller<dim, Field>> travellers;
      travellers.reserve(handler.n_locally_owned_particles());
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (const auto &particle :
             handler.particles_in_cell(graph.iterator(c)))
          {
            travellers.emplace_back();
            auto &traveller = travellers.back();
            traveller.walker =
              Field::WalkerType::start(c,
                                       particle.get_reference_location(),
                                       dt);
            traveller.luggage.id  = particle.get_id();
            const auto properties = particle.get_properties();
            for (unsigned int k = 0; k < Population<dim>::n_properties; ++k)
              traveller.luggage.properties[k] = properties[k];
            scatter.add(particle.get_local_index());
            if constexpr (Field::disperses)
              launch(walk.field(), particle.get_location(), traveller);
            walk.walk(traveller.walker, effort);
          }
      return travellers;
    }

    /// What a traveller has become where it arrived.
    template <int dim, typename Field>
    ParticleRecord<dim>
    record_of(const StreamlineWalk<dim, Field>    &walk,
              const ParticleTraveller<dim, Field> &traveller)
    {
      const auto &[walker, particle] = traveller;
      ParticleRecord<dim> record;
      record.id         = particle.id;
      record.position   = walk.position(walker);
      record.reference  = walker.reference_point();
      record.properties = particle.properties;
      if constexpr (Field::accelerates)
        for (unsigned int d = 0; d < dim; ++d)
          record.properties[Population<dim>::velocity_offset + d] +=
            walker.integral[d];
      return record;
    }

    /// Makes those of the travellers that have arrived the population.
    template <int dim, typename Field>
    void
    arrive(Population<dim>                                  &population,
           const StreamlineWalk<dim, Field>                 &walk,
           const std::vector<ParticleTraveller<dim, Field>> &travellers,
           const ScatterCount                               &scatter,
           Arrivals                                         &arrived)
    {
      const auto by_id = [&](const unsigned int a, const unsigned int b) {
        return travellers[a].luggage.id < travellers[b].luggage.id;
      };
      prepare_storage(population, arrived.travellers.size(), scatter);
      for (unsigned int c = 0; c < walk.graph().n_owned_cells(); ++c)
        {
          const auto begin = arrived.travellers.begin() + arrived.begin[c];
          const auto end   = arrived.travellers.begin() + arrived.begin[c + 1];
          std::sort(begin, end, by_id);
          store_in_cell(population, c, end - begin, [&](const unsigned int k) {
            return record_of<dim, Field>(walk, travellers[begin[k]]);
          });
        }
      population.handler().update_cached_numbers();
    }

    /// Lets all particles travel, and returns all travellers that ended on
    /// this rank.
    template <int dim, typename Field>
    std::vector<ParticleTraveller<dim, Field>>
    travel(Population<dim>                  &population,
           const StreamlineWalk<dim, Field> &walk,
           const double                      dt,
           ConvectionReport                 &report)
    {
      Assert(dt >= 0, dealii::ExcMessage("Particles only go forward in time."));
      WalkEffort   effort;
      ScatterCount scatter;
      auto         travellers = depart(population, walk, dt, effort, scatter);
      walk_on_other_ranks(walk,
                          population.mesh().triangulation().get_communicator(),
                          travellers,
                          effort);
      Arrivals arrived = arrivals(travellers, walk.graph().n_owned_cells());
      arrive(population, walk, travellers, scatter, arrived);
      report.n_moved         = travellers.size();
      report.n_substeps      = effort.n_substeps;
      report.n_cells_crossed = effort.n_cells_crossed;
      for (const unsigned int i : arrived.missing)
        count_missing<dim>(walk.graph(), travellers[i], report);
      return travellers;
    }
  } // namespace


  WalkSettings
  walk_settings(const ConvectionParameters &parameters,
                const std::map<dealii::types::boundary_id, WallKind> &walls)
  {
    AssertThrow(parameters.substep_courant_number > 0 &&
                  parameters.substep_courant_number <= 1,
                dealii::ExcMessage(
                  "The 'Substep Courant number' of the particles must be "
                  "greater than 0 and not above 1, for example 0.5."));
    AssertThrow(parameters.integrator == "rk2" ||
                  parameters.integrator == "rk4",
                dealii::ExcMessage("The particles' 'Integrator' must be 'rk2' "
                                   "or 'rk4', not '" +
                                   parameters.integrator + "'."));
    WalkSettings settings;
    settings.scheme  = parameters.integrator == "rk2" ? StreamlineScheme::rk2
                                                      : StreamlineScheme::rk4;
    settings.substep = parameters.substep_courant_number;
    settings.walls   = walls;
    return settings;
  }


  template <int dim, typename Field>
  ConvectionReport
  move_along(Population<dim>                  &population,
             const StreamlineWalk<dim, Field> &walk,
             const double                      dt)
  {
    ConvectionReport report;
    travel(population, walk, dt, report);
    return report;
  }


  template <int dim>
  Dispersal<dim>
  disperse_along(Population<dim>                                &population,
                 const StreamlineWalk<dim, DispersedField<dim>> &walk,
                 const double                                    dt)
  {
    Dispersal<dim> dispersal;
    for (const auto &[walker, particle] :
         travel(population, walk, dt, dispersal.report))
      if (walker.fate == Fate::landed)
        {
          NewParticle<dim> landed{walker.cell,
                                  walker.reference_point(),
                                  walker.time,
                                  particle.properties};
          for (unsigned int d = 0; d < dim; ++d)
            landed.properties[Population<dim>::velocity_offset + d] +=
              walker.integral[d];
          dispersal.landed.push_back(landed);
          dispersal.accelerations.push_back(walker.acceleration);
        }
    return dispersal;
  }


  template <int dim>
  ConvectionReport
  insert_along(Population<dim>                     &population,
               const StreamlineWalk<dim>           &walk,
               const std::vector<NewParticle<dim>> &particles)
  {
    using Field = SteadyField<dim>;
    const MPI_Comm communicator =
      population.mesh().triangulation().get_communicator();
    ConvectionReport                           report;
    WalkEffort                                 effort;
    std::vector<ParticleTraveller<dim, Field>> travellers;
    for (const NewParticle<dim> &particle : particles)
      {
        // A number is given where the way ends.
        travellers.push_back(
          {Walker<dim>::start(particle.cell, particle.reference, particle.time),
           {0, particle.properties}});
        walk.walk(travellers.back().walker, effort);
      }
    walk_on_other_ranks(walk, communicator, travellers, effort);
    for (auto &traveller : travellers)
      {
        traveller.luggage.id = population.next_id();
        if (traveller.walker.fate != Fate::arrived)
          {
            count_missing<dim>(walk.graph(), traveller, report);
            continue;
          }
        const auto record = record_of<dim, Field>(walk, traveller);
        population.handler().insert_particle(
          record.position,
          record.reference,
          record.id,
          walk.graph().iterator(traveller.walker.cell),
          dealii::ArrayView<const double>(record.properties.data(),
                                          record.properties.size()));
      }
    population.handler().update_cached_numbers();
    report.n_moved = travellers.size();
    return report;
  }


  template ConvectionReport
  insert_along(Population<2> &,
               const StreamlineWalk<2> &,
               const std::vector<NewParticle<2>> &);
  template ConvectionReport
  insert_along(Population<3> &,
               const StreamlineWalk<3> &,
               const std::vector<NewParticle<3>> &);

  template Dispersal<2>
  disperse_along(Population<2> &,
                 const StreamlineWalk<2, DispersedField<2>> &,
                 const double);
  template Dispersal<3>
  disperse_along(Population<3> &,
                 const StreamlineWalk<3, DispersedField<3>> &,
                 const double);

#define INSTANTIATE(dim, Field)                     \
  template ConvectionReport move_along<dim, Field>( \
    Population<dim> &, const StreamlineWalk<dim, Field> &, const double);

  using Path21 = PathField<2, 1>;
  using Path22 = PathField<2, 2>;
  using Path31 = PathField<3, 1>;
  using Path32 = PathField<3, 2>;
  INSTANTIATE(2, SteadyField<2>)
  INSTANTIATE(2, Path21)
  INSTANTIATE(2, Path22)
  INSTANTIATE(3, SteadyField<3>)
  INSTANTIATE(3, Path31)
  INSTANTIATE(3, Path32)
} // namespace Thalweg
