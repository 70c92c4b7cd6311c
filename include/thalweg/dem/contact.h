// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_contact_h
#define thalweg_dem_contact_h

#include <thalweg/dem/vec3.h>

#include <algorithm>

namespace Thalweg
{
  /// What the laws of contact are told of one.
  struct Touch
  {
    double overlap;           ///< m
    double effective_radius;  ///< r1 r2 / (r1 + r2), m; at walls the grain's
    double effective_mass;    ///< m1 m2 / (m1 + m2), kg; at walls the grain's
    double distance;          ///< of the centres, or from the wall, m
    double inverse_mass = 0.; ///< 1 over the effective one, 1/kg
  };

  /// What they answer: a force elastic - damping v_n, repulsive where positive,
  /// and the spring and dashpot at right angles to it.
  struct Response
  {
    double elastic;               ///< N
    double stiffness;             ///< d elastic / d overlap, N/m
    double damping;               ///< N s/m
    double tangential_stiffness;  ///< N/m
    double tangential_damping;    ///< N s/m
    double adhesion;              ///< N, part of elastic: friction ignores it
    double tangential_compliance; ///< 1 over tangential_stiffness, m/N
  };

  /// What holds for two materials whatever the law.
  struct Friction
  {
    double sliding;         ///< Coulomb's coefficient
    double rolling;         ///< torque over force and effective radius
    double rolling_damping; ///< part of the critical one
  };

  /// Two surfaces that touch: seen from the first of them.
  struct ContactState
  {
    Vec3   normal;   ///< towards the first
    Vec3   slip;     ///< relative velocity of the surfaces, m/s
    Vec3   spin;     ///< relative spin, rad/s
    double approach; ///< relative velocity along the normal, m/s
  };

  /// What a contact remembers: displacements of its springs, half a step ahead
  /// (see contact_force()).
  struct ContactMemory
  {
    Vec3 slip; ///< m
    Vec3 roll; ///< rad
  };

  /// What springs have at the end of a step of @p dt s, of which a contact
  /// remembers more.
  inline ContactMemory
  memory_now(const ContactMemory &memory,
             const ContactState  &state,
             const double         dt)
  {
    const Vec3 spin = state.spin - dot(state.spin, state.normal) * state.normal;
    return {memory.slip - (.5 * dt) * state.slip,
            memory.roll - (.5 * dt) * spin};
  }

  /// What went out of the motion, J: in the dashpot along the normal; in
  /// springs, dashpots and slip at right angles to it; in rolling.
  struct ContactWork
  {
    double normal = 0., tangential = 0., rolling = 0.;
  };

  /// What contacts do to the first of two.
  struct ContactForce
  {
    Vec3 force;    ///< N
    Vec3 friction; ///< its part at right angles to the normal, N
    Vec3 torque;   ///< of rolling resistance, N m
  };

  /**
   * @brief Turns what a contact remembers with the pair: the part along the
   * normal vanishes and the length stays.
   */
  THALWEG_INLINE void
  turn(Vec3 &memory, const Vec3 &normal)
  {
    const double along = dot(memory, normal);
    memory -= along * normal;
    // The length but for terms of fourth order in the angle of one step.
    const double left = norm_square(memory);
    const double part = along * along / (left + 1e-300);
    memory            = (1. + .5 * smaller(part, 1.)) * memory;
  }



  /**
   * @brief Coulomb friction with a spring (Eq. 11-14 of seed 001).
   *
   * The spring's displacement is integrated by the trapezoidal rule: what is
   * remembered is ahead of it by half a step.
   * @param memory is turned with the pair before
   * @param limit greatest force, N
   * @param limit_rate what that grows by in a second, N/s
   * @param inverse_mass of what the force moves at right angles, 1/kg
   * @param work is increased by what went into spring, dashpot and slip, J, if
   *   @p counts
   */
  template <bool counts>
  THALWEG_INLINE Vec3
  friction_force(const Response &response,
                 const Vec3     &slip,
                 const double    limit,
                 const double    limit_rate,
                 const double    inverse_mass,
                 const double    dt,
                 Vec3           &memory,
                 double         &work)
  {
    const Vec3 half   = (.5 * dt) * slip;
    Vec3       spring = memory + half;
    Vec3       force  = -(response.tangential_stiffness * spring) -
                 response.tangential_damping * slip;
    // No branch: what slips cannot be predicted. The spring gives way by what
    // is too much.
    const double inverse = 1. / (std::sqrt(norm_square(force)) + 1e-300);
    const double kept    = smaller(1., limit * inverse);
    const Vec3   asked   = force;
    spring += ((1. - kept) * response.tangential_compliance) * force;
    force  = kept * force;
    memory = spring + half;
    if constexpr (counts)
      {
        // The force acts with the mean of the velocities before and after its
        // kick; what is known was extrapolated with the force before.
        const double slides = kept < 1.; // no branch, as above
        const Vec3   rate =
          (slides * limit_rate * inverse) * asked -
          ((1. - slides) * response.tangential_stiffness) * slip;
        work -= dt * dot(force, slip + (.5 * dt * dt * inverse_mass) * rate);
      }
    return force;
  }
} // namespace Thalweg

#endif
