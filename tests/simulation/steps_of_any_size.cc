// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "support/flow_scene.h"
#include "support/run_case.h"

namespace
{
  /// A run that has not begun, and whose steps a test chooses.
  class Stepper
  {
  public:
    explicit Stepper(const std::string &text)
      : run(text + section("Time", {"End time = 0"}))
    {}

    /// Makes steps of these sizes.
    void
    make(const std::vector<double> &sizes)
    {
      for (const double dt : sizes)
        {
          run.parameters.scheme.advance(time, dt, run.context.statistics, []() {
          });
          time += dt;
        }
    }

    const Thalweg::FlowFields<2> &
    flow() const
    {
      return *run.simulation->view().flow("").flow;
    }

    RunCase<2> run;
    double     time = 0.;
  };


  /// @p n steps of 0.01 s with steps of @p tiny behind each third one.
  std::vector<double>
  with_tiny(const unsigned int n, const std::vector<double> &tiny)
  {
    std::vector<double> sizes;
    for (unsigned int i = 1; i <= n; ++i)
      {
        sizes.push_back(.01);
        if (i % 3 == 0)
          sizes.insert(sizes.end(), tiny.begin(), tiny.end());
      }
    return sizes;
  }

  const std::vector<std::vector<double>> sequences{{1e-5},
                                                   {1e-7},
                                                   {1e-7, 1e-9, 1e-7},
                                                   std::vector<double>(30,
                                                                       1e-7),
                                                   {.004, .002, 1e-5, 1e-4}};


  std::string
  single_fluid(const std::vector<std::string> &settings = {})
  {
    return section("Method",
                   {"Model = single fluid pfem2"},
                   section("single fluid pfem2", settings));
  }


  std::string
  vortices(const std::vector<std::string> &settings = {})
  {
    return unit_box<2>(16,
                       "0",
                       {"Periodic boundaries = left:right, bottom:top"}) +
           single_fluid(settings) + one_fluid(1., .01) +
           section("Initial conditions",
                   {"Velocity = sin(2*pi*x)*cos(2*pi*y); "
                    "-cos(2*pi*x)*sin(2*pi*y)"});
  }


  double
  vortex_error(const Stepper &stepper)
  {
    const double left = std::exp(-8. * M_PI * M_PI * .01 * stepper.time);
    const auto  &flow = stepper.flow();
    return mean_square_error(flow.velocity_dofs,
                             flow.mapping,
                             flow.velocity,
                             [left](const dealii::Point<2> &x) {
                               const double a = 2. * M_PI * x[0],
                                            b = 2. * M_PI * x[1];
                               return left * dealii::Tensor<1, 2>(
                                               {std::sin(a) * std::cos(b),
                                                -std::cos(a) * std::sin(b)});
                             }) /
           left;
  }
} // namespace



TEST(StepsOfAnySize, LeaveVorticesAsExact)
{
  for (const std::string order : {"second order", "first order"})
    {
      const std::vector<std::string> settings{"Time integration = " + order};
      Stepper                        even(vortices(settings));
      even.make(std::vector<double>(15, .01));
      const double expected = vortex_error(even);
      for (const auto &tiny : sequences)
        {
          Stepper uneven(vortices(settings));
          uneven.make(with_tiny(15, tiny));
          EXPECT_LT(vortex_error(uneven),
                    (tiny[0] < 1e-4 ? 1.01 : 1.05) * expected)
            << order << ", " << tiny.size() << " steps of " << tiny[0];
        }
    }
}



TEST(StepsOfAnySize, LeaveThePressureAsItWas)
{
  Stepper stepper(vortices());
  stepper.make(std::vector<double>(6, .01));
  const auto pressure = stepper.flow().pressure;
  for (const auto &tiny : sequences)
    if (tiny[0] < 1e-4)
      {
        stepper.make(tiny);
        auto difference = pressure;
        difference.add(-1., stepper.flow().pressure);
        // It is that of the end, no more that of the middle of a step, from
        // which it has fallen by 0.8 %.
        EXPECT_LT(difference.linfty_norm(), .01 * pressure.linfty_norm());
      }
}



TEST(StepsOfAnySize, LeaveForcesOnWallsAsTheyWere)
{
  // A lid that is drawn over a fluid at rest. Halves of these steps change
  // forces by 8 %.
  const std::string cavity = unit_box<2>(8) + single_fluid() +
                             one_fluid(2., .05) +
                             section("Boundary conditions",
                                     {"No slip = left, right, bottom",
                                      "Velocity = top: 16*x^2*(1-x)^2; 0"});
  Stepper even(cavity), uneven(cavity);
  even.make(std::vector<double>(12, .02));
  std::vector<double> sizes;
  for (unsigned int i = 0; i < 12; ++i)
    for (const double dt : {.02, 1e-7, 1e-6})
      sizes.push_back(dt);
  uneven.make(sizes);
  auto difference = *even.flow().reaction;
  difference.add(-1., *uneven.flow().reaction);
  EXPECT_LT(difference.linfty_norm(),
            1e-3 * even.flow().reaction->linfty_norm());
  // The next one of usual size is undisturbed, too.
  even.make({.02});
  uneven.make({.02});
  difference = *even.flow().reaction;
  difference.add(-1., *uneven.flow().reaction);
  EXPECT_LT(difference.linfty_norm(),
            1e-3 * even.flow().reaction->linfty_norm());
}



TEST(StepsOfAnySize, AfterManyTinyOnesALongOneIsPredictedLikeTheFirst)
{
  Stepper stepper(vortices());
  // Far more time than a step of theirs, far less than the long one.
  stepper.make(std::vector<double>(20, 1e-6));
  stepper.make(std::vector<double>(15, .01));
  EXPECT_LT(vortex_error(stepper), .012);
}



TEST(StepsOfAnySize, IncrementalPressureSurvivesThem)
{
  const std::vector<std::string> settings{"Explicit pressure = incremental"};
  Stepper                        even(vortices(settings));
  even.make(std::vector<double>(15, .01));
  Stepper uneven(vortices(settings));
  uneven.make(with_tiny(15, {1e-7}));
  EXPECT_LT(vortex_error(uneven), 1.01 * vortex_error(even));
}
