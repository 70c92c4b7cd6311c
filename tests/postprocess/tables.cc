// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/schedule.h>

#include <cmath>

#include "fixture.h"
#include "support/complaint.h"

namespace
{
  const std::string box_2d =
    section("Geometry",
            {},
            section("box", {"Upper corner = 2, 1", "Repetitions = 4, 2"})) +
    section("Refinement",
            {"Global levels = 2", "Local levels = if(x < 0.6, 1, 0)"});

  const std::string box_3d =
    section("Geometry",
            {},
            section("box",
                    {"Upper corner = 2, 1, 1", "Repetitions = 4, 2, 2"})) +
    section("Refinement", {"Local levels = if(x < 0.6, 1, 0)"});

  const std::string shell =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0 : 1 : 2 : 12 : true"})) +
    section("Refinement", {"Global levels = 3"});

  template <int dim>
  std::string
  complaint(State<dim>                     &state,
            const std::string              &model,
            const std::vector<std::string> &settings)
  {
    return complaint_of([&]() { state.run(model, settings); });
  }
} // namespace


TEST(Schedule, IsDueAtStartAtMultiplesAndAtTheEnd)
{
  Thalweg::Schedule   schedule(0.1);
  std::vector<double> due;
  double              time = 0.;
  for (unsigned int step = 0; step < 100; ++step, time += 0.01)
    if (schedule.is_due(time, step == 99))
      due.push_back(time);
  ASSERT_EQ(due.size(), 11u);
  for (unsigned int i = 0; i < 10; ++i)
    EXPECT_NEAR(due[i], 0.1 * i, 1e-9);
  EXPECT_NEAR(due[10], 0.99, 1e-9);
  EXPECT_TRUE(Thalweg::Schedule(0.).is_due(0.3, false));
}


TEST(CsvFileMpi, FullDiskStopsAllProcesses)
{
  Thalweg::Context context(MPI_COMM_WORLD);
  context.output_directory = "/dev";
  Thalweg::CsvFile file;
  EXPECT_THROW(file.open(context, "full", {"time [s]"}), dealii::ExceptionBase);
  context.output_directory = "/dev/null";
  EXPECT_THROW(file.open(context, "a.csv", {"time [s]"}),
               dealii::ExceptionBase);
}


TEST(FrontPositionMpi, FindsThePlaneAlsoInABand)
{
  State<2> state(box_2d);
  // The front leans forward: x = 1.1 + 0.3 y.
  state.set(state.level_set,
            [](const auto &p) { return p[0] - 1.1 - 0.3 * p[1]; });
  state.run("front position", {}, 0.25);
  auto [header, row] = state.read("front_position.csv");
  EXPECT_EQ(header, "time [s],front x [m]");
  EXPECT_NEAR(row.at(0), 0.25, 1e-14);
  EXPECT_NEAR(row.at(1), 1.4, 1e-12);

  state.run("front position", {"Band = 0, 0.05"});
  EXPECT_NEAR(state.read("front_position.csv").second.at(1), 1.115, 1e-12);

  state.run("front position", {"Direction = -x"});
  EXPECT_NEAR(state.read("front_position.csv").second.at(1), 0., 1e-12);

  state.set(state.level_set, [](const auto &) { return 1.; });
  state.run("front position");
  EXPECT_EQ(state.read("front_position.csv").second.size(), 1u);
}


TEST(FrontPositionMpi, FindsAPlaneIn3D)
{
  State<3> state(box_3d);
  state.set(state.level_set,
            [](const auto &p) { return p[0] - 1.1 - 0.3 * p[1] + 0.2 * p[2]; });
  state.run("front position", {"Band direction = z", "Band = 0.4, 0.7"});
  EXPECT_NEAR(state.read("front_position.csv").second.at(1), 1.32, 1e-12);
}


TEST(ColumnHeightMpi, IsMeasuredAtTheWall)
{
  State<2> state(box_2d);
  state.set(state.level_set,
            [](const auto &p) { return p[1] - 0.7 + 0.1 * p[0]; });
  state.run("column height", {"Floor = 0.1"});
  EXPECT_NEAR(state.read("column_height.csv").second.at(1), 0.6, 1e-12);
  state.run("column height", {"Plane position = 1.03"});
  EXPECT_NEAR(state.read("column_height.csv").second.at(1), 0.597, 1e-12);
  EXPECT_NE(complaint(state, "column height", {"Plane normal = y"}), "");
}


TEST(PhaseVolumeMpi, IsExactForPlanes)
{
  State<2> state(box_2d);
  state.set(state.level_set,
            [](const auto &p) { return p[0] - 1.1 - 0.3 * p[1]; });
  state.run("phase volume");
  auto [header, row] = state.read("phase_volume.csv");
  EXPECT_EQ(header, "time [s],water volume [m^2],air volume [m^2]");
  EXPECT_NEAR(row.at(1), 1.25, 1e-12);
  EXPECT_NEAR(row.at(2), 0.75, 1e-12);

  State<3> state_3d(box_3d);
  state_3d.set(state_3d.level_set, [](const auto &p) {
    return p[0] - 1.1 - 0.3 * p[1] + 0.2 * p[2];
  });
  state_3d.run("phase volume");
  EXPECT_NEAR(state_3d.read("phase_volume.csv").second.at(1), 1.15, 1e-12);
}


TEST(CenterOfMassMpi, FindsCenterAndVelocity)
{
  State<2> state(box_2d);
  state.set(state.level_set, [](const auto &p) { return p[0] - 1.3; });
  state.set(
    state.velocity, [](const auto &p) { return 2. * p[0]; }, 2, 0);
  state.set(
    state.velocity, [](const auto &p) { return 3. - p[1]; }, 2, 1);
  state.run("center of mass");
  const auto row = state.read("center_of_mass.csv").second;
  ASSERT_EQ(row.size(), 9u);
  EXPECT_NEAR(row[1], 0.65, 1e-12);
  EXPECT_NEAR(row[2], 0.5, 1e-12);
  EXPECT_NEAR(row[3], 1.3, 1e-12);
  EXPECT_NEAR(row[4], 2.5, 1e-12);
  EXPECT_NEAR(row[5], 1.65, 1e-12);
  EXPECT_NEAR(row[7], 3.3, 1e-12);
}


TEST(PointProbesMpi, InterpolateAlsoOnFacesAndCurvedMeshes)
{
  State<2> state(box_2d);
  state.set(state.pressure, [](const auto &p) { return p[0] + 10. * p[1]; });
  state.set(
    state.velocity, [](const auto &p) { return p[1]; }, 2, 0);
  state.run("point probes", {"Points = 0.33, 0.21; 1, 0.5; 2, 1"});
  auto [header, row] = state.read("point_probes.csv");
  ASSERT_EQ(row.size(), 13u);
  EXPECT_EQ(header.substr(0, 57),
            "time [s],pressure 0 [Pa],velocity x 0 [m/s],velocity y 0 ");
  EXPECT_NEAR(row[1], 2.43, 1e-12);
  EXPECT_NEAR(row[2], 0.21, 1e-12);
  EXPECT_NEAR(row[4], -1., 1e-12);
  EXPECT_NEAR(row[5], 6., 1e-12);
  EXPECT_NEAR(row[9], 12., 1e-12);

  State<2> curved(shell);
  curved.set(curved.pressure, [](const auto &p) { return p[0] - p[1]; });
  curved.run("point probes", {"Points = 1.2, 0.7; -0.3, 1.6"});
  EXPECT_NEAR(curved.read("point_probes.csv").second.at(1), 0.5, 1e-9);
  EXPECT_NEAR(curved.read("point_probes.csv").second.at(5), -1.9, 1e-9);

  EXPECT_NE(complaint(curved, "point probes", {"Points = 0, 0"})
              .find("(0 0) lies outside the mesh"),
            std::string::npos);
}


TEST(WaterHeightGaugesMpi, MeasureLayers)
{
  State<2> state(box_2d);
  // Water below 0.3 and in a layer of the nodes at 0.625 and 0.75.
  state.set(state.level_set, [](const auto &p) {
    const double layer = std::abs(p[1] - 0.6875) - 0.1;
    return std::min(p[1] - 0.3, layer);
  });
  state.run("water height gauges", {"Positions = 0; 1; 1.37; 2"});
  const auto row = state.read("water_height_gauges.csv").second;
  ASSERT_EQ(row.size(), 9u);
  for (const unsigned int gauge : {0, 1, 2, 3})
    {
      EXPECT_GT(row[1 + 2 * gauge], 0.35);
      EXPECT_LT(row[1 + 2 * gauge], 0.65);
      EXPECT_NEAR(row[2 + 2 * gauge], 0.7875, 0.02);
    }

  state.set(state.level_set, [](const auto &p) { return p[1] - 0.31; });
  state.run("water height gauges", {"Positions = 0; 1; 1.37; 2"});
  for (const unsigned int column : {1, 2, 3, 4, 5, 6, 7, 8})
    EXPECT_NEAR(state.read("water_height_gauges.csv").second.at(column),
                0.31,
                1e-8);
  EXPECT_NE(complaint(state, "water height gauges", {"Positions = 3"})
              .find("does not meet the mesh"),
            std::string::npos);
}


TEST(WaterHeightGaugesMpi, StandIn3D)
{
  State<3> state(box_3d);
  state.set(state.level_set,
            [](const auto &p) { return p[1] - 0.31 - 0.1 * p[0]; });
  state.run("water height gauges", {"Positions = 0, 0; 1, 0.5; 2, 1"});
  const auto row = state.read("water_height_gauges.csv").second;
  EXPECT_NEAR(row.at(1), 0.31, 1e-7);
  EXPECT_NEAR(row.at(3), 0.41, 1e-7);
  EXPECT_NEAR(row.at(5), 0.51, 1e-7);
}


TEST(BoundaryForcesMpi, BalanceTheWeightOfAFluidAtRest)
{
  State<2> state(box_2d);
  state.set(state.pressure, [](const auto &p) { return 100. * (1. - p[1]); });
  state.set(
    state.velocity, [](const auto &p) { return 5. * p[1]; }, 2, 0);
  state.run("boundary forces", {"Boundaries = left, bottom"});
  auto [header, row] = state.read("boundary_forces.csv");
  ASSERT_EQ(row.size(), 9u);
  EXPECT_EQ(header.substr(0, 43),
            "time [s],left pressure force x [N/m],left p");
  EXPECT_NEAR(row[1], -50., 1e-10);
  EXPECT_NEAR(row[6], -200., 1e-10);
  // Shear on the floor: viscosity 1e-3 times 5 1/s over 2 m.
  EXPECT_NEAR(row[7], 1e-2, 1e-14);
  EXPECT_NE(complaint(state, "boundary forces", {"Boundaries = floor"}), "");
}


TEST(BoundaryForcesMpi, VanishUnderConstantPressureOnAClosedSurface)
{
  State<2> state(shell);
  state.set(state.pressure, [](const auto &) { return 7.; });
  state.run("boundary forces");
  const auto row = state.read("boundary_forces.csv").second;
  ASSERT_EQ(row.size(), 9u);
  for (const double force : row)
    EXPECT_NEAR(force, 0., 1e-10);
}
