// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_pair_loop_h
#define thalweg_dem_pair_loop_h

#include <thalweg/dem/contact_force.h>
#include <thalweg/dem/grain_arrays.h>

namespace Thalweg
{
  /// A pair that touches: its grains, and where it is in the list.
  struct TouchingPair
  {
    std::uint32_t i, j, k;
  };

  /// What the loop over pairs works on: bare arrays, so that nothing but them
  /// is compiled for several processors.
  struct PairLoop
  {
    std::size_t          n_grains;
    const GrainPlace    *place;
    const GrainMotion   *motion;
    GrainLoad           *load;
    const std::uint8_t  *material;
    const std::uint8_t  *own;
    const std::uint32_t *begin;    ///< of each grain's pairs, n_grains + 1
    const std::uint32_t *partner;  ///< of each pair, behind the grain
    TouchingPair        *hits;     ///< room for one more than all pairs
    std::uint8_t        *touching; ///< of each pair: at the last step
    Vec3                *slip;     ///< of each pair: its memory, else zero
    Vec3                *roll;     ///< of each pair, if rolling remembers
    unsigned int         n_materials;
    double               inertia_factor; ///< I / (m r^2)
    double               dt;             ///< s
    ContactWork         *work;
  };

  /**
   * @brief Writes the pairs that touch. What those remember that do no longer is
   * forgotten.
   * @return how many there are
   */
  template <typename Rolling>
  THALWEG_INLINE std::size_t
                 find_touching(const PairLoop &loop)
  {
    const GrainPlace *place = loop.place;
    const Vec3        nothing{0., 0., 0.};
    std::size_t       n = 0;
    for (std::size_t i = 0; i < loop.n_grains; ++i)
      {
        const GrainPlace    a   = place[i];
        const std::uint32_t end = loop.begin[i + 1];
        for (std::uint32_t k = loop.begin[i]; k < end; ++k)
          {
            const std::uint32_t j       = loop.partner[k];
            const double        square  = norm_square(a.x - place[j].x);
            const double        contact = a.r + place[j].r;
            const bool          touches = square < contact * contact;
            // No branch: whether they touch cannot be predicted.
            loop.hits[n] = {static_cast<std::uint32_t>(i), j, k};
            n += touches;
            if (loop.touching[k] & !touches)
              {
                loop.slip[k] = nothing;
                if constexpr (Rolling::remembers)
                  loop.roll[k] = nothing;
              }
            loop.touching[k] = touches;
          }
      }
    return n;
  }



  /// How two grains that touch move.
  struct PairGeometry
  {
    Touch        touch;
    ContactState state;
    double       arm_a, arm_b; ///< from the centers to the contact, m
  };

  THALWEG_INLINE PairGeometry
  pair_geometry(const GrainPlace  &a,
                const GrainPlace  &b,
                const GrainMotion &ma,
                const GrainMotion &mb)
  {
    PairGeometry pair;
    const Vec3   way      = a.x - b.x;
    const double contact  = a.r + b.r;
    const double distance = std::sqrt(norm_square(way));
    const double part     = a.r / contact;
    const double overlap  = contact - distance;
    // The arms add up to the distance: nothing else keeps the angular momentum.
    pair.arm_b                = b.r - overlap * part;
    pair.arm_a                = distance - pair.arm_b;
    const double inverse_mass = ma.inverse_mass + mb.inverse_mass;
    pair.touch                = {
                     overlap, part * b.r, 1. / inverse_mass, distance, inverse_mass};
    pair.state.normal   = (1. / distance) * way;
    const Vec3 relative = ma.v - mb.v;
    pair.state.approach = dot(relative, pair.state.normal);
    pair.state.spin     = ma.w - mb.w;
    pair.state.slip =
      relative - pair.state.approach * pair.state.normal -
      cross(pair.arm_a * ma.w + pair.arm_b * mb.w, pair.state.normal);
    return pair;
  }



  /**
   * @brief Adds the forces of all pairs that touch, in the order of the list.
   * @tparam one_material whether the constants are the same for all
   */
  template <typename Law, typename Rolling, bool one_material, bool counts>
  THALWEG_INLINE void
  for_all_pairs(const PairLoop &loop, const PairConstants<Law> *constants)
  {
    GrainLoad        *load                   = loop.load;
    const std::size_t n_hits                 = find_touching<Rolling>(loop);
    const double      inverse_inertia_factor = 1. / loop.inertia_factor;
    ContactWork       total;
    for (std::size_t h = 0; h < n_hits; ++h)
      {
        const auto [i, j, k]      = loop.hits[h];
        const PairGeometry pair   = pair_geometry(loop.place[i],
                                                loop.place[j],
                                                loop.motion[i],
                                                loop.motion[j]);
        const double       radius = pair.touch.effective_radius;
        ContactMemory      memory{loop.slip[k], {0., 0., 0.}};
        if constexpr (Rolling::remembers)
          memory.roll = loop.roll[k];
        ContactWork        work;
        const ContactForce result = contact_force<Law, Rolling, counts>(
          one_material
            ? constants[0]
            : constants[loop.material[i] * loop.n_materials + loop.material[j]],
          pair.touch,
          pair.state,
          loop.inertia_factor * pair.touch.effective_mass * radius * radius,
          inverse_inertia_factor,
          loop.dt,
          memory,
          work);
        if constexpr (counts)
          {
            // The other half of a pair across a border is counted there.
            const double share = .5 * (loop.own[i] + loop.own[j]);
            total.normal += share * work.normal;
            total.tangential += share * work.tangential;
            total.rolling += share * work.rolling;
          }
        loop.slip[k] = memory.slip;
        if constexpr (Rolling::remembers)
          loop.roll[k] = memory.roll;
        const Vec3 twist = cross(pair.state.normal, result.friction);
        load[i].force += result.force;
        load[j].force -= result.force;
        load[i].torque -= pair.arm_a * twist;
        load[j].torque -= pair.arm_b * twist;
        if constexpr (Rolling::resists)
          {
            load[i].torque += result.torque;
            load[j].torque -= result.torque;
          }
      }
    if constexpr (counts)
      {
        loop.work->normal += total.normal;
        loop.work->tangential += total.tangential;
        loop.work->rolling += total.rolling;
      }
  }
} // namespace Thalweg

#endif
