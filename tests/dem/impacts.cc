// SPDX-License-Identifier: LGPL-2.1-or-later
// Head-on impacts against closed forms (linear_contact.csv and Chung & Ooi
// 2011, tests 1 to 3, of the reference data).
#include <cmath>
#include <gtest/gtest.h>

#include "dem/grain_scene.h"

using namespace Thalweg;

namespace
{
  /// What came of an impact.
  struct Impact
  {
    double restitution, overlap, duration;
  };

  /**
   * @brief Lets two equal grains meet, or one and a plane.
   * @param speed of approach, m/s
   * @param dt s
   * @param phase of the first step in which they touch when that begins
   */
  Impact
  impact(GrainScene  &scene,
         const bool   at_wall,
         const double r,
         const double speed,
         const double dt,
         const double phase)
  {
    const double before = (3. + phase) * speed * dt;
    if (at_wall)
      {
        scene.add_plane({0., 0., 0.}, {1., 0., 0.});
        scene.add_grain({r + before, 0., 0.}, r, {-speed, 0., 0.});
      }
    else
      {
        scene.add_grain({0., 0., 0.}, r, {.5 * speed, 0., 0.});
        scene.add_grain({2. * r + before, 0., 0.}, r, {-.5 * speed, 0., 0.});
      }
    scene.begin();
    Impact              result{0., 0., 0.};
    std::vector<double> overlaps;
    const auto          overlap = [&]() {
      return at_wall ? r - scene.grain(0).x.x
                              : 2. * r - (scene.grain(1).x.x - scene.grain(0).x.x);
    };
    double end = 0., last = overlap();
    for (unsigned int step = 1; step < 2000; ++step)
      {
        scene.advance(1, dt);
        const double now = overlap();
        overlaps.push_back(now);
        if (step > 10 && now < 0.)
          {
            end = (step - 1 + last / (last - now)) * dt;
            break;
          }
        last = now;
      }
    scene.advance(5, dt);
    result.duration = end - (3. + phase) * dt;
    result.restitution =
      (at_wall ? scene.grain(0).v.x : scene.grain(1).v.x - scene.grain(0).v.x) /
      speed;
    for (std::size_t i = 1; i + 1 < overlaps.size(); ++i)
      if (overlaps[i] >= overlaps[i - 1] && overlaps[i] > overlaps[i + 1])
        {
          // The top of the parabola through three points.
          const double a = overlaps[i - 1] - overlaps[i + 1];
          const double b = overlaps[i - 1] - 2. * overlaps[i] + overlaps[i + 1];
          result.overlap = overlaps[i] - a * a / (8. * b);
        }
    return result;
  }

  /// Errors of an impact with a linear spring, relative to the closed form.
  Impact
  errors_of_linear(const double e,
                   const double steps_a_contact,
                   const double phase,
                   const bool   at_wall)
  {
    const double r = 1e-3, k = 1000., speed = .3;
    const double m = 2500. * 4. / 3. * M_PI * r * r * r * (at_wall ? 1. : .5);
    const double zeta =
      -std::log(e) / std::sqrt(M_PI * M_PI + std::log(e) * std::log(e));
    const double omega    = std::sqrt(k / m);
    const double root     = std::sqrt(1. - zeta * zeta);
    const double duration = M_PI / (omega * root);
    const double overlap =
      speed / omega * std::exp(-zeta * std::acos(zeta) / root);
    GrainScene   scene("linear",
                     GrainScene::material(e),
                     "set Normal stiffness = 1000");
    const Impact found =
      impact(scene, at_wall, r, speed, duration / steps_a_contact, phase);
    return {found.restitution - e,
            found.overlap / overlap - 1.,
            found.duration / duration - 1.};
  }
} // namespace



TEST(GrainImpacts, LinearOnesAreThoseOfTheClosedForm)
{
  for (const double e : {.1, .2, .3, .5, .8, .95, 1.})
    for (double phase = .01; phase < 1.; phase += .07)
      for (const bool at_wall : {false, true})
        {
          const Impact error = errors_of_linear(e, 50., phase, at_wall);
          EXPECT_NEAR(error.restitution, 0., 1e-3) << e << ' ' << phase;
          EXPECT_NEAR(error.overlap, 0., 1e-3) << e << ' ' << phase;
          EXPECT_NEAR(error.duration, 0., 1e-3) << e << ' ' << phase;
        }
}



TEST(GrainImpacts, TheErrorIsOfSecondOrder)
{
  const auto worst = [](const double steps) {
    double error = 0.;
    for (double phase = .05; phase < 1.; phase += .1)
      error = std::max(
        error, std::abs(errors_of_linear(.5, steps, phase, true).restitution));
    return error;
  };
  EXPECT_GT(worst(25.) / worst(100.), 11.);
}



TEST(GrainImpacts, HertzianOnesAreThoseOfTheory)
{
  // Chung & Ooi, test 1: glass at 20 m/s.
  PairMaterial glass{25e9, 1e10, 48e9, .2, 1., 0., {0., 0., 0.}};
  GrainScene   scene("hertz mindlin", glass, "", RollingModel::none, 3, 2800.);
  const double duration = 4.03388e-5, overlap = 2.74113e-4;
  const Impact found = impact(scene, false, .01, 20., duration / 100., .3);
  EXPECT_NEAR(found.restitution, 1., 1e-5);
  EXPECT_NEAR(found.overlap / overlap, 1., 1e-3);
  EXPECT_NEAR(found.duration / duration, 1., 1e-3);
  EXPECT_NEAR(scene.law->shortest_contact({.01, .00586431, 20.}) / duration,
              1.,
              1e-3);
}



TEST(GrainImpacts, HertzianOnesHaveTheRestitutionAskedForAtAnySpeed)
{
  for (const double e : {.2, .4, .6, .8, .95})
    for (const double speed : {.01, 3.9})
      {
        GrainScene   scene("hertz mindlin", GrainScene::material(e, 0.));
        const double m = 2500. * 4. / 3. * M_PI * 1e-9;
        const double duration =
          scene.law->shortest_contact({1e-3, .5 * m, speed});
        const Impact found =
          impact(scene, false, 1e-3, speed, duration / 100., .6);
        EXPECT_NEAR(found.restitution, e, .01 * e) << speed;
      }
}



TEST(GrainImpacts, ABarBetweenCentersIsAsStiffAsItsMaterial)
{
  const GrainScene scene("continuum linear",
                         GrainScene::material(),
                         "set Packing factor = 0.8");
  const double     r = 2e-3;
  const Response   response =
    scene.law->response(0, {1e-5, .5 * r, 1e-6, 2. * r - 1e-5});
  // Eq. 112 and 115 of Celigueta et al.
  const double stiffness = .8 * M_PI * r * r * 5e6 / (2. * r);
  EXPECT_NEAR(response.stiffness / stiffness, 1., 1e-12);
  EXPECT_NEAR(response.tangential_stiffness / stiffness, .5 / 1.3, 1e-12);
  // A grain at a wall is one of a pair with its mirror image.
  const Response at_wall = scene.law->response(0, {.5e-5, r, 1e-6, r - .5e-5});
  EXPECT_NEAR(at_wall.elastic / response.elastic, 1., 1e-12);
}
