// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "dem/grain_scene.h"

using namespace Thalweg;

namespace
{
  constexpr double  g    = 9.81;
  const std::string soft = "set Normal stiffness = 1000";

  /// A ball of 1 mm on the plane z = 0, at rest on it.
  void
  put_on_plane(GrainScene &scene, const Vec3 &v, const Vec3 &w = {0., 0., 0.})
  {
    const double r    = 1e-3;
    const double mass = 2500. * 4. / 3. * M_PI * r * r * r;
    scene.add_plane({0., 0., 0.}, {0., 0., 1.});
    scene.add_grain({0., 0., r - mass * g / 1000.}, r, v, w);
    scene.begin();
  }
} // namespace



TEST(GrainFriction, ObliqueImpactsThatSlideKeepTheMomentum)
{
  // impact_gross_sliding.csv: v_n, v_t, spin, R, e, mu and what comes of it;
  // the spin adds to the slip.
  // At the end of a contact the dashpot pulls and friction rests, which the
  // table does not know: 3 % with a restitution of 0.5.
  const double rows[][9] = {
    {.2, .5, 0., .1, .5, .4, .38, -3., .04},
    {.2, 1., 0., .1, .5, .4, .88, -3., .04},
    {.2, 0., 24., .1, .5, .4, -.12, 21., .04},
    {1.95, 3.3775, 0., .0025, .98, .092, 3.02229, -355.212, 1e-3},
    {.677228, 3.84075, 0., .0025, .98, .092, 3.71739, -123.364, 1e-3}};
  for (const auto &row : rows)
    {
      const double r = row[3], stiffness = 1e9;
      GrainScene   scene("linear",
                       GrainScene::material(row[4], row[5]),
                       "set Normal stiffness = 1e9");
      const double mass = 2500. * 4. / 3. * M_PI * r * r * r;
      const double dt   = M_PI * std::sqrt(mass / stiffness) / 100.;
      scene.add_plane({0., 0., 0.}, {0., 0., 1.});
      // Slip is v_t + R w with the spin about -y.
      scene.add_grain({0., 0., r + 3.5 * row[0] * dt},
                      r,
                      {row[1], 0., -row[0]},
                      {0., -row[2], 0.});
      scene.begin();
      scene.advance(120, dt);
      const GrainRecord grain = scene.grain(0);
      EXPECT_NEAR(grain.v.x, row[6], row[8] * std::abs(row[1] - row[6]));
      EXPECT_NEAR(-grain.w.y, row[7], row[8] * std::abs(row[2] - row[7]));
    }
}



TEST(GrainFriction, ABallThatSlidesRollsAtFiveSevenths)
{
  for (const int dim : {2, 3})
    {
      GrainScene   scene("linear",
                       GrainScene::material(.5, .3),
                       dim == 3 ? soft : "set Normal stiffness = 1e6",
                       RollingModel::none,
                       dim);
      const double v0 = .1;
      if (dim == 3)
        put_on_plane(scene, {v0, 0., 0.});
      else
        {
          const double r = 1e-3, mass = 2500. * M_PI * r * r;
          scene.add_plane({0., 0., 0.}, {0., 1., 0.});
          scene.add_grain({0., r - mass * g / 1e6, 0.}, r, {v0, 0., 0.});
          scene.begin();
        }
      const Vec3   gravity = dim == 3 ? Vec3{0., 0., -g} : Vec3{0., -g, 0.};
      const double rolling = dim == 3 ? 5. / 7. : 2. / 3.;
      const double end     = (1. - rolling) * v0 / (.3 * g);
      const double dt      = 1e-6;
      scene.advance(static_cast<unsigned int>(.5 * end / dt), dt, gravity);
      EXPECT_NEAR(scene.grain(0).v.x, v0 - .3 * g * .5 * end, 1e-3 * v0);
      scene.advance(static_cast<unsigned int>(end / dt), dt, gravity);
      const GrainRecord grain = scene.grain(0);
      EXPECT_NEAR(grain.v.x, rolling * v0, 1e-3 * v0);
      EXPECT_NEAR(norm(grain.w) * 1e-3, grain.v.x, 1e-3 * v0);
    }
}



TEST(GrainFriction, AConstantTorqueSlowsRollingDown)
{
  GrainScene   scene("linear",
                   GrainScene::material(.5, .8, .05),
                   soft,
                   RollingModel::constant_torque);
  const double v0 = .1;
  put_on_plane(scene, {v0, 0., 0.}, {0., v0 / 1e-3, 0.});
  scene.advance(10000, 1e-6, {0., 0., -g});
  EXPECT_NEAR(v0 - scene.grain(0).v.x,
              5. / 7. * .05 * g * .01,
              1e-2 * 5. / 7. * .05 * g * .01);
}



TEST(GrainFriction, ASpringOfRollingHoldsABallOnASlope)
{
  for (const double slope : {.03, .08})
    {
      GrainScene scene("linear",
                       GrainScene::material(.5, .8, .05),
                       soft,
                       RollingModel::epsd);
      put_on_plane(scene, {0., 0., 0.});
      const Vec3 gravity{g * std::sin(std::atan(slope)),
                         0.,
                         -g * std::cos(std::atan(slope))};
      scene.advance(60000, 5e-6, gravity);
      if (slope < .05)
        EXPECT_LT(norm(scene.grain(0).v), 1e-8);
      else
        EXPECT_NEAR(scene.grain(0).v.x,
                    5. / 7. * g * (slope - .05) * .3,
                    .02 * 5. / 7. * g * (slope - .05) * .3);
    }
}
