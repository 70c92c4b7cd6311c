// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/mesh/cell_order.h>
#include <thalweg/particles/sub_cell.h>
#include <thalweg/particles/tracer_cloud.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  template <int dim>
  TracerCloud<dim>::TracerCloud(const Mesh<dim> &mesh)
    : mesh_(mesh)
  {}



  template <int dim>
  void
  TracerCloud<dim>::add(const unsigned int        cell,
                        const dealii::Point<dim> &reference,
                        const double              time,
                        const Tracer<dim>        &tracer)
  {
    cloud.push_back({Walker<dim>::start(cell, reference, time), tracer});
  }



  template <int dim>
  typename TracerCloud<dim>::Report
  TracerCloud<dim>::move(const StreamlineWalk<dim> &walk,
                         const double               dt,
                         const double               end)
  {
    WalkEffort effort;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      {
        Walker<dim> &walker = cloud[i].walker;
        if (i < n_old)
          walker.time = dt;
        walker.piece_begin = walker.reference;
        walker.fate        = Fate::under_way;
        walk.walk(walker, effort);
      }
    walk_on_other_ranks(walk,
                        mesh_.triangulation().get_communicator(),
                        cloud,
                        effort);
    Report report;
    for (const auto &[walker, tracer] : cloud)
      if (walker.fate == Fate::left)
        {
          const dealii::Point<dim> at = walk.position(walker);
          TracerExit<dim> exit{tracer, end - walker.time, {}, walker.boundary};
          for (unsigned int d = 0; d < dim; ++d)
            exit.place[d] = at[d];
          report.exits.push_back(exit);
        }
      else if (walker.fate != Fate::arrived)
        ++report.n_lost;
    std::vector<unsigned int> begin;
    sort(begin);
    settle();
    return report;
  }



  template <int dim>
  void
  TracerCloud<dim>::settle()
  {
    n_old = cloud.size();
  }



  template <int dim>
  void
  TracerCloud<dim>::sort(std::vector<unsigned int> &begin)
  {
    std::vector<unsigned int> cells;
    cells.reserve(cloud.size());
    for (const auto &[walker, tracer] : cloud)
      cells.push_back(walker.fate == Fate::arrived ||
                          walker.fate == Fate::under_way
                        ? walker.cell
                        : dealii::numbers::invalid_unsigned_int);
    CellOrder           order(cells, mesh_.graph().n_owned_cells());
    std::vector<Member> sorted;
    sorted.reserve(order.things.size());
    for (const unsigned int i : order.things)
      sorted.push_back(cloud[i]);
    begin.swap(order.begin);
    cloud.swap(sorted);
  }



  template <int dim>
  std::uint64_t
  TracerCloud<dim>::n_global() const
  {
    return dealii::Utilities::MPI::sum(
      std::uint64_t(cloud.size()), mesh_.triangulation().get_communicator());
  }



  template <int dim>
  void
  TracerCloud<dim>::save()
  {
    Assert(n_old == cloud.size(), dealii::ExcInternalError());
    sort(saved_begin);
    saved = cloud;
  }



  template <int dim>
  void
  TracerCloud<dim>::restore()
  {
    cloud = saved;
    settle();
  }



  template <int dim>
  void
  TracerCloud<dim>::clear()
  {
    cloud.clear();
    settle();
  }



  template <int dim>
  void
  TracerCloud<dim>::pack(const CellIterator    &cell,
                         const Compat::CellFate fate,
                         std::vector<char>     &bytes) const
  {
    const bool    is_coarsened = fate == Compat::CellFate::is_coarsened;
    const auto    sources      = this->cells_before(mesh_.graph(), cell, fate);
    std::uint32_t n            = 0;
    for (const unsigned int source : sources)
      n += saved_begin[source + 1] - saved_begin[source];
    append_plain(bytes, n);
    for (unsigned int c = 0; c < sources.size(); ++c)
      for (unsigned int i = saved_begin[sources[c]];
           i < saved_begin[sources[c] + 1];
           ++i)
        {
          dealii::Point<dim> reference = saved[i].walker.reference_point();
          if (is_coarsened)
            reference = to_parent<dim>(reference, c);
          append_plain(bytes, reference);
          append_plain(bytes, saved[i].luggage);
        }
  }



  template <int dim>
  void
  TracerCloud<dim>::begin_to_unpack()
  {
    received.clear();
  }



  template <int dim>
  void
  TracerCloud<dim>::unpack(const CellIterator    &cell,
                           const Compat::CellFate fate,
                           PlainReader           &reader)
  {
    std::uint32_t n = 0;
    reader.read(n);
    for (std::uint32_t i = 0; i < n; ++i)
      {
        dealii::Point<dim> reference;
        Tracer<dim>        tracer;
        reader.read(reference);
        reader.read(tracer);
        const unsigned int index =
          find_cell_after(mesh_.graph(), cell, fate, reference);
        received.push_back({Walker<dim>::start(index, reference, 0.), tracer});
      }
  }



  template <int dim>
  void
  TracerCloud<dim>::check_unpacked() const
  {
    for (const auto &[walker, tracer] : received)
      for (unsigned int d = 0; d < dim; ++d)
        AssertThrow(std::abs(walker.reference[d] - .5) <= 1. &&
                      std::isfinite(tracer.origin[d]) &&
                      std::isfinite(tracer.released),
                    dealii::ExcMessage("it has tracers that cannot be where "
                                       "it says."));
  }



  template <int dim>
  void
  TracerCloud<dim>::end_to_unpack()
  {
    cloud.swap(received);
    received.clear();
    std::vector<unsigned int> begin;
    sort(begin);
    settle();
  }



  THALWEG_INSTANTIATE(TracerCloud)
} // namespace Thalweg
