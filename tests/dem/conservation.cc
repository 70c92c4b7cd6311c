// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/grain_insertion.h>

#include <cmath>
#include <gtest/gtest.h>

#include "dem/grain_scene.h"

using namespace Thalweg;

namespace
{
  /// What a cloud of grains has in all.
  struct Sums
  {
    Vec3   momentum{0., 0., 0.}, angular_momentum{0., 0., 0.};
    double size    = 0.; ///< the sum of the moduli of momenta
    double spin    = 0.; ///< and of angular momenta
    double kinetic = 0.;
  };

  Sums
  sums_of(const GrainScene &scene)
  {
    Sums sums;
    for (const GrainRecord &grain : scene.system->all().grains)
      {
        const double m = scene.system->mass(0, grain.r);
        const double i = scene.system->inertia_factor() * m * grain.r * grain.r;
        const Vec3   moment = m * cross(grain.x, grain.v) + i * grain.w;
        sums.momentum += m * grain.v;
        sums.angular_momentum += moment;
        sums.size += m * norm(grain.v);
        sums.spin += norm(moment);
        sums.kinetic +=
          .5 * m * norm_square(grain.v) + .5 * i * norm_square(grain.w);
      }
    return sums;
  }

  /// A cloud of n^3 grains of sizes 1 to 2 that collapses.
  void
  fill(GrainScene &scene, const unsigned int n)
  {
    RandomNumbers random(7);
    for (unsigned int k = 0; k < n * n * n; ++k)
      {
        const Vec3 x{2.2e-3 * (k % n - .5 * (n - 1)),
                     2.2e-3 * (k / n % n - .5 * (n - 1)),
                     2.2e-3 * (k / n / n - .5 * (n - 1))};
        const auto off = [&]() { return random.next() - .5; };
        scene.add_grain(x,
                        5e-4 * (1. + random.next()),
                        -20. * x + Vec3{.1 * off(), .1 * off(), .1 * off()},
                        {30. * off(), 30. * off(), 30. * off()});
      }
    scene.begin();
  }
} // namespace



TEST(GrainConservation, AFreeCloudKeepsItsMomenta)
{
  for (const char *law : {"linear", "hertz mindlin"})
    {
      GrainScene scene(law,
                       GrainScene::material(.8, .5, .1),
                       law == std::string("linear")
                         ? "set Normal stiffness = 1000"
                         : "",
                       RollingModel::epsd);
      fill(scene, 8);
      const Sums before = sums_of(scene);
      scene.advance(3000, 5e-6);
      const Sums after = sums_of(scene);
      EXPECT_LT(after.kinetic, .8 * before.kinetic) << law;
      EXPECT_LT(norm(after.momentum - before.momentum), 1e-12 * before.size);
      EXPECT_LT(norm(after.angular_momentum - before.angular_momentum),
                1e-10 * before.spin);
    }
}



TEST(GrainConservation, TheEnergyBudgetClosesWithSecondOrder)
{
  const auto missing = [](const double dt) {
    GrainScene scene("linear",
                     GrainScene::material(.7, .4),
                     "set Normal stiffness = 1000");
    fill(scene, 6);
    const double before = sums_of(scene).kinetic;
    scene.advance(static_cast<unsigned int>(.01 / dt + .5), dt);
    double      energy   = sums_of(scene).kinetic;
    const auto &grains   = scene.system->grains();
    const auto &contacts = scene.system->contacts();
    for (std::size_t i = 0; i < grains.size(); ++i)
      for (auto k = contacts.begin[i]; k < contacts.begin[i + 1]; ++k)
        if (contacts.touching[k])
          {
            const auto j = contacts.partner[k];
            energy += scene.law
                        ->energy(0,
                                 pair_geometry(grains.place[i],
                                               grains.place[j],
                                               grains.motion[i],
                                               grains.motion[j])
                                   .touch,
                                 {contacts.slip[k], {0., 0., 0.}})
                        .normal;
          }
    const ContactWork &work = scene.system->counts.work;
    // The last forces have acted for half of a step.
    const ContactWork &last = scene.system->counts.last_work;
    return std::abs(energy + work.normal + work.tangential -
                    .5 * (last.normal + last.tangential) - before) /
           before;
  };
  // 1/25 of the shortest contact, that of two of the smallest grains.
  const double m      = 2500. * 4. / 3. * M_PI * 1.25e-10 / 2.;
  const double dt     = M_PI * std::sqrt(m / 1000.) / 25.;
  const double coarse = missing(dt), fine = missing(.25 * dt);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(coarse / fine, 12.);
}



TEST(GrainConservation, SizesOfOneToTenFindAllTheirContacts)
{
  GrainScene    scene("linear",
                   GrainScene::material(.5, .3),
                   "set Normal stiffness = 1000");
  RandomNumbers random(3);
  for (unsigned int k = 0; k < 1500; ++k)
    {
      const double r = 2e-4 * std::pow(10., random.next());
      scene.add_grain({.02 * random.next(),
                       .02 * random.next(),
                       .02 * random.next()},
                      r,
                      {0., 0., 0.});
    }
  scene.begin();
  scene.advance(1, 1e-12);
  std::size_t n = 0, expected = 0;
  for (const auto touching : scene.system->contacts().touching)
    n += touching;
  for (std::size_t i = 0; i < scene.grains.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      expected += norm(scene.grains[i].x - scene.grains[j].x) <
                  scene.grains[i].r + scene.grains[j].r;
  EXPECT_GT(expected, 1000u);
  EXPECT_EQ(n, expected);
}
