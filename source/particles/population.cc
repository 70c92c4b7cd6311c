// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/mesh/cell_order.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  Population<dim>::Population(const Mesh<dim> &mesh)
    : mesh_(mesh)
    , rows(n_properties)
    , spare(n_properties)
  {}


  template <int dim>
  unsigned int
  Population<dim>::add_property(const std::string      &name,
                                const InflowValue<dim> &inflow)
  {
    Assert(rows.size() == 0,
           dealii::ExcMessage("Properties are added before particles."));
    AssertThrow(std::find(names.begin(), names.end(), name) == names.end(),
                dealii::ExcMessage("Particles carry a '" + name +
                                   "' already: give one of the two another "
                                   "name."));
    names.push_back(name);
    inflow_values.push_back(inflow);
    rows = ParticleRows<dim>(rows.n_properties() + 1);
    return rows.n_properties() - 1;
  }


  template <int dim>
  void
  Population<dim>::clear()
  {
    rows.clear();
    begin.clear();
  }


  template <int dim>
  void
  Population<dim>::exchange(ParticleRows<dim>         &&new_rows,
                            std::vector<unsigned int> &&beginnings)
  {
    AssertDimension(new_rows.n_properties(), rows.n_properties());
    AssertDimension(beginnings.size(), mesh_.graph().n_owned_cells() + 1);
    AssertDimension(beginnings.back(), new_rows.size());
    spare = std::move(rows);
    rows  = std::move(new_rows);
    begin = std::move(beginnings);
  }


  template <int dim>
  ParticleRows<dim>
  Population<dim>::take_spare()
  {
    ParticleRows<dim> taken(rows.n_properties());
    if (spare.n_properties() == rows.n_properties())
      taken.swap(spare);
    taken.clear();
    return taken;
  }


  template <int dim>
  void
  Population<dim>::replace(const ParticleRows<dim>         &new_rows,
                           const std::vector<unsigned int> &cells)
  {
    AssertDimension(new_rows.size(), cells.size());
    const CellOrder order(cells, mesh_.graph().n_owned_cells());
    rows.resize(order.things.size());
    for (unsigned int i = 0; i < order.things.size(); ++i)
      rows.copy(i, new_rows, order.things[i]);
    begin = order.begin;
  }


  template <int dim>
  void
  Population<dim>::insert(const ParticleRows<dim>         &new_rows,
                          const std::vector<unsigned int> &cells)
  {
    AssertDimension(new_rows.size(), cells.size());
    if (cells.empty())
      return;
    const unsigned int n_cells = mesh_.graph().n_owned_cells();
    begin.resize(n_cells + 1, rows.size());
    const CellOrder order(cells, n_cells);
    std::size_t     n_left = rows.size(), end = rows.size() + cells.size();
    rows.resize(end);
    // From the last cell on each block goes to its place.
    for (unsigned int i = order.things.size(); i-- > 0;)
      {
        const unsigned int behind  = begin[cells[order.things[i]] + 1];
        const std::size_t  n_moved = n_left - behind;
        rows.shift(behind, n_left, end - n_moved);
        end -= n_moved + 1;
        n_left = behind;
        rows.copy(end, new_rows, order.things[i]);
      }
    for (unsigned int c = 0; c <= n_cells; ++c)
      begin[c] += order.begin[c];
  }


  template <int dim>
  void
  Population<dim>::remove(std::vector<unsigned int> places)
  {
    if (places.empty())
      return;
    std::sort(places.begin(), places.end());
    std::vector<unsigned int> gone(begin.size() - 1, 0);
    // The last of the cell, until they are taken out below.
    unsigned int cell = begin.size() - 2;
    for (unsigned int i = places.size(); i-- > 0;)
      {
        while (places[i] < begin[cell])
          --cell;
        const unsigned int last = begin[cell + 1] - ++gone[cell];
        if (places[i] != last)
          rows.copy(places[i], rows, last);
      }
    std::size_t end = 0, n_kept = 0;
    for (unsigned int c = 0; c < gone.size(); ++c)
      if (gone[c] > 0)
        {
          const std::size_t kept = begin[c + 1] - gone[c];
          rows.shift(end, kept, n_kept);
          n_kept += kept - end;
          end = begin[c + 1];
        }
    rows.shift(end, rows.size(), n_kept);
    rows.resize(n_kept + rows.size() - end);
    unsigned int n_gone = 0;
    for (unsigned int c = 0; c < gone.size(); ++c)
      {
        begin[c] -= n_gone;
        n_gone += gone[c];
      }
    begin.back() -= n_gone;
  }


  template <int dim>
  ParticleId
  Population<dim>::next_id()
  {
    const MPI_Comm communicator = mesh_.triangulation().get_communicator();
    return first_id +
           n_created++ * dealii::Utilities::MPI::n_mpi_processes(communicator) +
           dealii::Utilities::MPI::this_mpi_process(communicator);
  }


  template <int dim>
  void
  Population<dim>::reserve_ids_below(const ParticleId first_free)
  {
    first_id  = first_free;
    n_created = 0;
  }


  template <int dim>
  void
  Population<dim>::keep(const Archive &archive)
  {
    const MPI_Comm communicator = mesh_.triangulation().get_communicator();
    archive.value("first id", first_id);
    std::vector<ParticleId> created =
      dealii::Utilities::MPI::all_gather(communicator, n_created);
    const auto n_ranks = created.size();
    archive.value("ids of ranks", created);
    AssertThrow(!created.empty(),
                dealii::ExcMessage("the numbers of its particles are "
                                   "damaged."));
    if (created.size() == n_ranks)
      n_created =
        created[dealii::Utilities::MPI::this_mpi_process(communicator)];
    else // other ranks than those that gave the ids
      reserve_ids_below(first_id +
                        *std::max_element(created.begin(), created.end()) *
                          created.size());
  }


  template <int dim>
  std::vector<std::array<double, 2>>
  Population<dim>::volumes_of_cells() const
  {
    std::vector<std::array<double, 2>> volumes(mesh_.graph().n_owned_cells());
    for (unsigned int c = 0; c < volumes.size(); ++c)
      for (const ConstParticle &particle : in_cell(c))
        {
          const auto properties = particle.properties();
          volumes[c][fluid_of(properties)] += properties[volume_offset];
        }
    return volumes;
  }


  template <int dim>
  std::uint64_t
  Population<dim>::n_global_particles() const
  {
    return dealii::Utilities::MPI::sum(
      std::uint64_t(rows.size()), mesh_.triangulation().get_communicator());
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::Population)
