// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/grain_motion.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    THALWEG_FOR_ALL_PROCESSORS double
    pass(const std::size_t   n,
         const std::uint8_t *own,
         GrainPlace         *place,
         GrainMotion        *motion,
         GrainLoad          *load,
         GrainMomentum      *momentum,
         const double        kick,
         const double        dt,
         const Vec3          acceleration)
    {
      const Vec3   nothing{0., 0., 0.};
      const double half    = .5 * dt;
      double       fastest = 0.;
      for (std::size_t i = 0; i < n; ++i)
        {
          if (own[i])
            {
              GrainMomentum &p = momentum[i];
              const Vec3     a = p.inverse_mass * load[i].force + acceleration;
              const Vec3     b = p.inverse_inertia * load[i].torque;
              p.v += kick * a;
              p.w += kick * b;
              place[i].x += dt * p.v;
              motion[i].v = p.v + half * a;
              motion[i].w = p.w + half * b;
              fastest     = std::max(fastest, norm_square(p.v));
            }
          load[i].force  = nothing;
          load[i].torque = nothing;
        }
      return fastest;
    }
  } // namespace



  double
  kick_and_drift(GrainArrays &grains,
                 const double kick,
                 const double dt,
                 const Vec3  &acceleration)
  {
    return pass(grains.size(),
                grains.own.data(),
                grains.place.data(),
                grains.motion.data(),
                grains.load.data(),
                grains.momentum.data(),
                kick,
                dt,
                acceleration);
  }



  void
  kick(GrainArrays &grains, const double kick, const Vec3 &acceleration)
  {
    for (std::size_t i = 0; i < grains.size(); ++i)
      if (grains.own[i])
        {
          GrainMomentum &p = grains.momentum[i];
          p.v += kick * (p.inverse_mass * grains.load[i].force + acceleration);
          p.w += (kick * p.inverse_inertia) * grains.load[i].torque;
          grains.motion[i].v = p.v;
          grains.motion[i].w = p.w;
        }
  }
} // namespace Thalweg
