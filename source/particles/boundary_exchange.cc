// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/boundary_exchange.h>
#include <thalweg/particles/sub_cell.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    using Face = typename BoundaryNodes<dim>::Face;

    /// How far a point of a cell is from a face, in parts of the cell.
    template <int dim>
    double
    depth(const Face<dim> &face, const dealii::Point<dim> &reference)
    {
      const double x = reference[face.face_no / 2];
      return face.face_no % 2 == 0 ? x : 1. - x;
    }

    /// The particles of a face's cell in the order in which they come to the
    /// face.
    template <int dim>
    std::vector<typename Population<dim>::Particle>
    nearest_first(Population<dim> &population, const Face<dim> &face)
    {
      std::vector<typename Population<dim>::Particle> particles;
      for (const auto &particle : population.in_cell(face.cell))
        particles.push_back(particle);
      std::sort(particles.begin(),
                particles.end(),
                [&](const auto &a, const auto &b) {
                  const auto &x  = a.reference();
                  const auto &y  = b.reference();
                  const long  dx = rounded(depth<dim>(face, x));
                  const long  dy = rounded(depth<dim>(face, y));
                  return dx != dy ? dx < dy : stands_before(x, y);
                });
      return particles;
    }

    /// The middle of one of the n^(dim-1) squares of a face, at a distance of
    /// the face in parts of the cell.
    template <int dim>
    dealii::Point<dim>
    before_face(const Face<dim>   &face,
                const unsigned int square,
                const unsigned int n,
                const double       distance)
    {
      dealii::Point<dim> xi;
      xi[face.face_no / 2] = face.face_no % 2 == 0 ? distance : 1. - distance;
      for (unsigned int d = 0, rest = square; d < dim; ++d)
        if (d != face.face_no / 2)
          {
            xi[d] = (rest % n + .5) / n;
            rest /= n;
          }
      return xi;
    }

    /// How many of both fluids' particles come to a face next, side by side.
    template <int dim>
    std::array<unsigned int, 2>
    next_ones(
      const Face<dim>                                       &face,
      const std::vector<typename Population<dim>::Particle> &nearest_first)
    {
      std::array<unsigned int, 2> n{};
      const auto                  distance = [&](const auto &particle) {
        return rounded(depth<dim>(face, particle.reference()));
      };
      for (const auto &particle : nearest_first)
        if (distance(particle) <= distance(nearest_first[0]) + 1)
          ++n[Population<dim>::fluid_of(particle.properties())];
      return n;
    }

    /// What was at rest outside comes in along the normal.
    template <int dim>
    dealii::Tensor<1, dim>
    inward_part(const Face<dim> &face, const dealii::Tensor<1, dim> &velocity)
    {
      const auto normal = face.area();
      return std::min(velocity * normal, 0.) / normal.norm_square() * normal;
    }

    /// Shares a volume among the fluids in proportion to @p parts.
    template <typename Number>
    FluidVolumes
    share(const double volume, const std::array<Number, 2> &parts)
    {
      const double first =
        parts[0] / (parts[0] + static_cast<double>(parts[1]));
      return {{first * volume, (1. - first) * volume}};
    }
  } // namespace


  template <int dim>
  BoundaryExchange<dim>::BoundaryExchange(
    const NodeSpace<dim>            &space,
    const BoundaryNodes<dim>        &boundary,
    const InflowLevelSet<dim>       &inflow_level_set,
    const StreamlineConvection<dim> &convection,
    const unsigned int               particles_per_direction)
    : space(space)
    , boundary(boundary)
    , inflow(space.mesh().graph(), inflow_level_set)
    , convection(convection)
    , particles_per_direction(particles_per_direction)
    , accounts(space.mesh().graph(), boundary)
  {}


  template <int dim>
  void
  BoundaryExchange<dim>::settle(
    std::vector<typename Population<dim>::Particle> &nearest_first,
    FaceAccount                                     &account,
    FluidVolumes                                    &out)
  {
    std::array<bool, 2> is_there{};
    for (auto &particle : nearest_first)
      {
        auto               properties = particle.properties();
        const unsigned int f          = Population<dim>::fluid_of(properties);
        double            &volume = properties[Population<dim>::volume_offset];
        const double       taken  = std::min(volume, account.owed[f]);
        is_there[f]               = true;
        volume -= taken;
        account.owed[f] -= taken;
        out[f] += taken;
      }
    for (unsigned int f = 0; f < 2; ++f)
      if (account.owed[f] < 0)
        {
          // The last of it left too soon: it will be the first to go.
          account.waiting[f] -= account.owed[f];
          out[f] += account.owed[f];
          account.owed[f] = 0;
        }
    // It was not the first fluid that went out if there is none of it. Not so
    // the other way around: water that is sprayed through air, and air in
    // water, take each other's place, so that air can lack.
    if (!is_there[0])
      {
        account.owed[1] += account.owed[0];
        account.owed[0] = 0;
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::let_out(Population<dim>             &population,
                                 const std::vector<FaceFlux> &fluxes,
                                 const ConvectionReport      &report,
                                 VolumeBooks                 &counted)
  {
    std::vector<FluidVolumes> left(fluxes.size());
    for (const Exit &exit : report.exits)
      left[accounts.index(exit.cell, exit.face)][exit.fluid] += exit.volume;
    for (unsigned int i = 0; i < fluxes.size(); ++i)
      {
        const auto  &face    = boundary.passable_faces()[i];
        auto        &out     = counted.boundaries[face.id].out;
        FaceAccount &account = accounts[i];
        const double waiting = account.waiting[0] + account.waiting[1];
        const double all     = left[i][0] + left[i][1];
        // What waits is the first to go.
        const double returned = std::min(fluxes[i].out, waiting);
        const double rest     = fluxes[i].out - returned - all;
        if (returned > 0)
          {
            const auto parts = share(returned, account.waiting);
            for (unsigned int f = 0; f < 2; ++f)
              {
                account.waiting[f] -= parts[f];
                out[f] += parts[f];
              }
          }
        for (unsigned int f = 0; f < 2; ++f)
          out[f] += left[i][f];
        if (rest == 0 && account.owed == FluidVolumes())
          continue;
        auto         particles = nearest_first(population, face);
        FluidVolumes parts{{0., rest}};
        if (rest < 0 || (particles.empty() && all > 0))
          parts = share(rest, left[i]);
        else if (!particles.empty())
          parts = share(rest, next_ones<dim>(face, particles));
        for (unsigned int f = 0; f < 2; ++f)
          account.owed[f] += parts[f];
        settle(particles, account, out);
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::let_out_dispersed(const std::vector<Exit> &exits,
                                           VolumeBooks             &counted)
  {
    for (const Exit &exit : exits)
      {
        const unsigned int i = accounts.index(exit.cell, exit.face);
        auto &passage = counted.boundaries[boundary.passable_faces()[i].id];
        passage.out[exit.fluid] += exit.volume;
        passage.in[1 - exit.fluid] += exit.volume;
        accounts[i].waiting[1 - exit.fluid] += exit.volume;
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::fill_particles(
    const Population<dim>         &population,
    const unsigned int             number,
    const unsigned int             fluid,
    const double                   passed,
    const CellVelocity<dim>       &cell_velocity,
    const double                   dt,
    std::vector<NewParticle<dim>> &particles)
  {
    const auto        &face  = boundary.passable_faces()[number];
    const unsigned int per_d = particles_per_direction;
    const double       whole = space.mesh().graph().cell(face.cell).measure /
                         dealii::Utilities::pow(per_d, dim);
    double &waiting = accounts[number].waiting[fluid];
    if (waiting < (1. - reference_round_off) * whole)
      return;
    const bool was_at_rest =
      boundary.conditions().at(face.id).kind == BoundaryKind::open;
    // Of an interface that crosses the face the squares of this fluid.
    std::vector<unsigned int> squares;
    for (unsigned int i = 0; i < dealii::Utilities::pow(per_d, dim - 1); ++i)
      if ((inflow.value(face, before_face<dim>(face, i, per_d, 0.)) < 0) ==
          (fluid == 0))
        squares.push_back(i);
    if (squares.empty())
      squares.push_back(0);
    const double       row = squares.size() * whole;
    const unsigned int n   = std::floor(waiting / row + reference_round_off);
    // The first row came in before the others.
    for (unsigned int k = 0; k < n; ++k)
      {
        const double volume = std::min(whole, waiting / squares.size());
        waiting -= squares.size() * volume;
        const double time =
          passed > 0 ? std::min(1., std::max(waiting, 0.) / passed) * dt : 0.;
        for (const unsigned int square : squares)
          {
            NewParticle<dim> particle{
              face.cell,
              before_face<dim>(face, square, per_d, .5 / per_d),
              time,
              std::vector<double>(population.row_length(),
                                  Population<dim>::unknown)};
            const auto on_face = before_face<dim>(face, square, per_d, 0.);
            const auto values =
              Q1::value<dim, dim>(cell_velocity[face.cell], on_face);
            dealii::Tensor<1, dim> velocity(
              dealii::make_array_view(values.begin(), values.end()));
            if (was_at_rest)
              velocity = inward_part(face, velocity);
            for (unsigned int d = 0; d < dim; ++d)
              particle.properties[Population<dim>::velocity_offset + d] =
                velocity[d];
            const double value = inflow.value(face, on_face);
            Population<dim>::set_level_set(particle.properties,
                                           (value < 0) == (fluid == 0)
                                             ? value
                                             : -value);
            particle.properties[Population<dim>::fluid_offset]  = fluid;
            particle.properties[Population<dim>::volume_offset] = volume;
            population.set_inflow(
              particle.properties,
              face.id,
              Q1::position<dim>(space.mesh().graph().cell(face.cell).vertices,
                                on_face),
              time);
            particles.push_back(particle);
          }
      }
  }


  template <int dim>
  unsigned int
  BoundaryExchange<dim>::pass(Population<dim>         &population,
                              const ConvectionReport  &report,
                              const Vector            &velocity,
                              const CellVelocity<dim> &cell_velocity,
                              const double             dt)
  {
    const MPI_Comm communicator =
      population.mesh().triangulation().get_communicator();
    const auto &faces = boundary.passable_faces();
    VolumeBooks counted;
    for (const auto &[id, condition] : boundary.conditions().all())
      if (condition.kind == BoundaryKind::open ||
          condition.kind == BoundaryKind::velocity)
        counted.boundaries[id];
    counted.lost = report.lost_volume;

    const auto fluxes = find_fluxes(space, boundary, inflow, velocity, dt);
    let_out(population, fluxes, report, counted);
    let_out_dispersed(report.dispersed_exits, counted);
    std::vector<NewParticle<dim>> particles;
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int f = 0; f < 2; ++f)
        {
          accounts[i].waiting[f] += fluxes[i].in[f];
          counted.boundaries[faces[i].id].in[f] += fluxes[i].in[f];
          fill_particles(
            population, i, f, fluxes[i].in[f], cell_velocity, dt, particles);
        }
    unsigned int n_new = 0;
    if (!counted.boundaries.empty())
      {
        const ConvectionReport on_way =
          convection.insert(population, particles, cell_velocity);
        for (const Exit &exit : on_way.exits)
          {
            const unsigned int i = accounts.index(exit.cell, exit.face);
            accounts[i].owed[exit.fluid] -= exit.volume;
            counted.boundaries[faces[i].id].out[exit.fluid] += exit.volume;
          }
        for (unsigned int f = 0; f < 2; ++f)
          counted.lost[f] += on_way.lost_volume[f];
        n_new = on_way.n_moved - on_way.exits.size() - on_way.n_lost;
      }
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int f = 0; f < 2; ++f)
        counted.owed[f] += accounts[i].owed[f];
    volume_books.add(counted, communicator);
    return n_new;
  }


  template <int dim>
  void
  BoundaryExchange<dim>::open_books(const Population<dim> &population)
  {
    volume_books = VolumeBooks();
    volume_books.start =
      sum_over_ranks(population.volumes_of_cells(),
                     population.mesh().triangulation().get_communicator());
  }


  template <int dim>
  void
  BoundaryExchange<dim>::add_waiting(
    std::vector<FluidVolumes> &volumes_of_cells) const
  {
    const auto &faces = boundary.passable_faces();
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int f = 0; f < 2; ++f)
        volumes_of_cells[faces[i].cell][f] += accounts[i].waiting[f];
  }


  template <int dim>
  void
  BoundaryExchange<dim>::keep(const Archive &archive)
  {
    volume_books.keep(archive.enter("books"));
    accounts.keep(archive.enter("faces"),
                  space.mesh().triangulation().get_communicator());
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::BoundaryExchange)
