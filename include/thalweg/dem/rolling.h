// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_rolling_h
#define thalweg_dem_rolling_h

#include <thalweg/dem/contact.h>

namespace Thalweg
{
  /// Nothing resists rolling.
  struct FreeRolling
  {
    static constexpr bool resists   = false;
    static constexpr bool remembers = false;

    template <bool>
    static THALWEG_INLINE Vec3
    torque(const Touch &,
           const Response &,
           const Friction &,
           const Vec3 &,
           const double,
           const double,
           const double,
           Vec3 &,
           double &)
    {
      return {0., 0., 0.};
    }
  };

  /// A torque against the relative spin, of rolling friction times normal force
  /// times effective radius, whatever the speed (model A of Ai et al. 2011).
  struct ConstantTorque
  {
    static constexpr bool resists   = true;
    static constexpr bool remembers = false;

    /**
     * @param spin relative spin at right angles to the normal, rad/s
     * @param load normal force, N
     * @param inertia effective moment of inertia, kg m^2: the torque does not
     *   turn the spin around within a step
     * @param work is increased by what was lost, J, if @p counts
     */
    template <bool counts>
    static THALWEG_INLINE Vec3
    torque(const Touch &touch,
           const Response &,
           const Friction &friction,
           const Vec3     &spin,
           const double    load,
           const double    inertia,
           const double    dt,
           Vec3 &,
           double &work)
    {
      const double speed = norm(spin);
      const double size =
        std::min(friction.rolling * load * touch.effective_radius,
                 .5 * inertia * speed / dt);
      const Vec3 torque = (-size / (speed + 1e-300)) * spin;
      if constexpr (counts)
        work -= dt * dot(torque, spin);
      return torque;
    }
  };

  /// An elastic-plastic spring with a dashpot, which holds slopes (model C of
  /// Ai et al. 2011, its stiffness after Iwashita and Oda).
  struct ElasticPlasticRolling
  {
    static constexpr bool resists   = true;
    static constexpr bool remembers = true;

    /// Arguments as of ConstantTorque; @p memory is the spring's angle, half a
    /// step ahead.
    template <bool counts>
    static THALWEG_INLINE Vec3
    torque(const Touch    &touch,
           const Response &response,
           const Friction &friction,
           const Vec3     &spin,
           const double    load,
           const double    inertia,
           const double    dt,
           Vec3           &memory,
           double         &work)
    {
      const double arm       = friction.rolling * touch.effective_radius;
      const double limit     = arm * load;
      const double stiffness = 2.25 * response.stiffness * arm * arm + 1e-300;
      const double damping =
        friction.rolling_damping * 2. * std::sqrt(stiffness * inertia);
      const Vec3   half   = (.5 * dt) * spin;
      Vec3         angle  = memory + half;
      Vec3         torque = -(stiffness * angle);
      const double square = norm_square(torque);
      if (square > limit * limit)
        {
          torque = (limit / std::sqrt(square)) * torque;
          angle  = (-1. / stiffness) * torque;
        }
      else
        torque -= damping * spin;
      memory = angle + half;
      if constexpr (counts)
        work -= dt * dot(torque, spin);
      return torque;
    }
  };
} // namespace Thalweg

#endif
