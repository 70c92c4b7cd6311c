// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/surface.h>

#include "own_flow.h"
#include "support/complaint.h"
#include "support/meshes.h"

namespace
{
  /// A ring around a body of radius 1; boundary 0 is the body.
  const std::string unit_ring =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0 : 1 : 2 : 12 : true"})) +
    section("Refinement",
            {"Global levels = 2", "Local levels = if(x > 0, 1, 0)"}) +
    one_fluid(2., 0.5);

  const std::string ball =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0, 0 : 1 : 2 : 6 : true"})) +
    section("Refinement",
            {"Global levels = 1", "Local levels = if(x > 0, 1, 0)"}) +
    one_fluid(2., 0.5);

  /// The value in the column @p name of the last row.
  double
  value(const std::pair<std::string, std::vector<double>> &table,
        const std::string                                 &name)
  {
    std::istringstream header(table.first);
    unsigned int       column = 0;
    for (std::string cell; std::getline(header, cell, ','); ++column)
      if (cell == name)
        return column < table.second.size() ? table.second[column]
                                            : std::nan("");
    ADD_FAILURE() << "no column '" << name << "' in " << table.first;
    return std::nan("");
  }
} // namespace


TEST(BodyForcesMpi, PressureOnACircleIsItsArea)
{
  State<2>         state(unit_ring);
  const OwnFlow<2> flow(
    state.mesh,
    2,
    [](const auto &) { return dealii::Tensor<1, 2>(); },
    [](const auto &p) { return p[0]; },
    2.,
    .5);
  const auto loads = Thalweg::integrate_stresses<2>(flow.fields, {0}, {0., 3.});
  // The fluid is outside, so the force is minus the gradient times the area.
  EXPECT_NEAR(loads.pressure.force[0], -pi, 1e-3);
  EXPECT_NEAR(loads.pressure.force[1], 0., 1e-10);
  EXPECT_NEAR(loads.pressure.moment[0], -3. * pi, 3e-3);
  EXPECT_NEAR(loads.viscous.force.norm(), 0., 1e-12);
}


TEST(BodyForcesMpi, ResidualEqualsDirectIntegrationOnHangingNodes)
{
  State<2>   state(unit_ring);
  OwnFlow<2> flow(
    state.mesh,
    2,
    [](const auto &p) {
      return dealii::Tensor<1, 2>({3. * p[1], p[0]});
    },
    [](const auto &p) { return p[0] - 2. * p[1] + 4.; },
    2.,
    .5);
  flow.set_reaction(dealii::Point<2>(1., -2.));
  const dealii::Point<2> center(.4, -.2);
  const auto loads  = Thalweg::integrate_stresses<2>(flow.fields, {0}, center);
  const auto direct = loads.pressure.force + loads.viscous.force;
  const auto moment = loads.pressure.moment[0] + loads.viscous.moment[0];
  const auto residual = Thalweg::sum_reactions<2>(flow.fields, {0}, center);
  EXPECT_NEAR(residual.force[0], direct[0], 1e-7);
  EXPECT_NEAR(residual.force[1], direct[1], 1e-7);
  EXPECT_NEAR(residual.moment[0], moment, 1e-7);
  EXPECT_NEAR(direct[0], -pi, 1e-3);
  EXPECT_NEAR(direct[1], 2. * pi, 1e-3);
}


TEST(BodyForcesMpi, ResidualEqualsDirectIntegrationIn3D)
{
  State<3>   state(ball);
  OwnFlow<3> flow(
    state.mesh,
    2,
    [](const auto &p) {
      return dealii::Tensor<1, 3>({3. * p[1], p[2], 0.});
    },
    [](const auto &p) { return p[2]; },
    2.,
    .5);
  flow.set_reaction(dealii::Point<3>(0., 0., 1.));
  const dealii::Point<3> center(1., 0., 0.);
  const auto loads = Thalweg::integrate_stresses<3>(flow.fields, {0}, center);
  const auto residual = Thalweg::sum_reactions<3>(flow.fields, {0}, center);
  const auto force    = loads.pressure.force + loads.viscous.force;
  const auto moment   = loads.pressure.moment + loads.viscous.moment;
  EXPECT_NEAR(force[2], -4. / 3. * pi, 2e-2);
  EXPECT_NEAR(moment[1], -4. / 3. * pi, 2e-2);
  for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(residual.force[d], force[d], 2e-3);
      EXPECT_NEAR(residual.moment[d], moment[d], 2e-3);
    }
}


TEST(BodyForcesMpi, CoefficientsUnderAnAngle)
{
  State<2>   state(unit_ring);
  OwnFlow<2> flow(
    state.mesh,
    1,
    [](const auto &) { return dealii::Tensor<1, 2>(); },
    [](const auto &p) { return -p[0]; },
    2.,
    .5);
  flow.set_reaction(dealii::Point<2>(-1., 0.));
  state.flow = &flow.fields;
  state.run("body forces",
            {"Boundaries = 0",
             "Reference velocity = 3",
             "Reference length = 2",
             "Moment centre = 0, -1",
             "Drag direction = 4, 3",
             "Lift direction = -3, 4"});
  const auto table = state.read("body_forces.csv");
  EXPECT_NEAR(value(table, "direct pressure drag [N/m]"), .8 * pi, 2e-2);
  EXPECT_NEAR(value(table, "direct lift [N/m]"), -.6 * pi, 2e-2);
  EXPECT_NEAR(value(table, "residual drag [N/m]"), .8 * pi, 2e-2);
  EXPECT_NEAR(value(table, "residual c_D"), .8 * pi / 18., 2e-3);
  EXPECT_NEAR(value(table, "direct c_L"), -.6 * pi / 18., 2e-3);
  EXPECT_NEAR(value(table, "direct c_M"), -pi / 36., 2e-3);
}


TEST(BodyForcesMpi, OlderMethodsIntegrateStressesOnly)
{
  State<2> state(unit_ring);
  state.set(state.pressure, [](const auto &p) { return p[0]; });
  state.run("body forces", {"Boundaries = 0, 1"});
  const auto table = state.read("body_forces.csv");
  // The pressure on the whole boundary: the area of the polygons between.
  double area = 0.;
  for (unsigned int c = 0; c < state.mesh.graph().n_owned_cells(); ++c)
    area += state.mesh.graph().cell(c).measure;
  EXPECT_NEAR(value(table, "direct drag [N/m]"), sum_of_all(area), 1e-10);
  EXPECT_EQ(table.first.find("residual"), std::string::npos);

  EXPECT_NE(complaint_of([&]() { state.run("body forces"); }), "");
  EXPECT_NE(
    complaint_of([&]() {
      state.run("body forces", {"Boundaries = 0", "Lift direction = 1, 1"});
    }).find("normal to each other"),
    std::string::npos);
}


TEST(BodyForcesMpi, SummaryFindsTheStrouhalNumber)
{
  State<2>   state(unit_ring);
  const auto run = [&](const double end) {
    const auto         tool = state.prepare("body forces",
                                    {"Boundaries = 0",
                                             "Reference velocity = 2",
                                             "Reference length = 0.5",
                                             "Average from = 1",
                                             "Interval = 1"});
    const unsigned int n    = std::lround(end / .02);
    for (unsigned int step = 0; step <= n; ++step)
      {
        const double time = .02 * step;
        state.set(state.pressure, [&](const auto &p) {
          return 5. * p[0] - p[1] * std::sin(2. * pi * 1.2 * time);
        });
        auto solution      = state.view();
        solution.time      = time;
        solution.step      = step;
        solution.last_step = step == n;
        tool->execute(state.context, whole(solution));
      }
    return state.read("body_forces_summary.csv");
  };
  auto table = run(6.);
  EXPECT_NEAR(value(table, "Strouhal number by zero crossings"), .3, 1e-4);
  EXPECT_NEAR(value(table, "Strouhal number by spectrum"), .3, 1e-3);
  EXPECT_NEAR(value(table, "records"), 251., 0.);
  EXPECT_NEAR(value(table, "periods"), 5., 0.);
  EXPECT_NEAR(value(table, "direct c_D rms"), 0., 1e-10);
  EXPECT_NEAR(value(table, "direct c_L mean"), 0., 1e-10);
  EXPECT_NEAR(value(table, "direct c_L rms"),
              value(table, "direct c_L maximum") / std::sqrt(2.),
              1e-3);

  table = run(2.2);
  EXPECT_TRUE(std::isnan(value(table, "Strouhal number by zero crossings")));
  EXPECT_FALSE(std::isnan(value(table, "direct c_D mean")));
}


TEST(BodyForcesMpi, SteadyFlowsHaveNoStrouhalNumber)
{
  State<2>           state(unit_ring);
  const auto         tool = state.prepare("body forces", {"Boundaries = 0"});
  const unsigned int n    = 200;
  for (unsigned int step = 0; step <= n; ++step)
    {
      state.set(state.pressure, [&](const auto &p) {
        return 5. * p[0] + 1e-8 * p[1] * std::sin(.3 * step);
      });
      auto solution      = state.view();
      solution.time      = .02 * step;
      solution.step      = step;
      solution.last_step = step == n;
      tool->execute(state.context, whole(solution));
    }
  const auto table = state.read("body_forces_summary.csv");
  EXPECT_TRUE(std::isnan(value(table, "Strouhal number by spectrum")));
  EXPECT_NEAR(value(table, "periods"), 0., 0.);
}


TEST(BodyForcesMpi, ResidualColumnsAreThereBeforeThereIsAReaction)
{
  State<2>              state(unit_ring);
  const Thalweg::Vector none;
  const OwnFlow<2>      flow(
    state.mesh,
    1,
    [](const auto &) { return dealii::Tensor<1, 2>(); },
    [](const auto &) { return 1.; });
  const auto                  &f = flow.fields;
  const Thalweg::FlowFields<2> fields{f.mapping,
                                      f.velocity_dofs,
                                      f.pressure_dofs,
                                      f.velocity,
                                      f.pressure,
                                      &none,
                                      nullptr,
                                      1.,
                                      1.,
                                      0.};
  state.flow = &fields;
  state.run("body forces", {"Boundaries = 0"});
  EXPECT_TRUE(std::isnan(value(state.read("body_forces.csv"), "residual c_D")));
}
