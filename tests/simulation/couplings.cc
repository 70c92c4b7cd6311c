// SPDX-License-Identifier: LGPL-2.1-or-later
// Methods that are coupled.
#include <cmath>
#include <gtest/gtest.h>

#include "simulation/swings.h"
#include "support/complaint.h"
#include "support/input.h"
#include "support/resumed_case.h"

using namespace Thalweg;
using namespace Swings;

namespace
{
  /// Registers both for the time of a test.
  struct WithSwings : testing::Test
  {
    WithSwings()
    {
      calls.clear();
      failing_call                            = 0;
      Registry<Method<2>>::entries()["swing"] = {
        "", []() { return std::make_unique<Swing>(); }};
      Registry<Coupling<2>>::entries()["rope"] = {
        "", []() { return std::make_unique<Rope>(); }};
    }

    ~WithSwings() override
    {
      Registry<Method<2>>::entries().erase("swing");
      Registry<Coupling<2>>::entries().erase("rope");
    }
  };
  struct CouplingsMpi : WithSwings
  {};

  /// Two swings and a rope between them.
  std::string
  swings(const std::vector<std::string> &scheme  = {},
         const std::string              &between = "x, y")
  {
    return section("Methods",
                   {"Names = x: swing, y: swing"},
                   section("x", {"Start = 1"}) + section("y", {})) +
           section("Couplings",
                   {"Names = r: rope"},
                   section("r", {"Between = " + between})) +
           section("Scheme", scheme);
  }

  std::string
  steps(const std::string &dt, const std::string &end)
  {
    return section("Time", {"Time step = " + dt, "End time = " + end});
  }

  /// A mesh that changes while the time goes from 0 to 1.
  const std::string changing_mesh =
    unit_box<2>(4) + section("Refinement",
                             {},
                             section("Adaptive",
                                     {"Criteria = region", "Maximum level = 2"},
                                     section("region",
                                             {"At least = if(x < t, 2, 0)",
                                              "At most = if(x < t, 2, 0)"})));

  std::string
  sequence()
  {
    std::string text;
    for (const auto &call : calls)
      text += call.first;
    return text;
  }

  /// All that is wrong with an input.
  std::string
  faults_of(const std::string &text)
  {
    return complaint_of([&]() {
      dealii::ParameterHandler prm;
      SimulationParameters<2>  parameters;
      const ParameterFile      input(text, "the input");
      parameters.declare(Section(prm), input);
      std::vector<std::string> faults = input.apply(prm);
      parameters.check(faults);
      throw_faults(faults);
    });
  }
} // namespace



TEST_F(CouplingsMpi, IteratedStepsAreThoseOfTheTrapezoidalRule)
{
  // Which turns (x, y) by 2 atan(dt / 2).
  const RunCase<2> run(changing_mesh +
                       swings({"Iterations = 100", "Tolerance = 1e-13"}) +
                       steps(".1", "1"));
  const double     angle = 10 * 2. * std::atan(.05);
  EXPECT_NEAR(run.last("x: value"), std::cos(angle), 1e-11);
  EXPECT_NEAR(run.last("y: value"), -std::sin(angle), 1e-11);
  EXPECT_GT(run.last("adaptations"), 1.);
  EXPECT_GT(run.last("passes of the step"), 3.);
  EXPECT_LT(run.last("passes of the step"), 20.);
  EXPECT_LT(run.last("change by the last pass"), 1e-13);
  EXPECT_EQ(run.last("r: difference"), run.last("change by the last pass"));
  // What earlier passes counted is not in the row.
  EXPECT_EQ(run.last("x: advances"), 1.);
}



TEST_F(CouplingsMpi, WithoutIterationsTheErrorIsOfSecondOrder)
{
  std::vector<double> errors;
  for (const char *dt : {".1", ".05"})
    {
      const RunCase<2> run(unit_box<2>(1) + swings() + steps(dt, "1"));
      errors.push_back(std::hypot(run.last("x: value") - std::cos(1.),
                                  run.last("y: value") + std::sin(1.)));
    }
  EXPECT_GT(errors[0] / errors[1], 3.5);
  EXPECT_LT(errors[1], 2e-3);
}



TEST_F(WithSwings, TheyStandBehindTheLastOfTheirMethods)
{
  const std::string two_steps = unit_box<2>(1) + steps(".5", "1");
  RunCase<2>(two_steps + swings());
  EXPECT_EQ(sequence(), "xyrxyr");
  calls.clear();
  RunCase<2>(two_steps + swings({}, "y, x"));
  EXPECT_EQ(sequence(), "xyrxyr");
  calls.clear();
  RunCase<2>(two_steps + swings({"Order = y, r, x"}));
  EXPECT_EQ(sequence(), "yrxyrx");
}



TEST_F(WithSwings, SubStepsAreEqualPartsOfAStep)
{
  const std::string one = unit_box<2>(1) + steps(".5", ".5");
  const RunCase<2>  run(one + swings({"Sub-steps = y: 4"}));
  EXPECT_EQ(sequence(), "xyyyyr");
  for (const auto &[name, dt] : calls)
    EXPECT_DOUBLE_EQ(dt, name == "y" ? .125 : .5);
  EXPECT_DOUBLE_EQ(run.last("x: swing number"), .5);
  EXPECT_DOUBLE_EQ(run.last("y: swing number"), .125);
  calls.clear();
  RunCase<2>(one + swings({"Iterations = 2", "Tolerance = 0"}));
  EXPECT_EQ(sequence(), "xyrxyr");
}



TEST_F(WithSwings, AFailedStepTakesBackWhatWasCarried)
{
  // In the second step, when that has been iterated already.
  const std::string input = unit_box<2>(1) +
                            swings({"Iterations = 50", "Tolerance = 1e-13"}) +
                            steps(".1", ".2");
  RunCase<2> whole(input);
  failing_call = calls.size() - 2;
  calls.clear();
  const RunCase<2> run(input);
  EXPECT_GT(calls.size(), failing_call + 10);
  // The second step is made in two halves.
  const double angle = 2. * std::atan(.05) + 4. * std::atan(.025);
  EXPECT_NEAR(run.last("x: value"), std::cos(angle), 1e-11);
  EXPECT_NEAR(run.last("y: value"), -std::sin(angle), 1e-11);
}



TEST_F(CouplingsMpi, ARunGoesOnFromACheckpoint)
{
  const std::string input = changing_mesh +
                            swings({"Iterations = 3", "Tolerance = 0"}) +
                            steps(".1", "1");
  const ResumedCase<2> resumed(input, 5);
  const RunCase<2>     straight(input);
  for (const char *column : {"x: value", "y: value"})
    EXPECT_EQ(resumed->last(column), straight.last(column));
}



TEST_F(WithSwings, WhatCannotBeIsRefused)
{
  const std::string base = unit_box<2>(1) + steps("1", "1");
  const auto expect = [](const std::string &text, const std::string &sentence) {
    const std::string faults = faults_of(text);
    EXPECT_NE(faults.find(sentence), std::string::npos) << faults;
  };
  EXPECT_EQ(faults_of(base + swings()), "");
  expect(base + swings({}, "x, z"),
         "'z', and the methods in 'Methods/Names' are 'x', 'y'");
  expect(base + swings({}, "x"), "has 1 names and must have 2");
  expect(base + swings({}, "x, x"), "'x' twice");
  expect(base + swings({"Order = x, y"}), "lacks 'r'");
  expect(base + swings({"Order = x, y, r, x"}), "'x' twice");
  expect(base + swings({"Order = x, y, q"}),
         "'q', and the methods and couplings are 'x', 'y', 'r'");
  expect(base + swings({"Sub-steps = r: 2"}), "the methods are 'x', 'y'");
  expect(base + swings({"Sub-steps = x: 0"}), "write 'sand: 10'");
  expect(base + swings({"Sub-steps = x 3"}), "write 'sand: 10'");
  expect(base + swings({"Sub-steps = x: 2, x: 3"}), "twice");
  const auto couplings = [](const std::string &names, const std::string &more) {
    return section("Methods",
                   {"Names = x: swing, y: swing, w: pfem2"},
                   section("x", {}) + section("y", {}) + section("w", {})) +
           section("Couplings", {"Names = " + names}, more);
  };
  const auto between = [](const std::string &name, const std::string &methods) {
    return section(name, {"Between = " + methods});
  };
  expect(base + couplings("x: rope", between("x", "x, y")),
         "which a method in 'Methods/Names' has, too");
  expect(base + couplings("r: robe", ""), "did you mean 'rope'");
  expect(base + couplings("r: rope, r: rope", ""), "'r' twice");
  expect(base + couplings("r: rope", between("r", "x, w")),
         "'Couplings/r' needs 'value' of 'w', but 'w' offers 'flow terms', "
         "'medium', 'particles', 'streamlines', 'viscosities'; 'x' offers "
         "'push', 'value'; 'y' "
         "offers");
  expect(base + couplings("r: rope",
                          section("r", {"Between = x, y", "Strength = -1"})),
         "r: ropes pull");
  expect(base + couplings("r: rope", between("r", "x, y") + between("s", "")),
         "'s' is not in 'Couplings/Names'");
  expect(base + section("Methods", {}, section("dust", {"Start = 1"})),
         "'dust' is not in 'Methods/Names': add it there");
  expect(base + section("Couplings", {"Names = r: rope"}, between("r", "x, y")),
         "between methods with names");
  expect(base + section("Scheme", {"Iterations = 2"}), "nothing to iterate");
}
