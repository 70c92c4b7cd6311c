// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/scalar_view.h>

#include <cmath>
#include <gtest/gtest.h>

#include "support/carried_scalar.h"
#include "support/complaint.h"
#include "support/input.h"
#include "support/resumed_case.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  template <int dim>
  const ScalarView<dim> &
  view_of(const RunCase<dim> &run)
  {
    return *run.simulation->view()
              .ports->template all<const ScalarView<dim>>("scalars")
              .at("heat");
  }

  /// The mean square difference of the field from a function at the nodes.
  template <int dim, typename Function>
  double
  error(const RunCase<dim> &run, const Function &exact)
  {
    const auto &view = view_of(run);
    double      sum = 0., n = 0.;
    for (unsigned int i = 0; i < view.space.n_owned_nodes(); ++i)
      if (!view.space.is_dependent(i))
        {
          sum += std::pow(view.field.local_element(i) -
                            exact(view.space.position(i)),
                          2);
          n += 1.;
        }
    return std::sqrt(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
                     dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD));
  }

  const std::string rotation = "0.5-y; x-0.5";

  /// Turns within the box.
  const std::string eddy = "sin(pi*x)*cos(pi*y); -cos(pi*x)*sin(pi*y)";
} // namespace



TEST(ScalarMpi, ADiffusingGaussianIsOfSecondOrder)
{
  // exp(-r^2 / w) / w with w = 0.008 + 4 D t, carried around.
  const double D     = 5e-4;
  const auto   order = [&](const double courant) {
    double errors[2];
    for (const unsigned int i : {0, 1})
      {
        const unsigned int n  = i == 0 ? 40 : 80;
        const double       dt = courant / (.5 * n);
        const RunCase<2>   run(
          unit_box<2>(n) +
          carried_by(rotation,
                     {"Initial value = exp(-((x-0.6)^2+(y-0.5)^2)/0.008)/0.008",
                        "Diffusivity = 5e-4"}) +
          steps_of(std::to_string(dt), std::to_string(M_PI / 2.)));
        const double w = .008 + 4. * D * M_PI / 2.;
        errors[i]      = error(run, [&](const auto &x) {
          return std::exp(-(std::pow(x[0] - .5, 2) + std::pow(x[1] - .6, 2)) /
                          w) /
                 w;
        });
        EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-12);
      }
    return std::log2(errors[0] / errors[1]);
  };
  EXPECT_GT(order(1.), 1.9);
  EXPECT_GT(order(4.), 1.9);
}



TEST(ScalarMpi, WithoutDiffusionParticlesKeepTheirValues)
{
  const RunCase<2> run(
    hanging_box<2>(6) +
    carried_by(eddy, {"Initial value = if(x > 0.45, 1, 0)"}) +
    steps_of("0.3", "6"));
  EXPECT_EQ(run.last("heat: least"), 0.);
  EXPECT_EQ(run.last("heat: greatest"), 1.);
  EXPECT_GE(run.last("heat: least on the mesh"), -.02);
  EXPECT_LE(run.last("heat: greatest on the mesh"), 1.02);
}



TEST(ScalarMpi, WhatIsUniformStays)
{
  const RunCase<2> run(
    hanging_box<2>(6) +
    carried_by(eddy,
               {"Initial value = 293.15", "Diffusivity = 0.1"},
               section("Boundary conditions", {"Value = left: 293.15"})) +
    steps_of("0.2", "2"));
  for (const char *what :
       {"least", "greatest", "least on the mesh", "greatest on the mesh"})
    EXPECT_EQ(run.last(std::string("heat: ") + what), 293.15) << what;
}



TEST(ScalarMpi, WhatFlowsInHasTheValueThere)
{
  // A front that comes in at all Courant numbers.
  for (const std::string dt : {"0.01", "0.5"})
    {
      const RunCase<2> run(
        unit_box<2>(8) +
        carried_by("1; 0",
                   {"Initial value = 1"},
                   section("Boundary conditions", {"Value = left: 3"}),
                   section("Boundary conditions",
                           {"Open = left: 0 | right: 0"})) +
        steps_of(dt, "2"));
      // At small steps new particles beside the inlet lie between it and what
      // was inside: that fades.
      EXPECT_NEAR(run.last("heat: least"), 3., 1e-6) << dt;
      EXPECT_NEAR(run.last("heat: greatest"), 3., 1e-6) << dt;
      EXPECT_NEAR(run.last("heat: content"), 3., 1e-7) << dt;
    }
}



TEST(ScalarMpi, GoesOnWhereItStopped)
{
  const std::string text =
    adapting_every_step("3", "4", "interface distance") +
    carried_by(eddy,
               {"Initial value = x*y", "Diffusivity = water: 0.01, air: 0.1"},
               section("Boundary conditions",
                       {"Value = left: 0", "Flux = right: t"}),
               section("Initial conditions", {"Level set = y - 0.47"}),
               two_fluids(1000., 1.)) +
    steps_of("0.1", "0.8");
  const RunCase<2>     whole(text);
  const ResumedCase<2> resumed(text, 3);
  for (const char *column : {"content",
                             "through boundaries",
                             "least",
                             "greatest on the mesh",
                             "unaccounted"})
    EXPECT_EQ(resumed->last(std::string("heat: ") + column),
              whole.last(std::string("heat: ") + column))
      << column;
}



TEST(ScalarMpi, BuoyancyTurnsWaterOver)
{
  // Warm on the left: it rises there.
  const RunCase<2> run(
    unit_box<2>(12) + section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Methods",
            {"Names = water: single fluid pfem2, heat: scalar"},
            section("water", {}, one_fluid(1., .01)) +
              section("heat",
                      {"Initial value = 0.5 - x", "Diffusivity = 0.01"},
                      section("Boundary conditions",
                              {"Value = left: 0.5 | right: -0.5"}))) +
    section("Couplings",
            {"Names = buoyancy: boussinesq"},
            section("buoyancy",
                    {"Between = water, heat", "Expansion = 0.01"})) +
    steps_of("0.1", "3"));
  EXPECT_GT(run.last("water: kinetic energy [J]"), 1e-6);
  EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-9);
}



TEST(ScalarMpi, TheBooksOfTwoFluidsBalance)
{
  // Hot water sloshes in cold air, and is heated.
  const RunCase<2> run(
    unit_box<2>(12) + section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Methods",
            {"Names = water: pfem2, heat: scalar, dye: scalar"},
            section("water",
                    {},
                    two_fluids(1000., 1., 1., .01) +
                      section("Initial conditions",
                              {"Level set = y - 0.4 - 0.2*x"})) +
              section("heat",
                      {"Initial value = if(y < 0.4 + 0.2*x, 350, 290)",
                       "Diffusivity = water: 1e-3, air: 2e-2",
                       "Capacity = water: 4e6, air: 1e3"},
                      section("Boundary conditions",
                              {"Flux = bottom: 1e6",
                               "Exchange = top: 100; 280"})) +
              section("dye", {"Initial value = if(y < 0.4 + 0.2*x, 1, 0)"})) +
    steps_of("0.02", "0.3"));
  const double heat = run.last("heat: content");
  EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-12 * heat);
  EXPECT_NEAR(run.last("heat: with the flow"), 0., 1e-4 * heat);
  EXPECT_NEAR(run.last("heat: through boundaries"), 3e5, 5e3);
  EXPECT_NEAR(run.last("dye: content"), .5, .005);
  EXPECT_EQ(run.last("dye: least"), 0.);
  EXPECT_EQ(run.last("dye: greatest"), 1.);
}
