// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_wall_loop_h
#define thalweg_dem_wall_loop_h

#include <thalweg/dem/contact_force.h>
#include <thalweg/dem/grain_arrays.h>
#include <thalweg/dem/wall_geometry.h>

namespace Thalweg
{
  /// What a grain remembers of a contact with a wall.
  struct WallMemory
  {
    ContactMemory springs;
    Vec3          normal;
    std::uint32_t wall = no_wall; ///< no_wall: nothing is remembered
  };

  /// What the loop over contacts with walls works on.
  struct WallLoop
  {
    std::size_t          n_grains; ///< that are near walls
    const std::uint32_t *grain;    ///< which
    const std::uint32_t *begin;    ///< of the facets near each of them
    const std::uint32_t *facet;    ///< these
    WallMemory          *memory;   ///< as many
    const Facet         *facets;
    const Wall          *walls;
    WallForce           *wall_force; ///< of each wall: gets what acts on it
    const GrainPlace    *place;
    const GrainMotion   *motion;
    GrainLoad           *load;
    const std::uint8_t  *material;
    unsigned int         n_materials;
    double               inertia_factor; ///< I / (m r^2)
    double               dt;             ///< s
    ContactWork         *work;
    double              *wall_work; ///< gets what walls did to grains, J
  };



  /// The memory of the contact with this wall that was of the nearest direction
  /// in the last step: histories pass from face to face.
  THALWEG_INLINE ContactMemory
  recall(const WallMemory  *old,
         const unsigned int n_old,
         bool              *is_taken,
         const FacetTouch  &touch)
  {
    unsigned int best        = n_old;
    double       dot_of_best = .8;
    for (unsigned int m = 0; m < n_old; ++m)
      if (!is_taken[m] && old[m].wall == touch.wall)
        {
          const double similar = dot(old[m].normal, touch.normal);
          if (similar > dot_of_best)
            {
              best        = m;
              dot_of_best = similar;
            }
        }
    if (best == n_old)
      return {{0., 0., 0.}, {0., 0., 0.}};
    is_taken[best] = true;
    return old[best].springs;
  }



  /// How a grain moves against the wall that it touches.
  THALWEG_INLINE ContactState
  state_at_wall(const GrainPlace  &place,
                const GrainMotion &grain,
                const Wall        &wall,
                const FacetTouch  &touch)
  {
    const double arm      = place.r - touch.overlap;
    const Vec3   point    = place.x - arm * touch.normal;
    const Vec3   relative = grain.v - wall.velocity_at(point, touch.normal);
    ContactState state;
    state.normal   = touch.normal;
    state.approach = dot(relative, state.normal);
    state.spin     = grain.w - wall.w;
    state.slip     = relative - state.approach * state.normal -
                 cross(arm * grain.w, state.normal);
    return state;
  }



  /// The force of one contact with a wall on a grain.
  template <typename Law, typename Rolling, bool counts>
  THALWEG_INLINE WallMemory
  touch_wall(const WallLoop           &loop,
             const PairConstants<Law> *constants,
             const std::uint32_t       i,
             const FacetTouch         &touch,
             ContactMemory             memory,
             ContactWork              &work)
  {
    const GrainMotion &grain = loop.motion[i];
    const Wall        &wall  = loop.walls[touch.wall];
    const double       r     = loop.place[i].r;
    const double       mass  = 1. / grain.inverse_mass;
    const double       arm   = r - touch.overlap;
    const Vec3         point = loop.place[i].x - arm * touch.normal;
    const ContactState state = state_at_wall(loop.place[i], grain, wall, touch);
    const ContactForce result = contact_force<Law, Rolling, counts>(
      constants[loop.material[i] * loop.n_materials + wall.material],
      {touch.overlap, r, mass, arm, grain.inverse_mass},
      state,
      loop.inertia_factor * mass * r * r,
      1. / loop.inertia_factor,
      loop.dt,
      memory,
      work);
    const Vec3 torque =
      result.torque - arm * cross(state.normal, result.friction);
    loop.load[i].force += result.force;
    loop.load[i].torque += torque;
    if constexpr (counts)
      {
        WallForce &on_wall = loop.wall_force[touch.wall];
        on_wall.force -= result.force;
        on_wall.torque -=
          cross(point - wall.center, result.force) + result.torque;
        *loop.wall_work +=
          loop.dt * (dot(result.force, wall.velocity_at(point, touch.normal)) +
                     dot(result.torque, wall.w));
      }
    return {memory, touch.normal, touch.wall};
  }



  /**
   * @brief Adds the forces of all contacts with walls. What a grain touches is
   * the nearest point of each facet, unless that of another one, nearer, hides
   * it (see visible_touches()).
   */
  template <typename Law, typename Rolling, bool counts>
  THALWEG_INLINE void
  for_all_walls(const WallLoop &loop, const PairConstants<Law> *constants)
  {
    ContactWork work;
    for (std::size_t g = 0; g < loop.n_grains; ++g)
      {
        const std::uint32_t i      = loop.grain[g];
        const std::uint32_t begin  = loop.begin[g];
        const unsigned int  n      = loop.begin[g + 1] - begin;
        WallMemory         *memory = loop.memory + begin;
        FacetTouch          touches[most_touches];
        const unsigned int  n_touches = visible_touches(loop.facets,
                                                       loop.walls,
                                                       loop.facet + begin,
                                                       n,
                                                       loop.place[i],
                                                       touches);
        WallMemory          old[most_touches];
        bool                is_taken[most_touches];
        unsigned int        n_old = 0;
        for (;
             n_old < n && n_old < most_touches && memory[n_old].wall != no_wall;
             ++n_old)
          {
            old[n_old]      = memory[n_old];
            is_taken[n_old] = false;
          }
        for (unsigned int t = 0; t < n_touches; ++t)
          memory[t] = touch_wall<Law, Rolling, counts>(
            loop,
            constants,
            i,
            touches[t],
            recall(old, n_old, is_taken, touches[t]),
            work);
        for (unsigned int t = n_touches; t < n_old; ++t)
          memory[t].wall = no_wall;
      }
    if constexpr (counts)
      {
        loop.work->normal += work.normal;
        loop.work->tangential += work.tangential;
        loop.work->rolling += work.rolling;
      }
  }
} // namespace Thalweg

#endif
