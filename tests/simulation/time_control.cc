#include <thalweg/simulation/time_control.h>

#include <gtest/gtest.h>

#include "run_case.h"
#include "support/complaint.h"
#include "support/input.h"

namespace
{
  using Viscous = Thalweg::TimeControl::Viscous;

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
  EXPECT_NEAR(control.next_step(0.1, 100., 1., {1e3, 1e300}), .02, 1e-15);
  EXPECT_NEAR(control.next_step(0.1, 100., 1., {1e3, Viscous().limit}),
              .02,
              1e-15);
  // The method's limit allows 0.5 / 50 s.
  EXPECT_NEAR(control.next_step(0.1, 100., 1., {50., .5}), .01, 1e-15);
  // Without viscosity there is no bound.
  EXPECT_NEAR(control.next_step(0.1, 100., 1., {0., .5}), .02, 1e-15);

  const auto bounded = control_with({adaptive, "Fourier number = 0.2"});
  EXPECT_NEAR(bounded.next_step(0.1, 100., 1., {50., .5}), .004, 1e-15);
  EXPECT_NEAR(bounded.next_step(0.1, 100., 1., {50., .1}), .002, 1e-15);
}


TEST(TimeControl, KeepsAGivenStepButWarns)
{
  const auto control = control_with({"Time step = 0.02"});
  EXPECT_EQ(control.next_step(0.1, 100., 1., {50., .5}), .02);
  EXPECT_EQ(control.warning({50., .5}),
            "With 'Time/Time step' = 0.02 s the Fourier number is 1, but with "
            "explicit viscosity the method is stable only up to 0.5. The "
            "largest stable step is 0.01 s.");
  EXPECT_EQ(control.warning({20., .5}), "");
  EXPECT_EQ(control.warning({1e9, Viscous().limit}), "");
  // Steps that are chosen respect the limit: nothing to warn of.
  EXPECT_EQ(control_with({adaptive}).warning({1e9, .5}), "");
}


TEST(TimeControl, SaysWhichNumberNeedsTooShortSteps)
{
  const auto control = control_with({adaptive, "Minimum step = 0.001"});
  EXPECT_NE(complaint_of([&]() {
              control.next_step(0.1, 1., 1., {1e4, .5});
            }).find("5e-05 s would be needed for the Fourier number"),
            std::string::npos);
  EXPECT_NE(complaint_of([&]() {
              control.next_step(0.1, 1e5, 1., {1., .5});
            }).find("2e-05 s would be needed for the Courant number"),
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
  EXPECT_NEAR(control.next_step(0., 1., 0., {}), .01, 1e-15);
  EXPECT_NEAR(control.next_step(0.1, 1., .01, {}), .015, 1e-15);
  EXPECT_NEAR(control.next_step(0.4, 1., .1, {}), .1, 1e-15);
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
