// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_contact_force_h
#define thalweg_dem_contact_force_h

#include <thalweg/dem/rolling.h>

namespace Thalweg
{
  /// What a law says of a pair of materials, and friction.
  template <typename Law>
  struct PairConstants
  {
    typename Law::Constants law;
    Friction                friction;
  };

  /**
   * @brief The force of a contact, of two grains or of a grain and a wall alike.
   *
   * @param state relative motion at the end of the step
   * @param inertia effective moment of inertia for rolling, kg m^2
   * @param dt since the last time, s
   * @param memory of the contact, changed
   * @param work gets what was lost, J, if @p counts
   */
  template <typename Law, typename Rolling, bool counts>
  THALWEG_INLINE ContactForce
  contact_force(const PairConstants<Law> &constants,
                const Touch              &touch,
                const ContactState       &state,
                const double              inertia,
                const double              dt,
                ContactMemory            &memory,
                ContactWork              &work)
  {
    const Response response = Law::respond(constants.law, touch);
    // A dashpot pulls as soon as surfaces meet and until they part. In the step
    // in which that happens it acts for a part of the time, or a longer one
    // than the step: else the restitution depends on when contacts begin.
    const double n_steps =
      touch.overlap / (std::abs(state.approach) * dt + 1e-300);
    const double damping =
      (n_steps < 1. ? .5 + n_steps : 1.) * response.damping;
    const double normal = response.elastic - damping * state.approach;
    if constexpr (counts)
      work.normal += damping * state.approach * state.approach * dt;
    ContactForce result{normal * state.normal, {0., 0., 0.}, {0., 0., 0.}};
    const double load = std::max(0., normal + response.adhesion);
    if (constants.friction.sliding > 0.)
      {
        turn(memory.slip, state.normal);
        result.friction =
          friction_force<counts>(response,
                                 state.slip,
                                 constants.friction.sliding * load,
                                 dt,
                                 memory.slip,
                                 work.tangential);
        result.force += result.friction;
      }
    if constexpr (Rolling::resists)
      {
        const Vec3 spin =
          state.spin - dot(state.spin, state.normal) * state.normal;
        if constexpr (Rolling::remembers)
          turn(memory.roll, state.normal);
        result.torque = Rolling::template torque<counts>(touch,
                                                         response,
                                                         constants.friction,
                                                         spin,
                                                         load,
                                                         inertia,
                                                         dt,
                                                         memory.roll,
                                                         work.rolling);
      }
    return result;
  }
} // namespace Thalweg

#endif
