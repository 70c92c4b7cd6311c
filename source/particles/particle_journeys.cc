// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/cell_order.h>
#include <thalweg/particles/belongings.h>
#include <thalweg/particles/journey.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/path_field.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Thalweg
{
  namespace
  {
    template <typename Field>
    using ParticleTraveller = Traveller<typename Field::WalkerType, Origin>;

    /// The cells where travellers have arrived.
    template <typename TravellerType>
    std::vector<unsigned int>
    cells_of_arrival(const std::vector<TravellerType> &travellers)
    {
      std::vector<unsigned int> cells(travellers.size(),
                                      dealii::numbers::invalid_unsigned_int);
      for (unsigned int i = 0; i < travellers.size(); ++i)
        if (travellers[i].walker.fate == Fate::arrived)
          cells[i] = travellers[i].walker.cell;
      return cells;
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
    template <int dim, typename WalkerType>
    void
    count_missing(const CellGraph<dim>                  &graph,
                  const WalkerType                      &walker,
                  const ParticleId                       id,
                  const dealii::ArrayView<const double> &properties,
                  ConvectionReport                      &report)
    {
      const unsigned int fluid  = Population<dim>::fluid_of(properties);
      const double       volume = properties[Population<dim>::volume_offset];
      if (walker.fate == Fate::left)
        {
          ++report.left[walker.boundary][fluid];
          report.exits.push_back({walker.cell, walker.face, fluid, volume});
        }
      else if (walker.fate == Fate::lost)
        {
          ++report.n_lost;
          report.lost_volume[fluid] += volume;
          if (id < report.first_lost.id)
            report.first_lost = {id, centre<dim>(graph.cell(walker.cell))};
        }
    }

    /// Makes a drop or a bubble of a particle that sets out.
    template <int dim>
    void
    launch(const DispersedField<dim>                     &field,
           const typename Population<dim>::ConstParticle &particle,
           typename DispersedField<dim>::WalkerType      &walker)
    {
      const auto properties = particle.properties();
      field.launch(walker,
                   particle.position(),
                   Population<dim>::fluid_of(properties),
                   Population<dim>::velocity_of(properties),
                   properties[Population<dim>::volume_offset]);
    }

    /// Lets each particle walk as far as this rank reaches.
    template <int dim, typename Field>
    std::vector<ParticleTraveller<Field>>
    depart(const Population<dim>            &population,
           const StreamlineWalk<dim, Field> &walk,
           const double                      dt,
           WalkEffort                       &effort)
    {
      const auto        &mesh = population.mesh();
      const unsigned int here = dealii::Utilities::MPI::this_mpi_process(
        mesh.triangulation().get_communicator());
      std::vector<ParticleTraveller<Field>> travellers;
      travellers.reserve(population.n_particles());
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        for (const auto &particle : population.in_cell(c))
          {
            const unsigned int index = travellers.size();
            travellers.push_back(
              {Field::WalkerType::start(c, particle.reference(), dt),
               {here, index}});
            auto &walker = travellers.back().walker;
            if constexpr (Field::disperses)
              launch<dim>(walk.field(), particle, walker);
            walk.walk(walker, effort);
          }
      return travellers;
    }

    /// Puts a particle where it has arrived, as it is there now.
    template <int dim, typename Field>
    void
    put(const StreamlineWalk<dim, Field>                 &walk,
        const typename Field::WalkerType                 &walker,
        const typename ParticleRows<dim>::ConstReference &particle,
        const ParticleId                                  id,
        ParticleRows<dim>                                &arrived)
    {
      double *const row =
        arrived.append(id,
                       {walk.position(walker), walker.reference_point()},
                       particle.properties().data());
      if constexpr (Field::accelerates)
        for (unsigned int d = 0; d < dim; ++d)
          row[Population<dim>::velocity_offset + d] += walker.integral[d];
      else
        (void)row;
    }

    /// Makes those of the travellers that have arrived the population.
    template <int dim, typename Field>
    void
    arrive(Population<dim>                             &population,
           const StreamlineWalk<dim, Field>            &walk,
           const std::vector<ParticleTraveller<Field>> &travellers,
           const Belongings<dim>                       &belongings)
    {
      CellOrder  order(cells_of_arrival(travellers),
                      walk.graph().n_owned_cells());
      const auto particle = [&](const unsigned int i) {
        return belongings(i, travellers[i].luggage);
      };
      ParticleRows<dim> arrived = population.take_spare();
      arrived.reserve(order.things.size());
      for (unsigned int c = 0; c < walk.graph().n_owned_cells(); ++c)
        {
          const auto begin = order.things.begin() + order.begin[c];
          const auto end   = order.things.begin() + order.begin[c + 1];
          std::sort(begin,
                    end,
                    [&](const unsigned int a, const unsigned int b) {
                      return particle(a).id() < particle(b).id();
                    });
          for (auto i = begin; i != end; ++i)
            put(walk,
                travellers[*i].walker,
                particle(*i),
                particle(*i).id(),
                arrived);
        }
      population.exchange(std::move(arrived), std::move(order.begin));
    }

    /// Lets all particles travel; those that have arrived are the population
    /// then. @param meet called as `meet(walker, particle)` for each of the
    /// others that ended on this rank
    template <int dim, typename Field, typename Meet>
    void
    travel(Population<dim>                  &population,
           const StreamlineWalk<dim, Field> &walk,
           const double                      dt,
           ConvectionReport                 &report,
           const Meet                       &meet)
    {
      Assert(dt >= 0, dealii::ExcMessage("Particles only go forward in time."));
      const MPI_Comm communicator =
        population.mesh().triangulation().get_communicator();
      WalkEffort effort;
      auto       travellers = depart(population, walk, dt, effort);
      walk_on_other_ranks(walk, communicator, travellers, effort);
      const Belongings<dim> belongings(population.all(),
                                       communicator,
                                       travellers);
      report.n_moved         = travellers.size();
      report.n_substeps      = effort.n_substeps;
      report.n_cells_crossed = effort.n_cells_crossed;
      for (unsigned int i = 0; i < travellers.size(); ++i)
        if (const auto &[walker, origin] = travellers[i];
            walker.fate != Fate::arrived)
          {
            const auto particle = belongings(i, origin);
            count_missing<dim>(walk.graph(),
                               walker,
                               particle.id(),
                               particle.properties(),
                               report);
            meet(walker, particle);
          }
      arrive(population, walk, travellers, belongings);
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
    travel(population, walk, dt, report, [](const auto &, const auto &) {});
    return report;
  }


  template <int dim>
  Dispersal<dim>
  disperse_along(Population<dim>                                &population,
                 const StreamlineWalk<dim, DispersedField<dim>> &walk,
                 const double                                    dt)
  {
    Dispersal<dim> dispersal;
    travel(population,
           walk,
           dt,
           dispersal.report,
           [&](const auto &walker, const auto &particle) {
             if (walker.fate != Fate::landed)
               return;
             const auto       row = particle.properties();
             NewParticle<dim> landed{walker.cell,
                                     walker.reference_point(),
                                     walker.time,
                                     {row.begin(), row.end()}};
             for (unsigned int d = 0; d < dim; ++d)
               landed.properties[Population<dim>::velocity_offset + d] +=
                 walker.integral[d];
             dispersal.landed.push_back(landed);
             dispersal.accelerations.push_back(walker.acceleration);
           });
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
    const unsigned int here =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    ConvectionReport                      report;
    WalkEffort                            effort;
    std::vector<ParticleTraveller<Field>> travellers;
    ParticleRows<dim>                     rows(population.row_length());
    for (const NewParticle<dim> &particle : particles)
      {
        AssertDimension(particle.properties.size(), rows.n_properties());
        const unsigned int index = travellers.size();
        travellers.push_back(
          {Walker<dim>::start(particle.cell, particle.reference, particle.time),
           {here, index}});
        // A number is given where the way ends.
        rows.append(0, {}, particle.properties.data());
        walk.walk(travellers.back().walker, effort);
      }
    walk_on_other_ranks(walk, communicator, travellers, effort);
    const Belongings<dim> belongings(rows, communicator, travellers);

    ParticleRows<dim>         arrived(population.row_length());
    std::vector<unsigned int> cells;
    for (unsigned int i = 0; i < travellers.size(); ++i)
      {
        const auto &[walker, origin] = travellers[i];
        const auto       particle    = belongings(i, origin);
        const ParticleId id          = population.next_id();
        if (walker.fate != Fate::arrived)
          {
            count_missing<dim>(
              walk.graph(), walker, id, particle.properties(), report);
            continue;
          }
        put(walk, walker, particle, id, arrived);
        cells.push_back(walker.cell);
      }
    population.insert(arrived, cells);
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
