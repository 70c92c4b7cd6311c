// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/feet.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/streamline_convection.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  void
  ConvectionParameters::declare_parameters(const Section &section)
  {
    section.add("Integrator",
                integrator,
                "",
                "How streamlines are integrated: `rk2` is the midpoint rule, "
                "`rk4` the classical scheme of fourth order.",
                dealii::Patterns::Selection("rk2|rk4"));
    section.add("Substep Courant number",
                substep_courant_number,
                "",
                "The greatest part of a cell that a particle may cross in "
                "one substep of the integrator. Time steps may have any "
                "Courant number; this only sets how finely the way of the "
                "particles is resolved.",
                dealii::Patterns::Double(1e-3, 1.));
  }


  void
  ConvectionReport::add(const ConvectionReport &other)
  {
    n_moved += other.n_moved;
    n_lost += other.n_lost;
    if (other.first_lost.id < first_lost.id)
      first_lost = other.first_lost;
    for (const auto &[boundary, counts] : other.left)
      for (unsigned int i = 0; i < 2; ++i)
        left[boundary][i] += counts[i];
    exits.insert(exits.end(), other.exits.begin(), other.exits.end());
    dispersed_exits.insert(dispersed_exits.end(),
                           other.dispersed_exits.begin(),
                           other.dispersed_exits.end());
    for (unsigned int i = 0; i < 2; ++i)
      lost_volume[i] += other.lost_volume[i];
    n_substeps += other.n_substeps;
    n_cells_crossed += other.n_cells_crossed;
  }


  std::uint64_t
  ConvectionReport::n_left() const
  {
    std::uint64_t n = 0;
    for (const auto &[boundary, counts] : left)
      n += counts[0] + counts[1];
    return n;
  }


  ConvectionReport
  ConvectionReport::sum(const MPI_Comm communicator) const
  {
    namespace MPI = dealii::Utilities::MPI;
    ConvectionReport total;
    total.n_moved         = MPI::sum(n_moved, communicator);
    total.n_lost          = MPI::sum(n_lost, communicator);
    total.n_substeps      = MPI::sum(n_substeps, communicator);
    total.n_cells_crossed = MPI::sum(n_cells_crossed, communicator);
    if (total.n_lost > 0)
      {
        const LostParticle &own = first_lost;
        total.first_lost.id     = MPI::min(own.id, communicator);
        const bool is_own       = own.id == total.first_lost.id;
        // Zero everywhere else, and no two ranks have the same particle.
        for (unsigned int d = 0; d < own.place.size(); ++d)
          total.first_lost.place[d] =
            MPI::sum(is_own ? own.place[d] : 0., communicator);
      }
    for (unsigned int i = 0; i < 2; ++i)
      total.lost_volume[i] = MPI::sum(lost_volume[i], communicator);
    for (const auto &of_rank : MPI::all_gather(communicator, left))
      for (const auto &[boundary, counts] : of_rank)
        for (unsigned int i = 0; i < 2; ++i)
          total.left[boundary][i] += counts[i];
    return total;
  }


  template <int dim>
  StreamlineConvection<dim>::StreamlineConvection(
    const Mesh<dim>                                      &mesh,
    const ConvectionParameters                           &parameters,
    const std::map<dealii::types::boundary_id, WallKind> &walls,
    const VelocityShape                                   shape)
    : mesh_(mesh)
    , settings(walk_settings(parameters, walls))
    , shape(shape)
  {}


  template <int dim>
  bool
  StreamlineConvection<dim>::are_none(const std::size_t n) const
  {
    return dealii::Utilities::MPI::max(
             n, mesh_.triangulation().get_communicator()) == 0;
  }


  template <int dim>
  StreamlineWalk<dim>
  StreamlineConvection<dim>::walk(const CellVelocity<dim> &velocity,
                                  const double             direction) const
  {
    const auto &graph = mesh_.graph();
    return {
      graph,
      SteadyField<dim>(graph, velocity, settings.substep, direction, shape),
      settings};
  }


  template <int dim>
  ConvectionReport
  StreamlineConvection<dim>::move(Population<dim>         &population,
                                  const CellVelocity<dim> &velocity,
                                  const double             dt) const
  {
    return move_along(population, walk(velocity, 1.), dt);
  }


  template <int dim>
  ConvectionReport
  StreamlineConvection<dim>::insert(
    Population<dim>                     &population,
    const std::vector<NewParticle<dim>> &particles,
    const CellVelocity<dim>             &velocity) const
  {
    if (are_none(particles.size()))
      return {};
    return insert_along(population, walk(velocity, 1.), particles);
  }


  template <int dim>
  std::vector<Foot<dim>>
  StreamlineConvection<dim>::trace_back(
    const std::vector<unsigned int>       &cells,
    const std::vector<dealii::Point<dim>> &reference_points,
    const CellVelocity<dim>               &velocity,
    const CellField<dim, 1>               &level_set,
    const double                           dt) const
  {
    if (are_none(cells.size()))
      return {};
    return find_feet(walk(velocity, -1.),
                     mesh_.triangulation().get_communicator(),
                     cells,
                     reference_points,
                     dt,
                     [&](const Walker<dim> &walker) {
                       const auto reference = walker.reference_point();
                       return Sight<dim>{
                         Q1::value<dim, dim>(velocity[walker.cell], reference),
                         Q1::value<dim>(level_set[walker.cell], reference)};
                     });
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::StreamlineConvection)
