// SPDX-License-Identifier: LGPL-2.1-or-later
// Several methods on one mesh, some of them of a physics that only this test
// knows.
#include <thalweg/fields/node_space.h>
#include <thalweg/methods/method.h>

#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/input.h"
#include "support/resumed_case.h"

using namespace Thalweg;

namespace
{
  /// A field that grows at a given rate, or at that of another method.
  class Ramp : public Method<2>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      section.add("Rate", rate, "1/s", "How fast it grows.");
      section.add("Follow", followed, "", "The method whose rate is added.");
    }

    void
    declare_sections(const Section &) override
    {}

    void
    create(const Host<2> &host_) override
    {
      host = std::make_unique<Host<2>>(host_);
    }

    void
    release() override
    {
      space.reset();
    }

    void
    attach() override
    {
      space = std::make_unique<NodeSpace<2>>(host->mesh);
      space->initialize_scalar(value);
    }

    void
    offer(Ports &ports) const override
    {
      ports.offer(host->name, "rate", rate);
    }

    void
    initialize() override
    {
      attach();
    }

    void
    keep(const Thalweg::State<2> &state) override
    {
      state.values().value("sub-steps", n_advances);
      state.field("value", *space, value, 1);
    }

    StepNumbers
    step_numbers() const override
    {
      StepNumber number;
      number.name   = "ramp number";
      number.rate   = rate;
      number.stable = .25;
      return {number};
    }

    unsigned int
    n_sub_steps(const double) const override
    {
      return 3;
    }

    void
    advance(const double, const double dt) override
    {
      double sum = rate;
      if (!followed.empty())
        sum += host->ports.get<const double>(followed, "rate", "A ramp");
      value.zero_out_ghost_values();
      value.add(sum * dt);
      space->interpolate(value, 1);
      ++n_advances;
    }

    void
    record(const double) override
    {
      auto &statistics = host->context.statistics;
      statistics.set("value", value.linfty_norm());
      statistics.set("sub-steps", n_advances);
    }

    std::string
    size() const override
    {
      return "a ramp";
    }

    std::string
    headline() const override
    {
      return "";
    }

  private:
    double                        rate = 0.;
    std::string                   followed;
    unsigned int                  n_advances = 0;
    std::unique_ptr<Host<2>>      host;
    std::unique_ptr<NodeSpace<2>> space;
    Vector                        value;
  };



  /// Registers ramps for the time of a test.
  struct WithRamps : testing::Test
  {
    WithRamps()
    {
      Registry<Method<2>>::entries()["ramp"] = {
        "", []() { return std::make_unique<Ramp>(); }};
    }

    ~WithRamps() override
    {
      Registry<Method<2>>::entries().erase("ramp");
    }
  };
  struct MethodsMpi : WithRamps
  {};

  /// Two ramps on a mesh that changes twice.
  const std::string changing =
    unit_box<2>(4) + section("Refinement",
                             {},
                             section("Adaptive",
                                     {"Criteria = region", "Maximum level = 2"},
                                     section("region",
                                             {"At least = if(x < t, 2, 0)",
                                              "At most = if(x < t, 2, 0)"})));

  std::string
  two_ramps(const std::vector<std::string> &own = {})
  {
    return section("Methods",
                   {"Names = a: ramp, b: ramp"},
                   section("a", {"Rate = 1"}) + section("b", own));
  }
} // namespace



TEST_F(MethodsMpi, TwoOfOneKindHaveStatesOfTheirOwn)
{
  const RunCase<2> run(changing + two_ramps({"Rate = 2", "Follow = a"}) +
                       section("Time", {"Time step = .1", "End time = 1"}));
  EXPECT_NEAR(run.last("a: value"), 1., 1e-12);
  EXPECT_NEAR(run.last("b: value"), 3., 1e-12);
  EXPECT_EQ(run.last("a: sub-steps"), 30.);
  EXPECT_DOUBLE_EQ(run.last("b: ramp number"), .2);
  EXPECT_GT(run.last("adaptations"), 1.);
}



TEST_F(MethodsMpi, TheirNumbersBoundTheStep)
{
  const RunCase<2> run(unit_box<2>(4) + two_ramps({"Rate = 4"}) +
                       section("Time",
                               {"Maximal number of steps = 1",
                                "End time = 1",
                                "First step = 1",
                                "Maximum step = 1"}));
  EXPECT_DOUBLE_EQ(run.last("dt [s]"), .0625);
}



TEST_F(MethodsMpi, AFlowRunsBesideThem)
{
  const std::string flow =
    section("Initial conditions", {"Level set = y - 0.55"});
  const std::string common =
    unit_box<2>(4) + section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Time", {"Time step = .01", "End time = .03"});
  const RunCase<2> alone(common + flow);
  const RunCase<2> both(common + section("Methods",
                                         {"Names = drift: ramp, water: pfem2"},
                                         section("drift", {"Rate = 1"}) +
                                           section("water", {}, flow)));
  EXPECT_NEAR(both.last("drift: value"), .03, 1e-12);
  for (const char *column :
       {"particles", "volume 1 [m^d]", "kinetic energy [J]", "dofs"})
    EXPECT_EQ(both.last(std::string("water: ") + column), alone.last(column));
}



TEST_F(MethodsMpi, ARunGoesOnFromACheckpoint)
{
  const std::string input = changing + two_ramps({"Rate = 2", "Follow = a"}) +
                            section("Time", {"Time step = .1", "End time = 1"});
  const ResumedCase<2> resumed(input, 5);
  const RunCase<2>     straight(input);
  for (const char *column : {"b: value", "b: sub-steps"})
    EXPECT_EQ(resumed->last(column), straight.last(column));
}



TEST_F(WithRamps, WhatCannotBeIsRefused)
{
  const auto complaint = [](const std::string &names,
                            const std::string &sections = "") {
    return complaint_of([&]() {
      RunCase<2>(unit_box<2>(1) +
                 section("Methods", {"Names = " + names}, sections) +
                 section("Time", {"Time step = 1", "End time = 1"}));
    });
  };
  EXPECT_NE(complaint("a: rump").find("did you mean 'ramp'"),
            std::string::npos);
  EXPECT_NE(complaint("a: ramp, a: ramp").find("twice"), std::string::npos);
  EXPECT_NE(complaint("ramp").find("water: pfem2"), std::string::npos);
  EXPECT_NE(complaint("a/b: ramp").find("a/b"), std::string::npos);
  const std::string missing =
    complaint("a: ramp", section("a", {"Follow = c"}));
  EXPECT_NE(missing.find("'rate' of 'c'"), std::string::npos) << missing;
  EXPECT_NE(missing.find("'rate' of 'a'"), std::string::npos) << missing;
}
