#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/boundary_exchange.h>
#include <thalweg/particles/sub_cell.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    std::vector<typename Population<dim>::Iterator>
    nearest_first(Population<dim> &population, const Face<dim> &face)
    {
      std::vector<typename Population<dim>::Iterator> particles;
      const auto in_cell = population.handler().particles_in_cell(
        population.mesh().graph().iterator(face.cell));
      for (auto particle = in_cell.begin(); particle != in_cell.end();
           ++particle)
        particles.push_back(particle);
      std::sort(particles.begin(),
                particles.end(),
                [&](const auto &a, const auto &b) {
                  const auto &x  = a->get_reference_location();
                  const auto &y  = b->get_reference_location();
                  const long  dx = rounded(depth<dim>(face, x));
                  const long  dy = rounded(depth<dim>(face, y));
                  return dx != dy ? dx < dy : stands_before(x, y);
                });
      return particles;
    }

    /// A face divided into squares, one a particle.
    template <int dim>
    struct Tiles
    {
      Tiles(const Face<dim> &face, const unsigned int n)
        : face(face)
        , n(n)
        , number(dealii::Utilities::pow(n, dim - 1))
      {}

      /// The middle of tile @p index, at a distance of the face.
      dealii::Point<dim>
      center(const unsigned int index, const double distance) const
      {
        dealii::Point<dim> xi;
        xi[face.face_no / 2] = face.face_no % 2 == 0 ? distance : 1. - distance;
        for (unsigned int d = 0, rest = index; d < dim; ++d)
          if (d != face.face_no / 2)
            {
              xi[d] = (rest % n + .5) / n;
              rest /= n;
            }
        return xi;
      }

      /// The tile before which a point of the cell stands.
      unsigned int
      index(const dealii::Point<dim> &xi) const
      {
        unsigned int index = 0, stride = 1;
        for (unsigned int d = 0; d < dim; ++d)
          if (d != face.face_no / 2)
            {
              const long place = std::floor(xi[d] * n + reference_round_off);
              index += stride * std::clamp<long>(place, 0, n - 1);
              stride *= n;
            }
        return index;
      }

      /// The tiles, beginning with the one that has the most room before it.
      std::vector<unsigned int>
      emptiest_first(const Population<dim> &population) const
      {
        std::vector<long> room(number, rounded(1.));
        for (const auto &particle : population.handler().particles_in_cell(
               population.mesh().graph().iterator(face.cell)))
          {
            const auto &xi      = particle.get_reference_location();
            long       &of_tile = room[index(xi)];
            of_tile = std::min(of_tile, rounded(depth<dim>(face, xi)));
          }
        std::vector<unsigned int> order(number);
        for (unsigned int i = 0; i < number; ++i)
          order[i] = i;
        std::stable_sort(order.begin(),
                         order.end(),
                         [&](const unsigned int a, const unsigned int b) {
                           return room[a] > room[b];
                         });
        return order;
      }

      const Face<dim>   &face;
      const unsigned int n;
      const unsigned int number;
    };

    /// The outward volume in m^dim/s through a point of a face times its
    /// weight.
    template <int dim>
    double
    flux_at(const Face<dim>               &face,
            const unsigned int             q,
            const BoundaryConditions<dim> &conditions,
            const NodeSpace<dim>          &space,
            const Vector                  &velocity)
    {
      const auto            &condition = conditions.at(face.id);
      const auto            &xi        = face.reference_points[q];
      const auto            &normal    = face.normals_times_weight[q];
      dealii::Tensor<1, dim> v;
      if (condition.kind == BoundaryKind::velocity)
        {
          dealii::Vector<double> value(dim);
          condition.function->vector_value(
            Q1::position<dim>(space.mesh().graph().cell(face.cell).vertices,
                              xi),
            value);
          for (unsigned int d = 0; d < dim; ++d)
            v[d] = value[d];
        }
      else
        {
          const auto shape = Q1::values<dim>(xi);
          for (unsigned int i = 0; i < shape.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              v[d] += shape[i] * velocity.local_element(
                                   dim * space.nodes(face.cell)[i] + d);
        }
      return v * normal;
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
    , inflow_level_set(inflow_level_set)
    , convection(convection)
    , particles_per_direction(particles_per_direction)
    , accounts(space.mesh().graph(), boundary)
  {}


  template <int dim>
  double
  BoundaryExchange<dim>::inflow_value(const unsigned int        face,
                                      const dealii::Point<dim> &xi) const
  {
    const auto &[cell, face_no, id, points, normals] =
      boundary.passable_faces()[face];
    return inflow_level_set.at(id)(
      Q1::position<dim>(space.mesh().graph().cell(cell).vertices, xi));
  }


  template <int dim>
  std::vector<typename BoundaryExchange<dim>::Flux>
  BoundaryExchange<dim>::find_fluxes(const Vector &velocity,
                                     const double  dt) const
  {
    const auto       &faces = boundary.passable_faces();
    std::vector<Flux> fluxes(faces.size());
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int q = 0; q < faces[i].reference_points.size(); ++q)
        {
          const double volume =
            dt *
            flux_at<dim>(faces[i], q, boundary.conditions(), space, velocity);
          if (volume > 0)
            fluxes[i].out += volume;
          else if (volume < 0)
            fluxes[i]
              .in[inflow_value(i, faces[i].reference_points[q]) < 0 ? 0 : 1] -=
              volume;
        }
    return fluxes;
  }


  template <int dim>
  void
  BoundaryExchange<dim>::balance(std::vector<Flux> &fluxes) const
  {
    // What the faces can be scaled by without turning any of them around.
    constexpr double    most  = .5;
    const auto         &faces = boundary.passable_faces();
    std::vector<double> areas(faces.size());
    std::vector<double> sums(3); // net outflow, passage and area if open
    for (unsigned int i = 0; i < faces.size(); ++i)
      {
        const double in = fluxes[i].in[0] + fluxes[i].in[1];
        sums[0] += fluxes[i].out - in;
        if (boundary.conditions().at(faces[i].id).kind != BoundaryKind::open)
          continue;
        dealii::Tensor<1, dim> area;
        for (const auto &part : faces[i].normals_times_weight)
          area += part;
        areas[i] = area.norm();
        sums[1] += fluxes[i].out + in;
        sums[2] += areas[i];
      }
    dealii::Utilities::MPI::sum(sums,
                                space.mesh().triangulation().get_communicator(),
                                sums);
    if (sums[2] == 0)
      return;
    const double scale =
      sums[1] > 0 ? std::clamp(-sums[0] / sums[1], -most, most) : 0.;
    const double rest = -sums[0] - scale * sums[1];
    for (unsigned int i = 0; i < faces.size(); ++i)
      if (areas[i] > 0)
        {
          fluxes[i].out *= 1. + scale;
          for (double &volume : fluxes[i].in)
            volume *= 1. - scale;
          const double volume = rest * areas[i] / sums[2];
          if (volume > 0)
            fluxes[i].out += volume;
          else
            fluxes[i]
              .in[inflow_value(i, faces[i].reference_points[0]) < 0 ? 0 : 1] -=
              volume;
        }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::take(Population<dim>   &population,
                              const unsigned int face,
                              FluidVolumes      &out)
  {
    double &owed = accounts[face].owed;
    for (auto particle :
         nearest_first(population, boundary.passable_faces()[face]))
      {
        auto         properties = particle->get_properties();
        double      &volume     = properties[Population<dim>::volume_offset];
        const double taken      = std::min(volume, owed);
        volume -= taken;
        owed -= taken;
        out[Population<dim>::fluid_of(properties)] += taken;
        if (owed <= 0)
          return;
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::give_back(Population<dim>    &population,
                                   const unsigned int  face,
                                   const FluidVolumes &left,
                                   FluidVolumes       &out)
  {
    const double all    = left[0] + left[1];
    const double excess = std::min(-accounts[face].owed, all);
    if (!(excess > 0))
      return;
    std::array<bool, 2> is_done = {{left[0] <= 0, left[1] <= 0}};
    for (auto particle :
         nearest_first(population, boundary.passable_faces()[face]))
      {
        auto               properties = particle->get_properties();
        const unsigned int fluid      = Population<dim>::fluid_of(properties);
        if (is_done[fluid])
          continue;
        const double given = excess * left[fluid] / all;
        properties[Population<dim>::volume_offset] += given;
        accounts[face].owed += given;
        out[fluid] -= given;
        is_done[fluid] = true;
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::let_out(Population<dim>         &population,
                                 const std::vector<Flux> &fluxes,
                                 const ConvectionReport  &report,
                                 VolumeBooks             &counted)
  {
    std::vector<FluidVolumes> left(fluxes.size());
    for (const Exit &exit : report.exits)
      left[accounts.index(exit.cell, exit.face)][exit.fluid] += exit.volume;
    for (unsigned int i = 0; i < fluxes.size(); ++i)
      {
        auto &out     = counted.boundaries[boundary.passable_faces()[i].id].out;
        auto &account = accounts[i];
        const double waiting = account.waiting[0] + account.waiting[1];
        // What has just come in is the first to go.
        const double returned = std::min(fluxes[i].out, waiting);
        for (unsigned int f = 0; f < 2 && returned > 0; ++f)
          {
            const double part = returned * (account.waiting[f] / waiting);
            account.waiting[f] -= part;
            out[f] += part;
          }
        account.owed += fluxes[i].out - returned - left[i][0] - left[i][1];
        for (unsigned int f = 0; f < 2; ++f)
          out[f] += left[i][f];
        if (account.owed > 0)
          take(population, i, out);
        else if (account.owed < 0)
          give_back(population, i, left[i], out);
      }
  }


  template <int dim>
  void
  BoundaryExchange<dim>::fill_particles(
    const Population<dim>         &population,
    const unsigned int             number,
    const unsigned int             fluid,
    const double                   inflow,
    const CellVelocity<dim>       &cell_velocity,
    const double                   dt,
    std::vector<NewParticle<dim>> &particles)
  {
    const auto        &face  = boundary.passable_faces()[number];
    const unsigned int per_d = particles_per_direction;
    const double       whole = space.mesh().graph().cell(face.cell).measure /
                         dealii::Utilities::pow(per_d, dim);
    double            &waiting = accounts[number].waiting[fluid];
    const unsigned int n = std::floor(waiting / whole + reference_round_off);
    if (n == 0)
      return;
    const Tiles<dim> tiles(face, per_d);
    auto             order       = tiles.emptiest_first(population);
    const auto       is_of_other = [&](const unsigned int tile) {
      const bool is_negative = inflow_value(number, tiles.center(tile, 0.)) < 0;
      return is_negative != (fluid == 0);
    };
    const auto end = std::remove_if(order.begin(), order.end(), is_of_other);
    if (end != order.begin())
      order.erase(end, order.end());
    // The first of them came in before the others.
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int tile   = order[k % order.size()];
        const double       volume = std::min(whole, waiting);
        waiting -= volume;
        NewParticle<dim> particle{face.cell,
                                  tiles.center(tile, .5 / per_d),
                                  0.,
                                  {}};
        if (inflow > 0)
          particle.time = std::min(1., waiting / inflow) * dt;
        const auto on_face = tiles.center(tile, 0.);
        const auto shape   = Q1::values<dim>(on_face);
        for (unsigned int v = 0; v < shape.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            particle.properties[Population<dim>::velocity_offset + d] +=
              shape[v] * cell_velocity[face.cell][dim * v + d];
        const double value = inflow_value(number, on_face);
        particle.properties[Population<dim>::level_set_offset] =
          (value < 0) == (fluid == 0) ? value : -value;
        particle.properties[Population<dim>::volume_offset] = volume;
        particles.push_back(particle);
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

    std::vector<Flux> fluxes = find_fluxes(velocity, dt);
    balance(fluxes);
    let_out(population, fluxes, report, counted);
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
            accounts[i].owed -= exit.volume;
            counted.boundaries[faces[i].id].out[exit.fluid] += exit.volume;
          }
        for (unsigned int f = 0; f < 2; ++f)
          counted.lost[f] += on_way.lost_volume[f];
        n_new = on_way.n_moved - on_way.exits.size() - on_way.n_lost;
      }
    for (unsigned int i = 0; i < faces.size(); ++i)
      counted.owed += accounts[i].owed;
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
