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

  /// By what forces count in the first steps of a contact, and in its last.
  struct Onset
  {
    double spring, dashpot;
    double jump;    ///< of the latter since the step before
    double release; ///< the same where surfaces part, else zero
  };

  /**
   * @brief Contacts begin and end within a step. Forces of springs grow from
   * there on, those of dashpots and of adhesion are there at once, so that the
   * trapezoidal rule for their impulse misses a part of either, which the first
   * and the last steps make good. At the end this comes without a jump: whether
   * another step is still one of contact cannot be foreseen exactly.
   * @param approach velocity, m/s; negative where surfaces near each other
   */
  THALWEG_INLINE Onset
  contact_onset(const double overlap, const double approach, const double dt)
  {
    // Steps since the beginning, or until the end. No branches: they would keep
    // several contacts from being computed at once.
    const double n      = overlap / (std::abs(approach) * dt + 1e-300);
    const bool   nears  = approach < 0.;
    const double spring = n < 1. ? .5 + .5 * n : 1.;
    const double coming = n < 1. ? .5 + n : 1.;
    const double going  = n < 1. ? 1.5 * n : n < 2. ? 2. - .5 * n : 1.;
    const double onset  = n < 1. ? .5 + n : n < 2. ? 1.5 - n : 0.;
    const double end    = n < 1. ? 2. * n - 1.5 : n < 2. ? 1. - .5 * n : 0.;
    return {spring,
            nears ? coming : going,
            nears ? onset : end,
            nears ? 0. : end};
  }



  /**
   * @brief The force of a contact, of two grains or of a grain and a wall alike.
   *
   * @param state relative motion at the end of the step
   * @param inertia effective moment of inertia for rolling, kg m^2
   * @param inverse_inertia_factor m r^2 / I
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
                const double              inverse_inertia_factor,
                const double              dt,
                ContactMemory            &memory,
                ContactWork              &work)
  {
    const Response response = Law::respond(constants.law, touch);
    const Onset    onset    = contact_onset(touch.overlap, state.approach, dt);
    // The velocity is extrapolated from the middle of the step with the forces
    // at its beginning; these have changed since, as springs and dashpots say.
    const double inverse_mass = touch.inverse_mass;
    const double kick         = dt * inverse_mass * response.damping;
    const double change =
      .5 * dt * dt * inverse_mass * response.stiffness + .125 * kick * kick;
    // Nor does it know that the part of the dashpot changes in the last steps.
    const double part = onset.dashpot * larger(0., 1. - kick * onset.release);
    const double lag  = 1. - change + change * change; // 1/(1 + change)
    const double damping = part * lag * response.damping;
    const double spring  = response.elastic + response.adhesion;
    const double normal  = onset.spring * spring -
                          onset.dashpot * response.adhesion -
                          damping * state.approach;
    if constexpr (counts)
      {
        // With the mean of the velocities before and after the kick.
        const double jump = part - onset.dashpot + onset.jump;
        const double mean = state.approach * (lag - .5 * kick * jump);
        work.normal += damping * state.approach * mean * dt;
      }
    ContactForce result{normal * state.normal, {0., 0., 0.}, {0., 0., 0.}};
    const double load = larger(0., normal + response.adhesion);
    if (constants.friction.sliding > 0.)
      {
        turn(memory.slip, state.normal);
        result.friction =
          friction_force<counts>(response,
                                 state.slip,
                                 constants.friction.sliding * load,
                                 -constants.friction.sliding *
                                   response.stiffness * state.approach,
                                 inverse_mass * (1. + inverse_inertia_factor),
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
