// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/surface_chain.h>
#include <thalweg/postprocess/surface_samples.h>

#include "own_flow.h"
#include "support/complaint.h"

namespace
{
  const std::string coefficient_ring =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0 : 1 : 2 : 12 : true"})) +
    section("Refinement",
            {"Global levels = 2", "Local levels = if(x > 0, 1, 0)"}) +
    one_fluid(2., 0.5);

  const std::string coefficient_box =
    section("Geometry",
            {},
            section("box", {"Upper corner = 2, 1", "Repetitions = 4, 2"})) +
    section("Refinement",
            {"Global levels = 2", "Local levels = if(x < 0.6, 1, 0)"}) +
    one_fluid(2., 0.5);
} // namespace


TEST(SurfaceChain, StringsOpenLinesAndLoops)
{
  // A loop of three and a line of two, shuffled.
  const auto chains = Thalweg::chain({{{0., 0.}, {1., 0.}},
                                      {{6., 0.}, {7., 0.}},
                                      {{.5, 1.}, {0., 0.}},
                                      {{5., 0.}, {6., 1e-9}},
                                      {{1., 0.}, {.5, 1.}}});
  const std::vector<std::vector<std::size_t>> expected{{3, 1}, {4, 2, 0}};
  EXPECT_EQ(chains, expected);
  EXPECT_TRUE(Thalweg::chain({}).empty());
}


TEST(SurfaceCoefficientsMpi, GoAroundACircle)
{
  State<2>         state(coefficient_ring);
  const OwnFlow<2> flow(
    state.mesh,
    2,
    // A free vortex with v = 1/r around the body.
    [](const auto &p) {
      return dealii::Tensor<1, 2>(
        {-p[1] / p.norm_square(), p[0] / p.norm_square()});
    },
    [](const auto &p) { return 3. * p[0]; },
    2.,
    .5);
  state.flow = &flow.fields;
  state.run("surface coefficients",
            {"Boundaries = 0",
             "Reference velocity = 2",
             "Reference pressure = 1"});
  const auto rows = state.read_all("surface_coefficients.csv");
  // Six coarse faces of half of them refined, two points each.
  ASSERT_EQ(rows.size(), 2u * (24 + 48));
  EXPECT_NEAR(rows.front()[4], 1., 1e-2);
  double length = 0.;
  for (const auto &row : rows)
    {
      const double x = row[4], y = row[5];
      EXPECT_GT(row[3], length);
      length = row[3];
      EXPECT_NEAR(std::hypot(x, y), 1., 1e-4);
      EXPECT_NEAR(row[6], -x, 1e-3);
      EXPECT_NEAR(row[7], -y, 1e-3);
      EXPECT_NEAR(row[8], 3. * x, 1e-3);
      EXPECT_NEAR(row[9], (3. * x - 1.) / 4., 1e-3);
      // The stress mu r d(v/r)/dr = -2 mu acts clockwise, which is positive.
      EXPECT_NEAR(row[10], 1., .02);
      EXPECT_NEAR(row[11], row[10] / 4., 1e-12);
      EXPECT_TRUE(std::isnan(row[12]));
      const double angle = std::atan2(-y, x);
      EXPECT_NEAR(row[3], angle < 0. ? angle + 2. * pi : angle, 1e-2);
    }
}


TEST(SurfaceCoefficientsMpi, FindTheReattachment)
{
  State<2>         state(coefficient_box);
  const OwnFlow<2> flow(
    state.mesh,
    1,
    [](const auto &p) {
      return dealii::Tensor<1, 2>({(p[0] - 1.3) * p[1], -.5 * p[1] * p[1]});
    },
    [](const auto &) { return 0.; });
  state.flow = &flow.fields;
  state.run("surface coefficients", {"Boundaries = top, bottom"}, .5);
  auto row = state.read("surface_coefficients_zero_shear.csv").second;
  ASSERT_EQ(row.size(), 8u);
  EXPECT_NEAR(row[0], .5, 1e-14);
  EXPECT_NEAR(row[1], 1., 0.);
  EXPECT_NEAR(row[4], 1.3, 1e-10);
  EXPECT_NEAR(row[5], 1.3, 1e-10);
  EXPECT_NEAR(row[6], 0., 1e-12);
  EXPECT_NEAR(row[7], 1., 0.);

  // The older methods' flow at vertices.
  state.flow = nullptr;
  state.set(
    state.velocity, [](const auto &p) { return (p[0] - 1.3) * p[1]; }, 2, 0);
  state.run("surface coefficients", {"Boundaries = bottom"});
  row = state.read("surface_coefficients_zero_shear.csv").second;
  EXPECT_NEAR(row.at(5), 1.3, 1e-10);
  EXPECT_NE(complaint_of([&]() { state.run("surface coefficients"); }), "");
}


TEST(SurfaceCoefficientsMpi, TrustTheTractionMoreThanGradients)
{
  State<2>   state(coefficient_box);
  OwnFlow<2> flow(
    state.mesh,
    1,
    [](const auto &p) {
      return dealii::Tensor<1, 2>({7. * p[1], 0.});
    },
    [](const auto &) { return 0.; });
  flow.set_traction([](const auto &p) {
    return dealii::Tensor<1, 2>({p[0] - .7, 5.});
  });
  state.flow = &flow.fields;
  const auto tool =
    state.prepare("surface coefficients", {"Boundaries = bottom"});
  for (const double time : {1., 3.})
    {
      auto solution      = state.view();
      solution.time      = time;
      solution.time_step = time == 1. ? 1. : 2.;
      solution.last_step = time == 3.;
      flow.set_traction([&](const auto &p) {
        return dealii::Tensor<1, 2>({time == 1. ? 2. : p[0] - .7, 5.});
      });
      tool->execute(state.context, whole(solution));
    }
  for (const auto &row : state.read_all("surface_coefficients.csv"))
    {
      EXPECT_NEAR(row.at(10), row.at(4) - .7, 1e-11);
      EXPECT_NEAR(row.at(14), (2. + 2. * (row.at(4) - .7)) / 3., 1e-11);
    }
}


TEST(SurfaceCoefficientsMpi, AverageOverUnequalSteps)
{
  State<2>   state(coefficient_box);
  const auto tool = state.prepare("surface coefficients",
                                  {"Boundaries = bottom", "Average from = 1"});
  const auto step = [&](const double time, const double dt, const bool last) {
    state.set(state.pressure, [&](const auto &) { return time; });
    state.set(
      state.velocity, [&](const auto &p) { return 4. * time * p[1]; }, 2, 0);
    auto solution      = state.view();
    solution.time      = time;
    solution.time_step = dt;
    solution.last_step = last;
    tool->execute(state.context, whole(solution));
  };
  step(.8, .8, false);
  step(1.5, .7, false); // of which 0.5 count
  step(3.5, 2., true);
  const double mean = (.5 * 1.5 + 2. * 3.5) / 2.5;
  const auto   rows = state.read_all("surface_coefficients.csv");
  ASSERT_FALSE(rows.empty());
  for (const auto &row : rows)
    {
      EXPECT_NEAR(row.at(8), 3.5, 1e-12);
      EXPECT_NEAR(row.at(10), .5 * 4. * 3.5, 1e-12);
      EXPECT_NEAR(row.at(12), mean, 1e-12);
      EXPECT_NEAR(row.at(14), .5 * 4. * mean, 1e-12);
    }
}


TEST(SurfaceCoefficientsMpi, ShearIsTangentialIn3D)
{
  State<3> state(
    section("Geometry", {}, section("box", {"Repetitions = 2, 2, 2"})) +
    section("Refinement", {"Local levels = if(x < 0.5, 1, 0)"}) +
    one_fluid(2., 0.5));
  state.set(state.pressure, [](const auto &p) { return p[2]; });
  state.set(
    state.velocity, [](const auto &p) { return 3. * p[1]; }, 3, 0);
  state.set(
    state.velocity, [](const auto &p) { return 4. * p[1]; }, 3, 2);
  state.run("surface coefficients",
            {"Boundaries = bottom", "Reference velocity = 5"});
  const auto rows = state.read_all("surface_coefficients.csv");
  EXPECT_EQ(rows.size(), 8u + 2u);
  for (const auto &row : rows)
    {
      EXPECT_NEAR(row.at(6), -1., 1e-12);
      EXPECT_NEAR(row.at(8), row.at(4), 1e-12);
      EXPECT_NEAR(row.at(10), 1.5, 1e-12);
      EXPECT_NEAR(row.at(11), 0., 1e-12);
      EXPECT_NEAR(row.at(12), 2., 1e-12);
      EXPECT_NEAR(row.at(13), 2.5 / 25., 1e-12);
    }
}
