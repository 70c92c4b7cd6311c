// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/tracer_view.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/input.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// A flow of a given velocity, and tracers with these settings.
  std::string
  in_flow(const std::string              &velocity,
          const std::vector<std::string> &settings,
          const std::string              &open      = "",
          const std::vector<std::string> &particles = {})
  {
    return section("Methods",
                   {"Names = water: advection, dye: tracers"},
                   section("water",
                           {"Velocity = " + velocity},
                           one_fluid(1., 1.) + section("Particles", particles) +
                             section("Boundary conditions",
                                     {"Open = " + open})) +
                     section("dye", settings));
  }

  /// Calls @p action with the place of each tracer and what it knows.
  template <int dim, typename Action>
  void
  for_each_tracer(const RunCase<dim> &run, const Action &action)
  {
    const auto  view = run.simulation->view();
    const auto &cloud =
      view.ports
        ->template get<const TracerView<dim>>("dye", "tracers", "A test")
        .cloud;
    const CellMaps<dim> maps(cloud.mesh().graph());
    for (const auto &[walker, tracer] : cloud.members())
      action(maps.to_space(walker.cell, walker.reference), tracer);
  }

  /// Velocities of this parabola between nodes with a distance of an eighth.
  double
  piecewise_linear(const double y)
  {
    const auto   parabola = [](const double s) { return 4. * s * (1. - s); };
    const double below    = std::floor(8. * y) / 8.;
    const double part     = 8. * (y - below);
    return (1. - part) * parabola(below) + part * parabola(below + .125);
  }
} // namespace



TEST(TracersMpi, TimesInAChannelAreExactAtAnyStep)
{
  // Released at 16 heights at x = 1/32, 3/32, ..., 15/32.
  double       sum = 0.;
  unsigned int n   = 0;
  for (double y = 1. / 32.; y < 1.; y += 1. / 16.)
    for (double x = 1. / 32.; x < .5; x += 1. / 16., ++n)
      sum += (1. - x) / piecewise_linear(y);
  for (const std::string dt : {"0.05", "0.7"})
    {
      const RunCase<2> run(unit_box<2>(8) +
                           in_flow("4*y*(1-y); 0",
                                   {"Region = 0.5 - x", "Spacing = 0.0625"},
                                   "left: 0 | right: 0") +
                           steps_of(dt, "14"));
      EXPECT_EQ(run.last("dye: tracers released"), n) << dt;
      EXPECT_EQ(run.last("dye: tracers left"), n) << dt;
      EXPECT_NEAR(run.last("dye: mean residence time [s]"), sum / n, 1e-10)
        << dt;
    }
}



TEST(TracersMpi, TheyComeBackInAVortexThatTurnsBack)
{
  const RunCase<2> run(
    unit_box<2>(32, "if(x < 0.4, 1, 0)") +
    in_flow("2*sin(pi*x)^2*sin(pi*y)*cos(pi*y)*cos(pi*t/2);"
            "-2*sin(pi*y)^2*sin(pi*x)*cos(pi*x)*cos(pi*t/2)",
            {"Spacing = 0.02"},
            "",
            {"Integrator = rk4", "Substep Courant number = 0.01"}) +
    steps_of("0.1", "2"));
  EXPECT_GT(run.last("water: Courant number"), 1.);
  double farthest = 0.;
  for_each_tracer<2>(run, [&](const auto &place, const auto &tracer) {
    farthest = std::max(farthest,
                        std::hypot(place[0] - tracer.origin[0],
                                   place[1] - tracer.origin[1]));
  });
  EXPECT_LT(dealii::Utilities::MPI::max(farthest, MPI_COMM_WORLD), 1e-6);
  EXPECT_EQ(run.last("dye: tracers"), 2500.);
}



TEST(TracersMpi, ReleasesAreInTheMidstOfStepsAndMeshesMayChange)
{
  // Rows at x = 1/16 at 0.1, 0.35, 0.6 s, with a speed of one.
  const RunCase<2> run(
    unit_box<2>(4) +
    section("Refinement",
            {},
            section("Adaptive",
                    {"Criteria = region", "Maximum level = 2"},
                    section("region",
                            {"At least = if(x < t, 2, 0)",
                             "At most = if(x < t, 2, 0)"}))) +
    in_flow("1; 0",
            {"Region = 0.1 - x",
             "Spacing = 0.125",
             "First release = 0.1",
             "Interval = 0.25",
             "Last release = 0.7"},
            "left: 0 | right: 0") +
    steps_of("0.08", "0.8"));
  EXPECT_EQ(run.last("dye: tracers released"), 24.);
  EXPECT_EQ(run.last("dye: tracers"), 24.);
  EXPECT_NEAR(run.last("dye: mean age [s]"), .8 - .35, 1e-12);
  EXPECT_GT(run.last("adaptations"), 2.);
  for_each_tracer<2>(run, [&](const auto &place, const auto &tracer) {
    EXPECT_NEAR(place[0] - tracer.origin[0], .8 - tracer.released, 1e-12);
    EXPECT_NEAR(place[1], tracer.origin[1], 1e-12);
  });
}



TEST(TracersMpi, TheyFollowAFlowThatIsComputed)
{
  for (const std::string model : {"pfem2", "single fluid pfem2"})
    {
      const RunCase<3> run(
        unit_box<3>(3) +
        section("Methods",
                {"Names = water: " + model + ", dye: tracers"},
                section("water",
                        {},
                        one_fluid(1., .01) +
                          section("Initial conditions",
                                  {"Velocity = 0.5; 0; 0"}) +
                          section("Boundary conditions",
                                  {"Velocity = left: 0.5; 0; 0",
                                   "Open = right: 0"})) +
                  section("dye", {"Region = 0.3 - x", "Spacing = 0.1"})) +
        steps_of("0.1", "0.5"));
      EXPECT_EQ(run.last("dye: tracers"), 300.) << model;
      for_each_tracer<3>(run, [&](const auto &place, const auto &tracer) {
        EXPECT_NEAR(place[0], tracer.origin[0] + .25, 1e-6) << model;
      });
    }
}



TEST(Tracers, WhatCannotBeIsRefused)
{
  const auto complaint = [](const std::string &methods) {
    return complaint_of(
      [&]() { RunCase<2>(unit_box<2>(2) + methods + steps_of("0.1", "0.1")); });
  };
  EXPECT_EQ(complaint(in_flow("1; 0", {})), "");
  EXPECT_NE(complaint(in_flow("1; 0", {"Flow = sea"})).find("'sea'"),
            std::string::npos);
  EXPECT_NE(complaint(in_flow("1; 0", {"Spacing = 1e-9"})).find("greater"),
            std::string::npos);
  EXPECT_NE(
    complaint(section("Method", {"Model = tracers"})).find("'streamlines'"),
    std::string::npos);
  const std::string before =
    complaint(section("Methods", {"Names = dye: tracers, water: pfem2"}));
  EXPECT_NE(before.find("behind a flow"), std::string::npos) << before;
}
