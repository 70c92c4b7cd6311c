// SPDX-License-Identifier: LGPL-2.1-or-later
// What others let act in a flow acts as body forces do.
#include <thalweg/coupling/coupling.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/fluid/flow_terms.h>

#include <cmath>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// Accelerates the first of two methods by an expression.
  class Wind : public Coupling<2>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      section.add("Acceleration",
                  expression,
                  "",
                  "Two components.",
                  dealii::Patterns::Anything());
    }

    std::vector<std::vector<std::string>>
    needs() const override
    {
      return {{FlowTerms<2>::port}};
    }

    void
    create(const Host<2>                  &host_,
           const std::vector<std::string> &methods) override
    {
      host = std::make_unique<Host<2>>(host_);
      flow = methods[0];
    }

    void
    release() override
    {
      wind = {};
    }

    void
    attach() override
    {
      terms().space().initialize_velocity(wind.before);
      terms().space().initialize_velocity(wind.now);
      terms().accelerate(host->name, wind);
    }

    void
    initialize() override
    {
      wind.time_now = wind.time_before = 0.;
      find(0., wind.before);
      find(0., wind.now);
    }

    void
    keep(const State<2> &state) override
    {
      state.values().value("time before", wind.time_before);
      state.values().value("time now", wind.time_now);
      state.field("before", terms().space(), wind.before, 2);
      state.field("now", terms().space(), wind.now, 2);
    }

    void
    transfer(const double time, const double dt) override
    {
      find(time, wind.before);
      find(time + dt, wind.now);
      wind.time_before = time;
      wind.time_now    = time + dt;
    }

  private:
    FlowTerms<2> &
    terms() const
    {
      return host->ports.get<FlowTerms<2>>(flow, FlowTerms<2>::port, "Wind");
    }

    void
    find(const double time, Vector &result) const
    {
      const auto function = parse_expression<2>(expression, 2, "wind");
      function->set_time(time);
      interpolate_function(terms().space(), *function, result);
    }

    std::string              expression = "0; 0";
    std::unique_ptr<Host<2>> host;
    std::string              flow;
    NodalAcceleration        wind;
  };



  struct FlowTermsMpi : testing::Test
  {
    FlowTermsMpi()
    {
      Registry<Coupling<2>>::entries()["wind"] = {
        "", []() { return std::make_unique<Wind>(); }};
    }

    ~FlowTermsMpi() override
    {
      Registry<Coupling<2>>::entries().erase("wind");
    }
  };

  std::string
  sections(const std::string &model, const std::string &own)
  {
    return section("Methods",
                   {"Names = water: " + model},
                   section("water", {}, own));
  }

  std::string
  wind(const std::string &acceleration)
  {
    return section(
      "Couplings",
      {"Names = w: wind"},
      section("w", {"Between = water", "Acceleration = " + acceleration}));
  }

  /// What a wind does is what an acceleration of the same kind does.
  void
  expect_the_same(const std::string &model,
                  const std::string &own,
                  const double       tolerance)
  {
    const std::string acceleration = "sin(3*y); x*x*cos(2*y)";
    const std::string common =
      hanging_box<2>(6) +
      section("Time", {"Time step = .02", "End time = .1"}) +
      sections(model, own);
    const RunCase<2> force(
      common + section("Body forces", {"Acceleration = " + acceleration}));
    const RunCase<2> blown(common + wind(acceleration));
    const double     energy = force.last("water: kinetic energy [J]");
    EXPECT_GT(energy, 0.);
    EXPECT_NEAR(blown.last("water: kinetic energy [J]"),
                energy,
                tolerance * energy);
    EXPECT_NEAR(blown.last("water: particles"),
                force.last("water: particles"),
                0.);
  }
} // namespace



TEST_F(FlowTermsMpi, ActInTwoFluids)
{
  expect_the_same("pfem2",
                  two_fluids(1000., 1., .1, .1) +
                    section("Initial conditions", {"Level set = y - 0.52"}),
                  1e-9);
}



TEST_F(FlowTermsMpi, ActInASingleFluid)
{
  expect_the_same("single fluid pfem2", one_fluid(2., .01), 1e-9);
}



TEST_F(FlowTermsMpi, AreOfSecondOrderInTime)
{
  // Everywhere the same in a periodic box: V = t^2 / 2.
  const std::string periodic =
    unit_box<2>(4, "0", {"Periodic boundaries = left:right"});
  for (const char *model : {"single fluid pfem2", "pfem2"})
    {
      double errors[2];
      for (const unsigned int i : {0, 1})
        {
          const RunCase<2> run(
            periodic + sections(model, one_fluid(1., .001)) + wind("t; 0") +
            section("Time",
                    {std::string("Time step = ") + (i == 0 ? ".1" : ".05"),
                     "End time = 1"}));
          const double time   = run.last("water: velocity time [s]");
          const double energy = run.last("water: kinetic energy [J]");
          errors[i] = std::abs(std::sqrt(2. * energy) - .5 * time * time);
        }
      EXPECT_LT(errors[0], .02) << model;
      EXPECT_LT(errors[1], .3 * errors[0] + 1e-9) << model;
    }
}
