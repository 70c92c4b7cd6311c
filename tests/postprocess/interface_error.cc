// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "fixture.h"

namespace
{
  const std::string box = unit_box<2>(8, "if(x < 0.6, 1, 0)");
} // namespace


TEST(InterfaceErrorMpi, VanishesForAnExactPlane)
{
  State<2> state(box);
  state.set(state.level_set,
            [](const auto &p) { return 0.6 * p[0] + 0.8 * p[1] - 0.7; });
  state.run("interface error", {"Level set = 0.6*x + 0.8*y - 0.7"});
  const auto values = state.read("interface_error.csv").second;
  EXPECT_NEAR(values[1], 0., 1e-12);
  EXPECT_NEAR(values[3], 0., 1e-12);
}


TEST(InterfaceErrorMpi, MeasuresWhatLiesBetweenTwoPlanes)
{
  State<2> state(box);
  state.set(state.level_set, [](const auto &p) { return p[1] - 0.4; });
  state.run("interface error", {"Level set = y - 0.3 - 0.1*t"}, 0.5);
  const auto values = state.read("interface_error.csv").second;
  EXPECT_NEAR(values[0], 0.5, 1e-12);
  EXPECT_NEAR(values[1], 0.05, 1e-12);
  EXPECT_NEAR(values[2], 0.05 / 0.35, 1e-12);
  EXPECT_NEAR(values[3], 0.4 / 0.35 - 1., 1e-12);
}


TEST(InterfaceErrorMpi, SamplesAnExactSphereFinely)
{
  State<3> state(unit_box<3>(4));
  state.set(state.level_set, [](const auto &) { return 1.; });
  state.run("interface error",
            {"Level set = sqrt((x-0.5)^2 + (y-0.5)^2 + (z-0.5)^2) - 0.3"});
  const auto values = state.read("interface_error.csv").second;
  // On edges of length s a linear interpolation of the distance to a sphere is
  // too large, by up to s^2 / (8 R) in each of two directions: the sampled
  // sphere is too small, by at most its area times that.
  const double R = 0.3, s = 0.25 / 10;
  const double deficit = 4. / 3. * M_PI * R * R * R - values[1];
  EXPECT_GT(deficit, 0.);
  EXPECT_LT(deficit, 4. * M_PI * R * R * 2. * s * s / (8. * R));
  EXPECT_NEAR(values[3], -1., 1e-12);
}
