// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/flow_quantities.h>
#include <thalweg/postprocess/flow_means.h>

#include "own_flow.h"
#include "support/complaint.h"

namespace
{
  const std::string own_ring =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0 : 1 : 2 : 12 : true"})) +
    section("Refinement",
            {"Global levels = 2", "Local levels = if(x > 0, 1, 0)"}) +
    one_fluid(2., 0.5);

  const std::string own_box = hanging_box<2>(4) + one_fluid(2., .5);

  /// Quadratic, to tell the flow's space from its values at vertices.
  dealii::Tensor<1, 2>
  velocity(const dealii::Point<2> &p)
  {
    return dealii::Tensor<1, 2>({p[1] * p[1], 1. + p[0] * p[0]});
  }
} // namespace


TEST(OwnSpacesMpi, ProbesAreExactAlsoOnACurvedWall)
{
  State<2>         state(own_ring);
  const OwnFlow<2> flow(state.mesh, 2, velocity, [](const auto &p) {
    return p[0];
  });
  state.flow = &flow.fields;
  // The second and third are on the body, the last is between two vertices.
  const double x = std::cos(.1), y = std::sin(.1);
  state.run("point probes",
            {"Points = 1.3, 0.4; -1, 0; " + std::to_string(x) + ", " +
             std::to_string(y)});
  const auto row = state.read("point_probes.csv").second;
  ASSERT_EQ(row.size(), 13u);
  EXPECT_NEAR(row[1], 1.3, 1e-8);
  EXPECT_NEAR(row[2], .16, 1e-4);
  EXPECT_NEAR(row[3], 2.69, 1e-4);
  EXPECT_NEAR(row[5], -1., 1e-8);
  EXPECT_NEAR(row[9], x, 1e-4);
  EXPECT_NEAR(row[10], y * y, 1e-3);
  EXPECT_NE(complaint_of([&]() {
              state.run("point probes", {"Points = 0.5, 0"});
            }).find("lies outside the mesh"),
            std::string::npos);
}


TEST(OwnSpacesMpi, LineProfileHasExactValues)
{
  State<2>         state(own_box);
  const OwnFlow<2> flow(state.mesh, 1, velocity, [](const auto &p) {
    return 3. * p[1];
  });
  state.flow = &flow.fields;
  state.run("line profile",
            {"Ends = 0.5, 0; 0.5, 1; 0, 0.3; 1, 0.3", "Number of points = 14"});
  for (const std::string file :
       {"line_profile.csv", "line_profile/line_profile_0000.csv"})
    {
      const auto rows = state.read_all(file);
      ASSERT_EQ(rows.size(), 28u);
      for (const auto &row : rows)
        {
          EXPECT_NEAR(row[1] == 0. ? row[3] : row[4],
                      row[1] == 0. ? .5 : .3,
                      1e-11);
          EXPECT_NEAR(row[2], row[1] == 0. ? row[4] : row[3], 1e-11);
          EXPECT_NEAR(row[5], row[4] * row[4], 1e-10);
          EXPECT_NEAR(row[6], 1. + row[3] * row[3], 1e-10);
          EXPECT_NEAR(row[7], 3. * row[4], 1e-10);
        }
    }
  state.run("line profile", {"Ends = 0, 0; 1, 1", "Fractions = 0.25, 1"});
  EXPECT_NEAR(state.read_all("line_profile.csv").at(0).at(3), .25, 1e-12);
  EXPECT_NE(complaint_of(
              [&]() { state.run("line profile", {"Ends = 0.5, 0.5"}); }),
            "");
}


TEST(OwnSpacesMpi, ErrorsAreZeroForWhatTheSpaceHolds)
{
  State<2>         state(own_box);
  const OwnFlow<2> flow(state.mesh, 1, velocity, [](const auto &p) {
    return p[0] + 7.;
  });
  state.flow = &flow.fields;
  state.run("velocity error", {"Velocity = y^2; 1 + x^2", "Pressure = x - 3"});
  auto row = state.read("velocity_error.csv").second;
  ASSERT_EQ(row.size(), 10u);
  EXPECT_NEAR(row[2], 0., 1e-12);
  EXPECT_NEAR(row[4], 0., 1e-12);
  EXPECT_NEAR(row[5], 1., 1e-12);
  // Means do not count.
  EXPECT_NEAR(row[7], 0., 1e-12);

  state.run("velocity error",
            {"Velocity = y^2 - 0.3; 1 + x^2", "Pressure = -x"});
  row = state.read("velocity_error.csv").second;
  EXPECT_NEAR(row[2], .3, 1e-12);
  EXPECT_NEAR(row[7], 2. / std::sqrt(12.), 1e-12);
  EXPECT_NEAR(row[8], 2., 1e-12);

  // At vertices alone the flow is bilinear.
  state.flow = nullptr;
  state.set(
    state.velocity, [](const auto &p) { return p[1] * p[1]; }, 2, 0);
  state.run("velocity error", {"Velocity = y^2; 0"});
  row = state.read("velocity_error.csv").second;
  ASSERT_EQ(row.size(), 6u);
  EXPECT_GT(row[2], 1e-4);
}


TEST(OwnSpacesMpi, EnergyAndMomentumAreIntegratedExactly)
{
  State<2>         state(own_box);
  const OwnFlow<2> flow(
    state.mesh, 1, velocity, [](const auto &) { return 0.; }, 2., .5);
  const auto quantities = [&]() {
    std::map<std::string, double> values;
    for (const auto &[name, value] : Thalweg::flow_quantities<2>(
           state.view(), *state.phase, dealii::Point<2>(0., -10.)))
      values[name] = value;
    return values;
  };
  state.flow  = &flow.fields;
  auto values = quantities();
  EXPECT_NEAR(values.at("momentum x [kg m/s]"), 2. / 3., 1e-12);
  EXPECT_NEAR(values.at("momentum y [kg m/s]"), 8. / 3., 1e-12);
  // 1/2 rho of the integrals of y^4 and (1 + x^2)^2.
  EXPECT_NEAR(values.at("kinetic energy [J]"),
              1. / 5. + (1. + 2. / 3. + 1. / 5.),
              1e-12);
  EXPECT_NEAR(values.at("potential energy [J]"), 10., 1e-12);
  EXPECT_NEAR(values.at("max velocity 1 [m/s]"), std::sqrt(5.), 1e-12);

  state.flow = nullptr;
  state.set_phases([](const auto &) { return -1.; });
  state.set(
    state.velocity, [](const auto &p) { return 3. * p[0]; }, 2, 0);
  values = quantities();
  EXPECT_NEAR(values.at("momentum x [kg m/s]"), 3., 1e-12);
  EXPECT_NEAR(values.at("momentum y [kg m/s]"), 0., 1e-12);
}


TEST(OwnSpacesMpi, MeansAndReynoldsStresses)
{
  State<2>   state(own_box);
  OwnFlow<2> flow(state.mesh, 1, velocity, [](const auto &p) { return p[0]; });
  Thalweg::FlowMeans<2> means(/* with_stresses */ true);
  means.initialize(state.mesh, flow.fields);
  // Amplitudes -1, 2 and 3 for 1, 2 and 1 s: mean 1.5, square 4.5.
  for (const auto &[duration, amplitude] :
       std::vector<std::pair<double, double>>{{1., -1.}, {2., 2.}, {1., 3.}})
    {
      flow.set_velocity([a = amplitude](const auto &) {
        return dealii::Tensor<1, 2>({a, 10. - 2. * a});
      });
      means.add(flow.fields, duration);
    }
  EXPECT_NEAR(means.averaged_time(), 4., 1e-14);
  // Half of the degrees of freedom are x components.
  const double n = means.velocity().size() / 2;
  EXPECT_NEAR(means.velocity().mean_value(), (1.5 + 7.) / 2., 1e-12);
  const auto x = means.stress(0), y = means.stress(1);
  EXPECT_NEAR(x.mean_value(), (2.25 - 4.5) / 2., 1e-12);
  EXPECT_NEAR(y.mean_value(), (-4.5 + 9.) / 2., 1e-12);
  EXPECT_NEAR(x.norm_sqr(), n * (2.25 * 2.25 + 4.5 * 4.5), 1e-8);
  EXPECT_NEAR(means.pressure().l2_norm(),
              flow.fields.pressure.l2_norm(),
              1e-10);
}


TEST(OwnSpacesMpi, TimeAveragesWriteOnceThereIsOne)
{
  State<2>         state(own_box);
  const OwnFlow<2> flow(state.mesh, 1, velocity, [](const auto &p) {
    return p[0];
  });
  state.flow      = &flow.fields;
  const auto tool = state.prepare("time averages", {"Average from = 1"});
  const auto step = [&](const double time, const bool last) {
    auto solution      = state.view();
    solution.time      = time;
    solution.time_step = .5;
    solution.last_step = last;
    tool->execute(state.context, whole(solution));
    MPI_Barrier(MPI_COMM_WORLD);
    return content(state.context.output_directory + "/time_averages.pvd");
  };
  EXPECT_EQ(step(1., false), "");
  EXPECT_NE(step(1.5, true).find("timestep=\"1.5\""), std::string::npos);
}


TEST(OwnSpacesMpi, FieldsAreDividedByTheDegree)
{
  State<2>         state(own_ring);
  const OwnFlow<2> flow(state.mesh, 1, velocity, [](const auto &p) {
    return p[0];
  });
  const auto       size = [&]() {
    MPI_Barrier(MPI_COMM_WORLD);
    const std::string text =
      content(state.context.output_directory + "/fields/fields_0000.0.vtu") +
      content(state.context.output_directory + "/fields/fields_0000.vtu");
    const std::size_t place = text.find("NumberOfCells=\"");
    MPI_Barrier(MPI_COMM_WORLD);
    return place == std::string::npos ? 0 : std::stoi(text.substr(place + 15));
  };
  state.run("fields");
  const int cells = size();
  state.flow      = &flow.fields;
  state.run("fields");
  EXPECT_GT(cells, 0);
  EXPECT_EQ(size(), 4 * cells);
}
