// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/grain_budget.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    void
    add_grains(const GrainView &view,
               const Vec3      &gravity,
               const Vec3      &datum,
               GrainSums       &sums)
    {
      const GrainArrays &grains = view.system.grains();
      const double       half   = .5 * view.sub_step;
      for (const std::uint32_t i : view.system.own())
        {
          // The product of the velocities half a sub-step before and after:
          // that is what leaps in the field of springs keep.
          const GrainMomentum &p    = grains.momentum[i];
          const double         mass = 1. / p.inverse_mass;
          const Vec3           dv =
            half * (p.inverse_mass * grains.load[i].force + gravity);
          const Vec3 dw = (half * p.inverse_inertia) * grains.load[i].torque;
          sums.n += 1.;
          sums.mass += mass;
          sums.translation += .5 * mass * dot(p.v - dv, p.v + dv);
          if (p.inverse_inertia > 0.)
            sums.rotation += .5 / p.inverse_inertia * dot(p.w - dw, p.w + dw);
          const Vec3 way = grains.place[i].x - datum;
          sums.potential -= mass * dot(gravity, way);
          sums.momentum += mass * p.v;
          sums.center += mass * way;
          sums.fastest = std::max(sums.fastest, norm(p.v));
        }
    }



    void
    add_pairs(const GrainView &view, GrainSums &sums)
    {
      const GrainArrays &grains   = view.system.grains();
      const ContactList &contacts = view.system.contacts();
      const unsigned int n        = view.materials.n();
      for (std::size_t i = 0; i + 1 < contacts.begin.size(); ++i)
        for (auto k = contacts.begin[i]; k < contacts.begin[i + 1]; ++k)
          if (contacts.touching[k])
            {
              const std::uint32_t j = contacts.partner[k];
              // The other half of a pair across a border counts there.
              const double        share = .5 * (grains.own[i] + grains.own[j]);
              const PairGeometry  pair  = pair_geometry(grains.place[i],
                                                      grains.place[j],
                                                      grains.motion[i],
                                                      grains.motion[j]);
              const ContactMemory memory{contacts.slip[k],
                                         contacts.roll.empty()
                                           ? Vec3{0., 0., 0.}
                                           : contacts.roll[k]};
              const ElasticEnergy energy =
                view.law.energy(grains.material[i] * n + grains.material[j],
                                pair.touch,
                                memory_now(memory, pair.state, view.sub_step));
              sums.elastic += share * energy.normal;
              sums.sheared += share * energy.tangential;
              sums.rolled += share * energy.rolling;
              sums.n_contacts += share;
              sums.largest_overlap =
                std::max(sums.largest_overlap,
                         .5 * pair.touch.overlap /
                           std::min(grains.place[i].r, grains.place[j].r));
            }
    }



    void
    add_walls(const GrainView &view, GrainSums &sums)
    {
      const GrainArrays &grains = view.system.grains();
      const WallList    &list   = view.system.wall_contacts();
      FacetTouch         touches[most_touches];
      for (std::size_t g = 0; g < list.grain.size(); ++g)
        {
          const std::uint32_t i     = list.grain[g];
          const std::uint32_t begin = list.begin[g];
          const unsigned int  n_touches =
            visible_touches(view.walls.facets.data(),
                            view.walls.walls.data(),
                            list.facet.data() + begin,
                            list.begin[g + 1] - begin,
                            grains.place[i],
                            touches);
          const double r = grains.place[i].r;
          for (unsigned int t = 0; t < n_touches; ++t)
            {
              const Wall         &wall    = view.walls.walls[touches[t].wall];
              const double        overlap = touches[t].overlap;
              const ElasticEnergy energy  = view.law.energy(
                grains.material[i] * view.materials.n() + wall.material,
                {overlap, r, 1. / grains.motion[i].inverse_mass, r - overlap},
                memory_now(list.memory[begin + t].springs,
                           state_at_wall(grains.place[i],
                                         grains.motion[i],
                                         wall,
                                         touches[t]),
                           view.sub_step));
              sums.elastic += energy.normal;
              sums.sheared += energy.tangential;
              sums.rolled += energy.rolling;
              sums.n_wall_contacts += 1.;
              sums.largest_overlap =
                std::max(sums.largest_overlap, .5 * overlap / r);
            }
        }
    }
  } // namespace



  double
  energy_of_grain(const GrainSystem &system,
                  const GrainRecord &grain,
                  const Vec3        &gravity,
                  const Vec3        &datum)
  {
    const double mass = system.mass(grain.material, grain.r);
    return mass * (.5 * norm_square(grain.v) +
                   .5 * system.inertia_factor() * grain.r * grain.r *
                     norm_square(grain.w) -
                   dot(gravity, grain.x - datum));
  }



  GrainSums
  sum_up(const MPI_Comm   communicator,
         const GrainView &view,
         const Vec3      &gravity,
         const Vec3      &datum)
  {
    GrainSums sums;
    add_grains(view, gravity, datum, sums);
    add_pairs(view, sums);
    add_walls(view, sums);
    double added[]    = {sums.n,
                         sums.mass,
                         sums.translation,
                         sums.rotation,
                         sums.potential,
                         sums.elastic,
                         sums.sheared,
                         sums.rolled,
                         sums.momentum.x,
                         sums.momentum.y,
                         sums.momentum.z,
                         sums.center.x,
                         sums.center.y,
                         sums.center.z,
                         sums.n_contacts,
                         sums.n_wall_contacts};
    double greatest[] = {sums.largest_overlap, sums.fastest};
    MPI_Allreduce(MPI_IN_PLACE, added, 16, MPI_DOUBLE, MPI_SUM, communicator);
    MPI_Allreduce(MPI_IN_PLACE, greatest, 2, MPI_DOUBLE, MPI_MAX, communicator);
    GrainSums all;
    all.n               = added[0];
    all.mass            = added[1];
    all.translation     = added[2];
    all.rotation        = added[3];
    all.potential       = added[4];
    all.elastic         = added[5];
    all.sheared         = added[6];
    all.rolled          = added[7];
    all.momentum        = {added[8], added[9], added[10]};
    all.center          = {added[11], added[12], added[13]};
    all.n_contacts      = added[14];
    all.n_wall_contacts = added[15];
    all.largest_overlap = greatest[0];
    all.fastest         = greatest[1];
    return all;
  }
} // namespace Thalweg
