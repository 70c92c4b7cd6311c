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

  /// What two grains that touch have; of their places and velocities the
  /// differences.
  struct PairState
  {
    Vec3   way;            ///< from the second to the first, m
    Vec3   relative;       ///< velocity of the first against the second, m/s
    Vec3   spin_a, spin_b; ///< rad/s
    double r_a, r_b;       ///< m
    double inverse_mass_a, inverse_mass_b; ///< 1/kg
  };

  THALWEG_INLINE PairGeometry
  pair_geometry(const PairState &two)
  {
    PairGeometry pair;
    const double contact  = two.r_a + two.r_b;
    const double distance = std::sqrt(norm_square(two.way));
    const double part     = two.r_a / contact;
    const double overlap  = contact - distance;
    // The arms add up to the distance: nothing else keeps the angular momentum.
    pair.arm_b                = two.r_b - overlap * part;
    pair.arm_a                = distance - pair.arm_b;
    const double inverse_mass = two.inverse_mass_a + two.inverse_mass_b;
    pair.touch                = {
                     overlap, part * two.r_b, 1. / inverse_mass, distance, inverse_mass};
    pair.state.normal   = (1. / distance) * two.way;
    pair.state.approach = dot(two.relative, pair.state.normal);
    pair.state.spin     = two.spin_a - two.spin_b;
    pair.state.slip = two.relative - pair.state.approach * pair.state.normal -
                      cross(pair.arm_a * two.spin_a + pair.arm_b * two.spin_b,
                            pair.state.normal);
    return pair;
  }

  THALWEG_INLINE PairGeometry
  pair_geometry(const GrainPlace  &a,
                const GrainPlace  &b,
                const GrainMotion &ma,
                const GrainMotion &mb)
  {
    return pair_geometry({a.x - b.x,
                          ma.v - mb.v,
                          ma.w,
                          mb.w,
                          a.r,
                          b.r,
                          ma.inverse_mass,
                          mb.inverse_mass});
  }



  /// Vectors of some pairs, one component behind the other.
  struct BlockVector
  {
    static constexpr std::size_t size = 32;

    double x[size], y[size], z[size];

    THALWEG_INLINE Vec3
    operator[](const std::size_t h) const
    {
      return {x[h], y[h], z[h]};
    }

    THALWEG_INLINE void
    set(const std::size_t h, const Vec3 &v)
    {
      x[h] = v.x;
      y[h] = v.y;
      z[h] = v.z;
    }
  };

  /**
   * @brief Some pairs at a time, laid out so that the compiler makes one
   * instruction of several pairs. There are always as many, the last ones
   * several times if need be: so the same pair has the same bits wherever it
   * is.
   */
  struct PairBlock
  {
    static constexpr std::size_t size = BlockVector::size;

    BlockVector way, relative, spin_a, spin_b, slip,
      roll; ///< PairState, memory
    double r_a[size], r_b[size], inverse_mass_a[size], inverse_mass_b[size];
    BlockVector force, twist, torque;
    double      arm_a[size], arm_b[size];
    double      normal_work[size], tangential_work[size], rolling_work[size];
  };



  /// Reads pairs into a block. @param n how many there are
  template <typename Rolling>
  THALWEG_INLINE void
  fill_block(const PairLoop     &loop,
             const TouchingPair *hits,
             const std::size_t   n,
             PairBlock          &block)
  {
    for (std::size_t h = 0; h < PairBlock::size; ++h)
      {
        const auto [i, j, k] = hits[h < n ? h : n - 1];
        const GrainMotion &a = loop.motion[i], &b = loop.motion[j];
        block.r_a[h]            = loop.place[i].r;
        block.r_b[h]            = loop.place[j].r;
        block.inverse_mass_a[h] = a.inverse_mass;
        block.inverse_mass_b[h] = b.inverse_mass;
        block.way.set(h, loop.place[i].x - loop.place[j].x);
        block.relative.set(h, a.v - b.v);
        block.spin_a.set(h, a.w);
        block.spin_b.set(h, b.w);
        block.slip.set(h, loop.slip[k]);
        if constexpr (Rolling::remembers)
          block.roll.set(h, loop.roll[k]);
      }
  }



  /// Finds the forces of the pairs of a block.
  /// @param constants_of says the constants of a pair
  template <typename Law, typename Rolling, bool counts, typename ConstantsOf>
  THALWEG_INLINE void
  find_forces(const PairLoop    &loop,
              const ConstantsOf &constants_of,
              PairBlock         &block)
  {
    const double inertia_factor         = loop.inertia_factor;
    const double inverse_inertia_factor = 1. / inertia_factor;
    const double dt                     = loop.dt;
    for (std::size_t h = 0; h < PairBlock::size; ++h)
      {
        const PairGeometry pair   = pair_geometry({block.way[h],
                                                   block.relative[h],
                                                   block.spin_a[h],
                                                   block.spin_b[h],
                                                   block.r_a[h],
                                                   block.r_b[h],
                                                   block.inverse_mass_a[h],
                                                   block.inverse_mass_b[h]});
        const double       radius = pair.touch.effective_radius;
        ContactMemory      memory{block.slip[h], {0., 0., 0.}};
        if constexpr (Rolling::remembers)
          memory.roll = block.roll[h];
        ContactWork        work;
        const ContactForce result = contact_force<Law, Rolling, counts>(
          constants_of(h),
          pair.touch,
          pair.state,
          inertia_factor * pair.touch.effective_mass * radius * radius,
          inverse_inertia_factor,
          dt,
          memory,
          work);
        block.force.set(h, result.force);
        block.twist.set(h, cross(pair.state.normal, result.friction));
        block.arm_a[h] = pair.arm_a;
        block.arm_b[h] = pair.arm_b;
        block.slip.set(h, memory.slip);
        if constexpr (Rolling::remembers)
          block.roll.set(h, memory.roll);
        if constexpr (Rolling::resists)
          block.torque.set(h, result.torque);
        if constexpr (counts)
          {
            block.normal_work[h]     = work.normal;
            block.tangential_work[h] = work.tangential;
            block.rolling_work[h]    = work.rolling;
          }
      }
  }



  /// Adds what a block has to loads, memory and work.
  template <typename Rolling, bool counts>
  THALWEG_INLINE void
  empty_block(const PairLoop     &loop,
              const TouchingPair *hits,
              const std::size_t   n,
              const PairBlock    &block,
              ContactWork        &total)
  {
    for (std::size_t h = 0; h < n; ++h)
      {
        const auto [i, j, k] = hits[h];
        GrainLoad &a = loop.load[i], &b = loop.load[j];
        a.force += block.force[h];
        b.force -= block.force[h];
        a.torque -= block.arm_a[h] * block.twist[h];
        b.torque -= block.arm_b[h] * block.twist[h];
        if constexpr (Rolling::resists)
          {
            a.torque += block.torque[h];
            b.torque -= block.torque[h];
          }
        loop.slip[k] = block.slip[h];
        if constexpr (Rolling::remembers)
          loop.roll[k] = block.roll[h];
        if constexpr (counts)
          {
            // The other half of a pair across a border is counted there.
            const double share = .5 * (loop.own[i] + loop.own[j]);
            total.normal += share * block.normal_work[h];
            total.tangential += share * block.tangential_work[h];
            total.rolling += share * block.rolling_work[h];
          }
      }
  }



  /**
   * @brief Adds the forces of all pairs that touch, in the order of the list.
   * @tparam one_material whether the constants are the same for all
   */
  template <typename Law, typename Rolling, bool one_material, bool counts>
  THALWEG_INLINE void
  for_all_pairs(const PairLoop &loop, const PairConstants<Law> *constants)
  {
    PairBlock                block;
    const PairConstants<Law> only   = constants[0];
    const std::size_t        n_hits = find_touching<Rolling>(loop);
    ContactWork              total;
    for (std::size_t first = 0; first < n_hits; first += PairBlock::size)
      {
        const TouchingPair *hits = loop.hits + first;
        const std::size_t   n    = std::min(PairBlock::size, n_hits - first);
        fill_block<Rolling>(loop, hits, n, block);
        if constexpr (one_material)
          find_forces<Law, Rolling, counts>(
            loop, [&](const std::size_t) { return only; }, block);
        else
          find_forces<Law, Rolling, counts>(
            loop,
            [&](const std::size_t h) {
              const TouchingPair &hit = hits[h < n ? h : n - 1];
              return constants[loop.material[hit.i] * loop.n_materials +
                               loop.material[hit.j]];
            },
            block);
        empty_block<Rolling, counts>(loop, hits, n, block, total);
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
