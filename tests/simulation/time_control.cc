// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/time_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "support/complaint.h"
#include "support/input.h"
#include "support/run_case.h"

namespace
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();

  /// Courant number of a step of one second, Fourier number of the same and
  /// the largest stable one.
  Thalweg::StepNumbers
  numbers(const double courant,
          const double fourier = 0.,
          const double stable  = unlimited)
  {
    return {{"Courant number", courant},
            {"Fourier number", fourier, stable, "with explicit viscosity"}};
  }

  Thalweg::TimeControl
  control_with(const std::vector<std::string> &settings)
  {
    Thalweg::TimeControl     control;
    dealii::ParameterHandler prm;
    control.declare_parameters(Thalweg::Section(prm));
    prm.parse_input_from_string(section("Time", settings));
    return control;
  }

  const std::string adaptive = "Maximum step = 1";
} // namespace



TEST(TimeControl, TakesTheSmallerOfCourantAndFourierSteps)
{
  const auto control = control_with({adaptive, "Courant number = 2"});
  // The Courant number alone allows 0.02 s, without any limit of the method.
  EXPECT_NEAR(control.next_step(0.1, numbers(100., 1e3, 1e300), 1.).wanted,
              .02,
              1e-15);
  EXPECT_NEAR(control.next_step(0.1, numbers(100., 1e3, unlimited), 1.).wanted,
              .02,
              1e-15);
  // The method's limit allows 0.5 / 50 s.
  EXPECT_NEAR(control.next_step(0.1, numbers(100., 50., .5), 1.).wanted,
              .01,
              1e-15);
  // Without viscosity there is no bound.
  EXPECT_NEAR(control.next_step(0.1, numbers(100., 0., .5), 1.).wanted,
              .02,
              1e-15);

  const auto bounded = control_with({adaptive, "Fourier number = 0.2"});
  EXPECT_NEAR(bounded.next_step(0.1, numbers(100., 50., .5), 1.).wanted,
              .004,
              1e-15);
  EXPECT_NEAR(bounded.next_step(0.1, numbers(100., 50., .1), 1.).wanted,
              .002,
              1e-15);
}


TEST(TimeControl, KeepsAGivenStepButWarns)
{
  const auto control = control_with({"Time step = 0.02"});
  EXPECT_EQ(control.next_step(0.1, numbers(100., 50., .5), 1.).size, .02);
  EXPECT_EQ(control.warning(numbers(0., 50., .5)),
            "With 'Time/Time step' = 0.02 s the Fourier number is 1, but with "
            "explicit viscosity the method is stable only up to 0.5. The "
            "largest stable step is 0.01 s.");
  EXPECT_EQ(control.warning(numbers(0., 20., .5)), "");
  EXPECT_EQ(control.warning(numbers(0., 1e9, unlimited)), "");
  // Steps that are chosen respect the limit: nothing to warn of.
  EXPECT_EQ(control_with({adaptive}).warning(numbers(0., 1e9, .5)), "");
}


TEST(TimeControl, SaysWhichNumberNeedsTooShortSteps)
{
  const auto control = control_with({adaptive, "Minimum step = 0.001"});
  EXPECT_NE(complaint_of([&]() {
              control.next_step(0.1, numbers(1., 1e4, .5), 1.);
            }).find("5e-05 s would be needed for the Fourier number"),
            std::string::npos);
  EXPECT_NE(complaint_of([&]() {
              control.next_step(0.1, numbers(1e5, 1., .5), 1.);
            }).find("2e-05 s would be needed for the Courant number"),
            std::string::npos);
}


TEST(TimeControl, RespectsNumbersThatItDoesNotKnow)
{
  const auto                control = control_with({adaptive});
  const Thalweg::StepNumber contact{"contact number", 100., .1, "", "grains"};
  auto                      all = numbers(1.);
  all.push_back(contact);
  EXPECT_NEAR(control.next_step(.1, all, 1.).wanted, .001, 1e-15);
  // A method need not have any number.
  EXPECT_NEAR(control.next_step(.1, {}, 1.).size, .9, 1e-15);
}


TEST(TimeControl, RefusesWhatIsNoNumber)
{
  const auto control = control_with({"Time step = 0.1"});
  EXPECT_NE(complaint_of([&]() {
              control.next_step(.1, numbers(unlimited), 1.);
            }).find("the Courant number is no finite number"),
            std::string::npos);
}


TEST(TimeControl, RefusesAFourierNumberOfZero)
{
  EXPECT_NE(complaint_of([]() {
              control_with({"Fourier number = 0"}).check();
            }).find("'Time/Fourier number' is"),
            std::string::npos);
}


TEST(TimeControl, GrowsAndHitsTheEnd)
{
  const auto control =
    control_with({adaptive, "End time = 0.5", "First step = 0.01"});
  EXPECT_NEAR(control.next_step(0., numbers(1.), 0.).wanted, .01, 1e-15);
  EXPECT_NEAR(control.next_step(0.1, numbers(1.), .01).wanted, .015, 1e-15);
  EXPECT_NEAR(control.next_step(0.4, numbers(1.), .1).size, .1, 1e-15);
  EXPECT_EQ(control.next_step(0.4, numbers(1.), .1).end, .5);
}



namespace
{
  struct Run
  {
    std::vector<double> sizes, ends;
  };


  /// All steps to the end. @param rate_at the Courant number of a step of one
  /// second as a function of time @param failing is halved
  Run
  run(
    const Thalweg::TimeControl                &control,
    const std::function<double(const double)> &rate_at =
      [](const double) { return 1.; },
    const unsigned int failing = 0)
  {
    Run    run;
    double time = 0., wanted = 0., size = 0.;
    for (unsigned int step = 1; !control.is_over(time, 0); ++step)
      {
        auto plan =
          control.next_step(time, numbers(rate_at(time)), wanted, size);
        if (step == failing)
          {
            plan.size *= .5;
            plan.end    = time + plan.size;
            plan.wanted = plan.size;
          }
        time   = plan.end;
        size   = plan.size;
        wanted = plan.wanted;
        run.sizes.push_back(size);
        run.ends.push_back(time);
      }
    return run;
  }


  double
  smallest(const std::vector<double> &values)
  {
    return *std::min_element(values.begin(), values.end());
  }


  double
  largest(const std::vector<double> &values)
  {
    return *std::max_element(values.begin(), values.end());
  }


  /// Whether one of @p values has the bits of @p wanted.
  bool
  contains(const std::vector<double> &values, const double wanted)
  {
    return std::find(values.begin(), values.end(), wanted) != values.end();
  }
} // namespace


TEST(TimeControl, TakesARoundedThirdForAThird)
{
  for (const std::string step :
       {"0.0033333", "0.00333", "0.0033333333333", "0.0033334"})
    {
      const auto steps = run(control_with(
        {"Time step = " + step, "Hit multiples of = 0.01", "End time = 0.2"}));
      EXPECT_EQ(steps.sizes.size(), 60u) << step;
      EXPECT_NEAR(smallest(steps.sizes), .01 / 3., 1e-12);
      for (unsigned int k = 1; k < 20; ++k)
        EXPECT_TRUE(contains(steps.ends, k * .01)) << k;
      EXPECT_EQ(steps.ends.back(), .2);
    }
  // 0.0033 does not mean a third: four steps.
  EXPECT_NEAR(largest(run(control_with({"Time step = 0.0033",
                                        "Hit multiples of = 0.01",
                                        "End time = 0.1"}))
                        .sizes),
              .0025,
              1e-12);
}


TEST(TimeControl, DividesGivenStepsEvenly)
{
  for (const double step : {.003, .0031, .0049, .007, .01, .05})
    for (const std::string multiples : {"0", "0.1", "0.03"})
      {
        const auto steps =
          run(control_with({"Time step = " + std::to_string(step),
                            "Hit multiples of = " + multiples,
                            "End time = 0.3"}));
        const double between = multiples == "0" ? .3 : std::stod(multiples);
        const double n       = std::ceil(between / step / 1.005);
        EXPECT_NEAR(smallest(steps.sizes), between / n, 1e-10);
        EXPECT_NEAR(largest(steps.sizes), between / n, 1e-10);
        EXPECT_EQ(steps.ends.back(), .3);
      }
}


TEST(TimeControl, EndsBesideAMultipleAreMeantToBeIt)
{
  // 1e-7 s behind the 30th multiple.
  const auto behind = run(control_with(
    {"Time step = 0.005", "Hit multiples of = 0.01", "End time = 0.3000001"}));
  EXPECT_EQ(behind.sizes.size(), 60u);
  EXPECT_GT(smallest(behind.sizes), .0049999);
  EXPECT_EQ(behind.ends.back(), .3000001);
  // The same without multiples, and where the end cuts a step short.
  const auto cut =
    run(control_with({"Time step = 0.005", "End time = 0.50001"}));
  EXPECT_EQ(cut.sizes.size(), 100u);
  EXPECT_NEAR(smallest(cut.sizes), largest(cut.sizes), 1e-10);
  EXPECT_EQ(run(control_with({"Time step = 0.005", "End time = 0.001"})).sizes,
            std::vector<double>{.001});
}


TEST(TimeControl, SumsOfManyStepsLeaveNoTinyOne)
{
  for (const std::string multiples : {"0", "0.7", "0.001"})
    {
      const auto steps = run(control_with({"Time step = 0.0001",
                                           "Hit multiples of = " + multiples,
                                           "End time = 2.1"}));
      EXPECT_EQ(steps.sizes.size(), 21000u);
      EXPECT_NEAR(smallest(steps.sizes), 1e-4, 1e-10);
      EXPECT_NEAR(largest(steps.sizes), 1e-4, 1e-10);
      EXPECT_EQ(steps.ends.back(), 2.1);
      // Equal steps have equal bits, but where their sum has to be mended.
      unsigned int n_changes = 0;
      for (unsigned int i = 1; i < steps.sizes.size(); ++i)
        n_changes += steps.sizes[i] != steps.sizes[i - 1];
      EXPECT_LE(n_changes, 2u);
    }
}


TEST(TimeControl, AFailedStepLeavesNoTinyOne)
{
  for (unsigned int failing : {1, 2, 3, 7})
    {
      const auto steps = run(
        control_with({"Time step = 0.0033333",
                      "Hit multiples of = 0.01",
                      "End time = 0.05"}),
        [](const double) { return 1.; },
        failing);
      EXPECT_GT(smallest(steps.sizes), .0016);
      for (unsigned int k = 1; k < 5; ++k)
        EXPECT_TRUE(contains(steps.ends, k * .01)) << k;
    }
}


TEST(TimeControl, CourantStepsAreEqualBetweenTargets)
{
  // The velocity allows 0.003 s.
  const auto steps = run(control_with({adaptive,
                                       "Courant number = 2",
                                       "First step = 0.1",
                                       "Hit multiples of = 0.01",
                                       "End time = 0.1"}),
                         [](const double) { return 2. / .003; });
  EXPECT_EQ(steps.sizes.size(), 40u);
  EXPECT_NEAR(smallest(steps.sizes), .0025, 1e-12);
  EXPECT_NEAR(largest(steps.sizes), .0025, 1e-12);
}


TEST(TimeControl, CourantStepsNeverShrinkBelowHalfOfWhatIsAllowed)
{
  const auto control = control_with({adaptive,
                                     "Courant number = 2",
                                     "First step = 0.1",
                                     "Hit multiples of = 0.01",
                                     "End time = 0.3333333"});
  const auto rate    = [](const double t) {
    return 2. / (.004 + .003 * std::sin(50. * t));
  };
  double before = 0.;
  for (const double end : run(control, rate).ends)
    {
      EXPECT_GT(end - before, .49 * std::min(2. / rate(before), .0033333));
      before = end;
    }
}


TEST(TimeControl, AllowedStepsGrowPastADividedOne)
{
  // Steps of 0.01 s are two of the allowed 0.006 s; growth by 1.2 must not end
  // there.
  const auto steps = run(control_with({adaptive,
                                       "Growth = 1.2",
                                       "First step = 0.004",
                                       "Hit multiples of = 0.01",
                                       "End time = 0.1"}),
                         [](const double) { return 2. / .02; });
  EXPECT_NEAR(steps.sizes.back(), .01, 1e-12);
}


TEST(FourierNumber, StandsInTheStatistics)
{
  // nu is 0.1 and 0.25 m^2/s, the shortest edge 1/8 m beside hanging nodes.
  const RunCase<2> run(
    hanging_box<2>(4) +
    section("Time", {"Time step = 0.01", "End time = 0.01"}) +
    two_fluids(2., 1., .2, .25) +
    section("Initial conditions", {"Level set = y - 0.4"}));
  EXPECT_NEAR(run.last("Fourier number"), .16, 1e-12);
}
