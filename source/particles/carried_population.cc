// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/carried_population.h>
#include <thalweg/particles/sub_cell.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Whether a particle is in the cell between two corners, or near it, and
    /// carries numbers.
    template <typename Particle, int dim>
    bool
    is_good(const Particle           &particle,
            const dealii::Point<dim> &first,
            const dealii::Point<dim> &last)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (!(std::abs(particle.reference()[d] - .5) <= 1.))
          return false;
      const auto properties = particle.properties();
      return particle.position().distance(first) <=
               10. * first.distance(last) &&
             std::all_of(properties.begin(),
                         properties.end(),
                         [](const double value) {
                           return std::isfinite(value);
                         });
    }
  } // namespace



  template <int dim>
  void
  CarriedPopulation<dim>::save()
  {
    saved.save(population);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::restore()
  {
    saved.restore(population);
  }



  template <int dim>
  void
  CarriedPopulation<dim>::clear()
  {
    population.clear();
  }



  template <int dim>
  void
  CarriedPopulation<dim>::pack(const CellIterator    &cell,
                               const Compat::CellFate fate,
                               std::vector<char>     &bytes) const
  {
    const bool is_coarsened = fate == Compat::CellFate::is_coarsened;
    const auto sources =
      this->cells_before(population.mesh().graph(), cell, fate);
    std::uint32_t n = 0;
    for (const unsigned int source : sources)
      n += saved.n_in_cell(source);
    append_plain(bytes, n);
    for (unsigned int c = 0; c < sources.size(); ++c)
      for (const auto &particle : saved.in_cell(sources[c]))
        {
          append_plain(bytes, particle.id());
          append_plain(bytes, particle.position());
          append_plain(bytes,
                       is_coarsened ? to_parent<dim>(particle.reference(), c)
                                    : particle.reference());
          for (const double property : particle.properties())
            append_plain(bytes, property);
        }
  }



  template <int dim>
  void
  CarriedPopulation<dim>::begin_to_unpack()
  {
    population.clear();
    received = ParticleRows<dim>(population.row_length());
    cells.clear();
  }



  template <int dim>
  void
  CarriedPopulation<dim>::unpack(const CellIterator    &cell,
                                 const Compat::CellFate fate,
                                 PlainReader           &reader)
  {
    std::uint32_t n = 0;
    reader.read(n);
    std::vector<double> row(population.row_length());
    for (std::uint32_t i = 0; i < n; ++i)
      {
        ParticleId         id;
        ParticlePlace<dim> place;
        reader.read(id);
        reader.read(place.position);
        reader.read(place.reference);
        for (double &property : row)
          reader.read(property);
        cells.push_back(find_cell(cell, fate, place));
        received.append(id, place, row.data());
      }
  }



  template <int dim>
  unsigned int
  CarriedPopulation<dim>::find_cell(const CellIterator    &cell,
                                    const Compat::CellFate fate,
                                    ParticlePlace<dim>    &place) const
  {
    const CellGraph<dim> &graph = population.mesh().graph();
    const unsigned int    index =
      find_cell_after(graph, cell, fate, place.reference);
    // Where boundaries are curved, children do not lie in their parents.
    if (fate != Compat::CellFate::persists && !graph.cell(index).axis_parallel)
      place.position =
        Q1::position<dim>(graph.cell(index).vertices, place.reference);
    return index;
  }



  template <int dim>
  void
  CarriedPopulation<dim>::check_unpacked() const
  {
    for (unsigned int i = 0; i < cells.size(); ++i)
      {
        const auto &vertices =
          population.mesh().graph().cell(cells[i]).vertices;
        AssertThrow(is_good(received[i], vertices.front(), vertices.back()),
                    dealii::ExcMessage("it has particles that cannot be "
                                       "where it says."));
      }
  }



  template <int dim>
  void
  CarriedPopulation<dim>::end_to_unpack()
  {
    population.replace(received, cells);
    received = ParticleRows<dim>(population.row_length());
    cells    = {};
  }



  THALWEG_INSTANTIATE(CarriedPopulation)
} // namespace Thalweg
