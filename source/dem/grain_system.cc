// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/grain_motion.h>
#include <thalweg/dem/grain_system.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Where lists are made anew though they would hold a little longer, so
    /// that it is not looked at in every step.
    constexpr double nearly_used_up = .9;
  } // namespace



  GrainSystem::GrainSystem(const MPI_Comm           communicator,
                           const ContactLaw        &law,
                           const GrainSettings     &settings,
                           WallSet                 &walls,
                           const std::vector<Vec3> &periods)
    : communicator(communicator)
    , law(law)
    , settings(settings)
    , walls(walls)
    , halo(communicator, periods)
    , near(settings.rolling == RollingModel::epsd)
  {
    MPI_Comm_size(communicator, &n_ranks);
    near.clear(0);
  }



  double
  GrainSystem::mass(const unsigned int material, const double r) const
  {
    const double volume =
      settings.dim == 3 ? 4. / 3. * M_PI * r * r * r : M_PI * r * r;
    return settings.densities[material] * volume;
  }



  double
  GrainSystem::maximum(double value) const
  {
    if (n_ranks > 1)
      MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return value;
  }



  void
  GrainSystem::clear()
  {
    arrays.resize(0);
    own_places.clear();
    own_cells.clear();
    near.clear(0);
    wall_list = WallList();
  }



  void
  GrainSystem::restore(const GrainSet &saved)
  {
    GrainSet set = saved;
    distribute(set);
    arrange(set);
  }



  void
  GrainSystem::add(const std::vector<GrainRecord> &grains)
  {
    GrainSet set = all();
    for (const GrainRecord &grain : grains)
      set.append(grain, nullptr, 0, nullptr, 0);
    begin_anew(set);
  }



  void
  GrainSystem::remove(const std::function<bool(const Vec3 &)> &is_gone)
  {
    double n = 0.;
    for (const std::uint32_t i : own_places)
      n += is_gone(arrays.place[i].x);
    if (maximum(n) == 0.)
      return;
    const GrainSet before = all();
    GrainSet       after;
    for (std::size_t g = 0; g < before.grains.size(); ++g)
      if (is_gone(before.grains[g].x))
        gone.push_back({before.grains[g], GrainOwner::no_boundary, false});
      else
        after.append(before, g);
    begin_anew(after);
  }



  void
  GrainSystem::rebuild()
  {
    GrainSet set = all();
    begin_anew(set);
    ++counts.n_rebuilds;
  }



  void
  GrainSystem::begin_anew(GrainSet &set)
  {
    for (GrainRecord &grain : set.grains)
      {
        grain.x += locator->wrap(grain.x);
        grain.reference = grain.x;
      }
    for (MovingWall &wall : walls.moving)
      wall.reference = wall.now;
    travelled = 0.;
    distribute(set);
    arrange(set);
  }



  GrainSet
  GrainSystem::all() const
  {
    GrainSet set;
    near.write(arrays.id, arrays.own, set.contacts);
    std::size_t row = 0;
    for (std::size_t o = 0; o < own_places.size(); ++o)
      {
        const std::uint32_t  i = own_places[o];
        const GrainMomentum &p = arrays.momentum[i];
        const GrainMotion   &m = arrays.motion[i];
        const GrainLoad     &l = arrays.load[i];
        set.grains.push_back({arrays.id[i],
                              arrays.place[i].x,
                              p.v,
                              p.w,
                              is_in_step ? m.v : l.force,
                              is_in_step ? m.w : l.torque,
                              arrays.reference[i],
                              arrays.place[i].r,
                              arrays.material[i],
                              own_cells[o]});
        if (row < wall_list.grain.size() && wall_list.grain[row] == i)
          {
            const WallMemory *memory =
              wall_list.memory.data() + wall_list.begin[row];
            set.walls.insert(set.walls.end(),
                             memory,
                             memory + wall_list.n_remembered(row));
            ++row;
          }
        set.wall_begin.push_back(set.walls.size());
      }
    return set;
  }



  double
  GrainSystem::farthest() const
  {
    double square = 0.;
    for (const std::uint32_t i : own_places)
      square =
        std::max(square, norm_square(arrays.place[i].x - arrays.reference[i]));
    return std::max(maximum(std::sqrt(square)), walls.farthest());
  }



  void
  GrainSystem::prune()
  {
    near.prune(neighbours, arrays.place, inner_margin);
    travelled_since_pruning = 0.;
    ++counts.n_prunes;
  }



  void
  GrainSystem::check_lists(const double way_here)
  {
    const double way = maximum(way_here);
    travelled += way;
    travelled_since_pruning += way;
    if (2. * travelled > skin)
      {
        travelled = farthest();
        if (2. * travelled > nearly_used_up * skin)
          {
            rebuild();
            return;
          }
      }
    halo.refresh(arrays);
    if (2. * travelled_since_pruning > inner_margin)
      prune();
  }



  void
  GrainSystem::add_contacts(const double dt)
  {
    ContactWork work;
    double      wall_work = 0.;
    PairLoop    pairs{arrays.size(),
                   arrays.place.data(),
                   arrays.motion.data(),
                   arrays.load.data(),
                   arrays.material.data(),
                   arrays.own.data(),
                   near.begin.data(),
                   near.partner.data(),
                   near.hits.data(),
                   near.touching.data(),
                   near.slip.data(),
                   near.roll.data(),
                   static_cast<unsigned int>(settings.densities.size()),
                   inertia_factor(),
                   dt,
                   &work};
    law.add_pairs(pairs, settings.counts);
    WallLoop at_walls{wall_list.grain.size(),
                      wall_list.grain.data(),
                      wall_list.begin.data(),
                      wall_list.facet.data(),
                      wall_list.memory.data(),
                      walls.facets.data(),
                      walls.walls.data(),
                      walls.forces.data(),
                      arrays.place.data(),
                      arrays.motion.data(),
                      arrays.load.data(),
                      arrays.material.data(),
                      pairs.n_materials,
                      inertia_factor(),
                      dt,
                      &work,
                      &wall_work};
    for (WallForce &force : walls.forces)
      force = {{0., 0., 0.}, {0., 0., 0.}};
    law.add_walls(at_walls, settings.counts);
    counts.work.normal += work.normal;
    counts.work.tangential += work.tangential;
    counts.work.rolling += work.rolling;
    counts.wall_work += wall_work;
    counts.last_work      = work;
    counts.last_wall_work = wall_work;
  }



  void
  GrainSystem::advance(
    const unsigned int                             n_steps,
    const double                                   dt,
    const Vec3                                    &acceleration,
    const std::function<void(const unsigned int)> &before_contacts,
    const double                                   time)
  {
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const double fastest =
          kick_and_drift(arrays, step == 0 ? .5 * dt : dt, dt, acceleration);
        const double way = walls.move(time + step * dt, dt);
        walls.place_facets(moving_facets);
        is_in_step = true;
        check_lists(std::max(std::sqrt(fastest) * dt, way));
        is_in_step = false;
        if (before_contacts)
          before_contacts(step);
        add_contacts(dt);
      }
    kick(arrays, .5 * dt, acceleration);
  }



  std::vector<GoneGrain>
  GrainSystem::take_gone()
  {
    std::vector<GoneGrain> taken;
    taken.swap(gone);
    return taken;
  }
} // namespace Thalweg
