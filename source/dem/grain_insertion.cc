// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/mixed_bits.h>
#include <thalweg/dem/grain_insertion.h>
#include <thalweg/dem/occupancy.h>
#include <thalweg/dem/points.h>
#include <thalweg/fields/expression.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// After so many places a grain that were tried in vain there is no room.
    constexpr unsigned int most_trials = 2000;
    constexpr unsigned int batch       = 4096;



    /// m^dim
    template <int dim>
    double
    volume_of(const double r)
    {
      return M_PI * r * r * (dim == 3 ? 4. / 3. * r : 1.);
    }



    /// Says that there is no room at places that touch a wall.
    void
    take_out_at_walls(const std::vector<GrainPlace> &places,
                      const WallSet                 &walls,
                      std::vector<char>             &room)
    {
      double largest = 0.;
      for (const GrainPlace &place : places)
        largest = std::max(largest, place.r);
      const FacetFinder          finder(walls.facets, largest);
      std::vector<std::uint32_t> facets;
      for (std::size_t i = 0; i < places.size(); ++i)
        {
          facets.clear();
          if (room[i] != 0)
            finder.append_near(places[i].x, places[i].r, facets);
          for (const std::uint32_t f : facets)
            if (walls.walls[walls.facets[f].wall].is_there &&
                distance_from(walls.facets[f], places[i].x) <
                  places[i].r * (1. - 1e-9))
              room[i] = 0;
        }
    }
  } // namespace



  double
  RandomNumbers::next()
  {
    const std::uint64_t bits = mixed_bits(state);
    state += mixing_step;
    return (bits >> 11) * 0x1p-53;
  }



  double
  RandomNumbers::next_normal()
  {
    const double a = 1. - next(), b = next();
    return std::sqrt(-2. * std::log(a)) * std::cos(2. * M_PI * b);
  }



  template <int dim>
  double
  GrainInsertion<dim>::radius(RandomNumbers &random) const
  {
    const auto bounded_normal = [&]() {
      double value = 4.;
      while (std::abs(value) > 3.)
        value = random.next_normal();
      return value;
    };
    if (sizes == "uniform")
      return .5 * (diameter + spread * (2. * random.next() - 1.));
    if (sizes == "normal")
      return .5 * (diameter + spread * bounded_normal());
    if (sizes == "lognormal")
      return .5 * diameter * std::exp(spread * bounded_normal());
    return .5 * diameter;
  }



  template <int dim>
  bool
  GrainInsertion<dim>::is_in_region(const Vec3 &x) const
  {
    return region_function->value(as_point<dim>(x)) > 0.;
  }



  template <int dim>
  std::vector<GrainPlace>
  GrainInsertion<dim>::on_lattice(const Mesh<dim> &mesh,
                                  RandomNumbers   &random) const
  {
    const double s             = spacing > 0. ? spacing : largest_diameter();
    const auto &[lower, upper] = mesh.box();
    std::array<std::size_t, 3> n{{1, 1, 1}};
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double along = (upper[d] - lower[d]) / s;
        AssertThrow(along < 1e6,
                    dealii::ExcMessage("\'" + where +
                                       "/Spacing' is less than a "
                                       "millionth of the domain."));
        n[d] = static_cast<std::size_t>(std::floor(along + 1e-9));
      }
    std::vector<GrainPlace> places;
    const auto              off = [&]() {
      return shake > 0. ? shake * (2. * random.next() - 1.) : 0.;
    };
    for (std::size_t k = 0; k < n[2]; ++k)
      for (std::size_t j = 0; j < n[1]; ++j)
        for (std::size_t i = 0; i < n[0]; ++i)
          {
            Vec3 x{lower[0] + (i + .5) * s + off(),
                   lower[1] + (j + .5) * s + off(),
                   0.};
            if (dim == 3)
              x.z = lower[dim - 1] + (k + .5) * s + off();
            const double r = radius(random);
            if (is_in_region(x))
              places.push_back({x, r});
          }
    return places;
  }



  template <int dim>
  void
  GrainInsertion<dim>::take_out_overlapping(
    const Mesh<dim>               &mesh,
    const std::vector<GrainPlace> &places,
    const std::vector<GrainPlace> &present,
    std::vector<char>             &room) const
  {
    double largest = largest_diameter();
    for (const GrainPlace &grain : present)
      largest = std::max(largest, 2. * grain.r);
    Occupancy occupied(largest);
    for (const GrainPlace &grain : present)
      occupied.add(grain);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (room[i] != 0 && !occupied.is_free(places[i]))
        room[i] = 0;
    MPI_Allreduce(MPI_IN_PLACE,
                  room.data(),
                  room.size(),
                  MPI_CHAR,
                  MPI_MIN,
                  mesh.triangulation().get_communicator());
  }



  template <int dim>
  std::vector<GrainPlace>
  GrainInsertion<dim>::at_random(const Mesh<dim>               &mesh,
                                 const MeshLocator<dim>        &locator,
                                 RandomNumbers                 &random,
                                 const std::vector<GrainPlace> &present,
                                 const WallSet                 &walls,
                                 const StreamGoal              &wanted) const
  {
    std::vector<GrainPlace> places;

    double     mass    = 0.;
    const auto is_done = [&]() {
      return wanted.density > 0. ? mass >= wanted.mass
                                 : places.size() >= wanted.number;
    };
    Occupancy taken(largest_diameter());
    const auto &[lower, upper] = mesh.box();
    unsigned int in_vain       = 0;
    while (!is_done())
      {
        std::vector<GrainPlace> trials;
        while (trials.size() < batch)
          {
            Vec3 x{lower[0] + random.next() * (upper[0] - lower[0]),
                   lower[1] + random.next() * (upper[1] - lower[1]),
                   0.};
            if (dim == 3)
              x.z = lower[dim - 1] +
                    random.next() * (upper[dim - 1] - lower[dim - 1]);
            trials.push_back({x, radius(random)});
          }
        std::vector<char> is_free = locator.have_room(trials);
        take_out_at_walls(trials, walls, is_free);
        take_out_overlapping(mesh, trials, present, is_free);
        const std::size_t before = places.size();
        for (unsigned int t = 0; t < batch && !is_done(); ++t)
          if (is_free[t] != 0 && is_in_region(trials[t].x) &&
              taken.is_free(trials[t]))
            {
              taken.add(trials[t]);
              places.push_back(trials[t]);
              mass += wanted.density * volume_of<dim>(trials[t].r);
            }
        in_vain = places.size() > before ? 0 : in_vain + batch;
        if (in_vain > most_trials * 100)
          break;
      }
    return places;
  }



  template <int dim>
  unsigned int
  GrainInsertion<dim>::material_number(const GrainMaterials &materials) const
  {
    return material.empty() ? 0 : materials.find(material, where + "/Material");
  }



  template <int dim>
  void
  GrainInsertion<dim>::check_room(const std::vector<GrainPlace> &places,
                                  const StreamGoal              &wanted,
                                  const std::string             &extent) const
  {
    double volume = 0.;
    for (const GrainPlace &place : places)
      volume += volume_of<dim>(place.r);
    const std::string found = "\'" + where + "/Region' has room for " +
                              std::to_string(places.size()) + " grains of ";
    const std::string too_fast =
      " that are to come in in an interval: the stream is faster than its "
      "region can take. Give it a larger one, or a velocity with which grains "
      "leave it.";
    if (wanted.density > 0.)
      {
        AssertThrow(wanted.density * volume >= wanted.mass,
                    dealii::ExcMessage(found + "the " +
                                       std::to_string(wanted.mass) + " kg" +
                                       too_fast));
        return;
      }
    AssertThrow(!is_stream() || places.size() >= wanted.number,
                dealii::ExcMessage(found + "the " +
                                   std::to_string(wanted.number) + too_fast));
    AssertThrow(is_stream() || (places.size() >= number && !places.empty()),
                dealii::ExcMessage(
                  found + "the " +
                  (number > 0 ? std::to_string(number) + " " : "") +
                  "that are to come in: it must be in the domain " + extent +
                  " and large enough."));
  }



  template <int dim>
  std::vector<GrainRecord>
  GrainInsertion<dim>::make(const Mesh<dim>               &mesh,
                            const MeshLocator<dim>        &locator,
                            const GrainMaterials          &materials,
                            const unsigned int             n,
                            const double                   mass_before,
                            const std::uint64_t            first_id,
                            const std::vector<GrainPlace> &present,
                            const WallSet                 &walls) const
  {
    const double time = time_of(n);
    region_function   = parse_expression<dim>(region, 1, where + "/Region");
    region_function->set_time(time);
    RandomNumbers random(seed * 1000003ull + n + index * 998244353ull);
    std::vector<GrainPlace> places;
    StreamGoal              wanted{number};
    if (mass_rate > 0.)
      wanted = {0,
                mass_rate * (n + 1.) * interval - mass_before,
                materials.densities()[material_number(materials)]};
    else if (number_rate > 0.)
      wanted.number = number_of_stream(n);
    if (pattern == "random")
      places = at_random(mesh, locator, random, present, walls, wanted);
    else
      {
        const auto        all  = on_lattice(mesh, random);
        std::vector<char> room = locator.have_room(all);
        take_out_at_walls(all, walls, room);
        take_out_overlapping(mesh, all, present, room);
        for (std::size_t i = 0; i < all.size(); ++i)
          if (room[i] != 0 && (number == 0 || places.size() < number))
            places.push_back(all[i]);
      }
    check_room(places, wanted, mesh.extent());
    const auto v = parse_expression<dim>(velocity, dim, where + "/Velocity");
    const auto w =
      parse_expression<dim>(spin, dim == 3 ? 3 : 1, where + "/Spin");
    v->set_time(time);
    w->set_time(time);
    std::vector<GrainRecord> grains;
    const Vec3               nothing{0., 0., 0.};
    for (const auto &[x, r] : places)
      {
        GrainRecord grain{first_id + grains.size(),
                          x,
                          nothing,
                          nothing,
                          nothing,
                          nothing,
                          x,
                          r,
                          material_number(materials),
                          0};
        const auto  p = as_point<dim>(x);
        grain.v       = {v->value(p, 0),
                         v->value(p, 1),
                   dim == 3 ? v->value(p, dim - 1) : 0.};
        grain.w       = dim == 3
                          ? Vec3{w->value(p, 0), w->value(p, 1), w->value(p, dim - 1)}
                          : Vec3{0., 0., w->value(p, 0)};
        grains.push_back(grain);
      }
    return grains;
  }



  template std::vector<GrainRecord>
  GrainInsertion<2>::make(const Mesh<2> &,
                          const MeshLocator<2> &,
                          const GrainMaterials &,
                          const unsigned int,
                          const double,
                          const std::uint64_t,
                          const std::vector<GrainPlace> &,
                          const WallSet &) const;
  template std::vector<GrainRecord>
  GrainInsertion<3>::make(const Mesh<3> &,
                          const MeshLocator<3> &,
                          const GrainMaterials &,
                          const unsigned int,
                          const double,
                          const std::uint64_t,
                          const std::vector<GrainPlace> &,
                          const WallSet &) const;
} // namespace Thalweg
