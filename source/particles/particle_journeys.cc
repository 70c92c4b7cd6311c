#include <thalweg/core/registry.h>
#include <thalweg/particles/particle_journeys.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// The numbers of the travellers that have arrived, cell by cell.
    struct Arrivals
    {
      /// Of each cell and behind the last one.
      std::vector<unsigned int> begin;
      std::vector<unsigned int> travellers;
    };

    template <int dim>
    Arrivals
    arrivals(const std::vector<Traveller<dim, Particle<dim>>> &travellers,
             const unsigned int                                n_cells)
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

    /// Writes a particle over another one of the same cell.
    template <int dim>
    void
    overwrite(dealii::Particles::ParticleAccessor<dim> &place,
              const dealii::Point<dim>                 &position,
              const dealii::Point<dim>                 &reference,
              const Particle<dim>                      &particle)
    {
      place.set_location(position);
      place.set_reference_location(reference);
      place.set_id(particle.id);
      std::copy(particle.properties.begin(),
                particle.properties.end(),
                place.get_properties().begin());
    }

    /// Whether the particles lie about in memory, so that loops over them
    /// have to wait: many were inserted where others had been removed.
    template <int dim>
    bool
    are_scattered(const Population<dim> &population)
    {
      const auto  &graph       = population.mesh().graph();
      std::size_t  n_particles = 0, n_jumps = 0;
      unsigned int next = 0;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (const auto &particle :
             population.handler().particles_in_cell(graph.iterator(c)))
          {
            const unsigned int index = particle.get_local_index();
            ++n_particles;
            n_jumps += index == next ? 0 : 1;
            next = index + 1;
          }
      return 4 * n_jumps > n_particles;
    }

    /// Puts the particles @p begin to @p end of @p travellers in a cell in
    /// place of those that are there: only the difference in number is
    /// inserted or removed, which costs several times more.
    template <int dim, typename Index>
    void
    store_in_cell(Population<dim>                                  &population,
                  const StreamlineWalk<dim>                        &walk,
                  const std::vector<Traveller<dim, Particle<dim>>> &travellers,
                  const unsigned int                                cell,
                  const Index                                       begin,
                  const Index                                       end)
    {
      auto              &handler = population.handler();
      const auto        &where   = walk.graph().iterator(cell);
      const unsigned int n_old   = handler.n_particles_in_cell(where);
      const unsigned int n_new   = end - begin;

      auto place = handler.particles_in_cell(where).begin();
      for (unsigned int k = 0; k < n_new; ++k)
        {
          const auto &[walker, particle] = travellers[begin[k]];
          dealii::Point<dim> reference;
          for (unsigned int d = 0; d < dim; ++d)
            reference[d] = walker.reference[d];
          if (k < n_old)
            {
              overwrite(*place, walk.position(walker), reference, particle);
              ++place;
            }
          else
            handler.insert_particle(
              walk.position(walker),
              reference,
              particle.id,
              where,
              dealii::ArrayView<const double>(particle.properties.data(),
                                              particle.properties.size()));
        }
      for (unsigned int k = n_old; k > n_new; --k)
        {
          auto last = handler.particles_in_cell(where).begin();
          for (unsigned int i = 1; i < k; ++i)
            ++last;
          handler.remove_particle(last);
        }
    }
  } // namespace



  template <int dim>
  std::vector<Traveller<dim, Particle<dim>>>
  depart(const Population<dim>     &population,
         const StreamlineWalk<dim> &walk,
         const double               dt,
         WalkEffort                &effort)
  {
    const auto &handler = population.handler();
    const auto &graph   = population.mesh().graph();

    std::vector<Traveller<dim, Particle<dim>>> travellers;
    travellers.reserve(handler.n_locally_owned_particles());
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (const auto &particle : handler.particles_in_cell(graph.iterator(c)))
        {
          Traveller<dim, Particle<dim>> traveller;
          traveller.walker =
            Walker<dim>::start(c, particle.get_reference_location(), dt);
          traveller.luggage.id  = particle.get_id();
          const auto properties = particle.get_properties();
          std::copy(properties.begin(),
                    properties.end(),
                    traveller.luggage.properties.begin());
          walk.walk(traveller.walker, effort);
          travellers.push_back(traveller);
        }
    return travellers;
  }



  template <int dim>
  std::size_t
  arrive(Population<dim>                                  &population,
         const StreamlineWalk<dim>                        &walk,
         const std::vector<Traveller<dim, Particle<dim>>> &travellers)
  {
    const auto &graph   = walk.graph();
    auto        arrived = arrivals<dim>(travellers, graph.n_owned_cells());
    const auto  by_id   = [&](const unsigned int a, const unsigned int b) {
      return travellers[a].luggage.id < travellers[b].luggage.id;
    };
    if (are_scattered(population))
      {
        population.handler().clear_particles();
        population.handler().reserve(arrived.travellers.size());
      }
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto begin = arrived.travellers.begin() + arrived.begin[c];
        const auto end   = arrived.travellers.begin() + arrived.begin[c + 1];
        std::sort(begin, end, by_id);
        store_in_cell<dim>(population, walk, travellers, c, begin, end);
      }
    population.handler().update_cached_numbers();
    return arrived.travellers.size();
  }



  template std::vector<Traveller<2, Particle<2>>>
  depart<2>(const Population<2> &,
            const StreamlineWalk<2> &,
            const double,
            WalkEffort &);
  template std::vector<Traveller<3, Particle<3>>>
  depart<3>(const Population<3> &,
            const StreamlineWalk<3> &,
            const double,
            WalkEffort &);
  template std::size_t
  arrive<2>(Population<2> &,
            const StreamlineWalk<2> &,
            const std::vector<Traveller<2, Particle<2>>> &);
  template std::size_t
  arrive<3>(Population<3> &,
            const StreamlineWalk<3> &,
            const std::vector<Traveller<3, Particle<3>>> &);
} // namespace Thalweg
