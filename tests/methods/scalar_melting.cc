// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "support/carried_scalar.h"
#include "support/resumed_case.h"
#include "support/run_case.h"

namespace
{
  /// What melts, moved with a velocity.
  std::string
  wax(const std::vector<std::string> &settings,
      const std::string              &conditions = "",
      const std::string              &velocity   = "0; 0",
      const std::string              &fluids     = one_fluid(1., 1.),
      const std::string              &flow       = "")
  {
    return carried_by(velocity, settings, conditions, flow, fluids);
  }

  std::string
  bar(const std::string &repetitions)
  {
    return section("Geometry",
                   {},
                   section("box",
                           {"Repetitions = " + repetitions,
                            "Upper corner = 1, 0.1"}));
  }

  std::string
  given(const std::string &values)
  {
    return section("Boundary conditions", {"Value = " + values});
  }

  /// The zero of a function that falls from positive values.
  template <typename Function>
  double
  zero_of(const Function &function)
  {
    double low = 1e-6, high = 3.;
    for (unsigned int i = 0; i < 60; ++i)
      (function(.5 * (low + high)) > 0. ? low : high) = .5 * (low + high);
    return low;
  }

  const double root_of_pi = std::sqrt(M_PI);
} // namespace



// The front of a melt that begins at x = 0 is at 2 lambda sqrt(D t) (F.
// Neumann; H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 1959,
// sec. 11.2).
TEST(ScalarMeltingMpi, TheFrontOfASolidAtItsMeltingPointIsThatOfNeumann)
{
  const double lambda = zero_of([](const double l) {
    return .5 - root_of_pi * l * std::exp(l * l) * std::erf(l);
  });
  for (const std::string dt : {"0.001", "0.01"})
    {
      const RunCase<2> run(
        bar("40, 2") +
        wax({"Diffusivity = 1", "Latent heat = 2"}, given("left: 1")) +
        steps_of(dt, "0.3"));
      const double front = 2. * lambda * std::sqrt(.3);
      EXPECT_NEAR(run.last("heat: molten part"), front, .005 * front) << dt;
      EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-11) << dt;
      EXPECT_NEAR(run.last("heat: least on the mesh"), 0., 1e-5) << dt;
    }
}



TEST(ScalarMeltingMpi, TheFrontInAColdSolidIsThatOfNeumann)
{
  const double     lambda = zero_of([](const double l) {
    return std::exp(-l * l) * (.5 / std::erf(l) - .25 / std::erfc(l)) -
           root_of_pi * l;
  });
  const RunCase<2> run(bar("80, 2") +
                       wax({"Diffusivity = 1",
                            "Latent heat = 2",
                            "Initial value = 2.5",
                            "Solidus = 3",
                            "Liquidus = 3"},
                           given("left: 4 | right: 2.5")) +
                       steps_of("0.0005", "0.05"));
  const double     front = 2. * lambda * std::sqrt(.05);
  EXPECT_NEAR(run.last("heat: molten part"), front, .01 * front);
  EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-11);
}



// Each cubic metre is warmed, melts and is warmed by the same amount.
TEST(ScalarMeltingMpi, AHeatedBodyMeltsWhenItIsDue)
{
  for (const double range : {0., .5})
    for (const double end : {.5, 1.5, 3.5})
      {
        const RunCase<2> run(hanging_box<2>(4) +
                             wax({"Initial value = -1",
                                  "Diffusivity = 0.1",
                                  "Capacity = 4",
                                  "Latent heat = 8",
                                  "Liquidus = " + std::to_string(range),
                                  "Source = 4",
                                  "Tolerance = 1e-13"},
                                 "",
                                 "sin(pi*x)*cos(pi*y); -cos(pi*x)*sin(pi*y)") +
                             steps_of("0.25", std::to_string(end)));
        // Over the capacity, after it has come to the solidus.
        const double heat   = end - 1.;
        const double molten = std::clamp(heat / (2. + range), 0., 1.);
        EXPECT_NEAR(run.last("heat: molten part"), molten, 1e-12) << end;
        EXPECT_NEAR(run.last("heat: least"), heat - 2. * molten, 1e-12) << end;
        EXPECT_NEAR(run.last("heat: greatest"), heat - 2. * molten, 1e-12)
          << end;
        EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-12) << end;
      }
}



TEST(ScalarMeltingMpi, FreezingOfASlabIsTheSameIn2dAnd3d)
{
  const std::vector<std::string> settings{"Diffusivity = 0.1",
                                          "Initial value = 0.5",
                                          "Latent heat = 2"};
  const std::string              cold = given("left: -1 | right: -1");
  const RunCase<3> run(unit_box<3>(5) + wax(settings, cold, "0; 0; 0") +
                       steps_of("0.1", "0.5"));
  const RunCase<2> flat(unit_box<2>(5) + wax(settings, cold) +
                        steps_of("0.1", "0.5"));
  EXPECT_GT(run.last("heat: molten part"), .4);
  EXPECT_LT(run.last("heat: molten part"), .9);
  // The particles stand elsewhere.
  EXPECT_NEAR(run.last("heat: molten part"),
              flat.last("heat: molten part"),
              1e-3);
  EXPECT_NEAR(run.last("heat: unaccounted"), 0., 1e-11);
}



// Half molten, it goes through a periodic box and comes back.
TEST(ScalarMeltingMpi, WhatIsMoltenIsCarriedAlong)
{
  const std::string text =
    section("Geometry",
            {"Periodic boundaries = left:right"},
            section("box", {"Repetitions = 16, 4"})) +
    wax({"Initial value = 3*sin(2*pi*x)", "Latent heat = 5", "Liquidus = 1"},
        "",
        "1; 0");
  const RunCase<2> run(text + steps_of("0.1", "1"));
  const RunCase<2> start(text + steps_of("1e-9", "1e-9"));
  EXPECT_NEAR(run.last("heat: molten part"),
              start.last("heat: molten part"),
              .01);
  EXPECT_NEAR(run.last("heat: content"), start.last("heat: content"), 1e-10);
}



TEST(ScalarMeltingMpi, OneOfTwoFluidsMeltsAndGoesOnWhereItStopped)
{
  const std::string text =
    adapting_every_step("3", "4", "interface distance") +
    wax({"Initial value = -0.2",
         "Diffusivity = water: 0.05, air: 0.5",
         "Capacity = water: 1000, air: 1",
         "Latent heat = water: 500, air: 0"},
        section("Boundary conditions",
                {"Value = bottom: 1", "Exchange = top: 10; 3"}),
        "sin(pi*x)*cos(pi*y); -cos(pi*x)*sin(pi*y)",
        two_fluids(1000., 1.),
        section("Initial conditions", {"Level set = y - 0.47"})) +
    steps_of("0.05", "0.4");
  const RunCase<2>     whole(text);
  const ResumedCase<2> resumed(text, 3);
  for (const char *column : {"content", "molten part", "least"})
    EXPECT_EQ(resumed->last(std::string("heat: ") + column),
              whole.last(std::string("heat: ") + column))
      << column;
  EXPECT_GT(whole.last("heat: molten part"), .2);
  EXPECT_LT(whole.last("heat: molten part"), .9);
  const double content = whole.last("heat: content");
  EXPECT_NEAR(whole.last("heat: unaccounted"), 0., 1e-11 * content);
}
