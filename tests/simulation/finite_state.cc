// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/missing_fluid.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/simulation/finite_state.h>

#include <deal.II/base/function_lib.h>

#include <gtest/gtest.h>
#include <limits>

#include "postprocess/fixture.h"
#include "support/complaint.h"

using namespace Thalweg;

namespace
{
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite  = std::numeric_limits<double>::infinity();

  /// A unit box of 2 x 2 cells with a particle in each, whose level set is
  /// @p level_set.
  struct WithParticles : ::State<2>
  {
    explicit WithParticles(const double level_set)

      : ::State<2>(unit_box<2>(2))
    {
      SeedingParameters seeding;
      seeding.particles_per_direction = 1;
      seed(*population,
           seeding,
           dealii::Functions::ZeroFunction<2>(2),
           dealii::Functions::ConstantFunction<2>(level_set));
    }
  };



  void
  expect_complaint(const FlowView<2> &view, const std::string &part)
  {
    const std::string text = complaint_of([&]() { check_finite(whole(view)); });
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
} // namespace



TEST(FiniteState, FiniteFieldsPass)
{
  const WithParticles state(1.);
  EXPECT_EQ(complaint_of([&]() { check_finite(whole(state.view())); }), "");
}



TEST(FiniteState, FieldsAreNamedWithTheirPlace)
{
  WithParticles state(1.);
  const auto    only = [](const double value) {
    return [=](const dealii::Point<2> &p) {
      return p.distance({.5, 1.}) < 1e-9 ? value : 0.;
    };
  };
  state.set(state.velocity, only(undefined), 2, 1);
  auto view = state.view();
  expect_complaint(view, "At the start (t = 0 s) the velocity at (0.5 1) is");
  view.step = 12;
  view.time = .25;
  expect_complaint(view, "After step 12 (t = 0.25 s) the velocity at (0.5 1)");
  state.set(state.velocity, only(0.), 2, 1);
  state.set(state.pressure, only(infinite));
  expect_complaint(view, "the pressure at (0.5 1) is inf");
}



TEST(FiniteState, ParticlesAreNamedWithTheirPlace)
{
  WithParticles state(1.);
  for (auto &particle : state.population->particles())
    if (particle.position().distance({.75, .25}) < 1e-9)
      particle.properties()[1] = undefined;
  expect_complaint(state.view(),
                   "at (0.75 0.25) carries a velocity in y that is");
}



TEST(MissingFluid, IsNamed)
{
  const auto text = [](const double level_set) {
    const WithParticles state(level_set);
    return missing_fluid(*state.population, state.fluids);
  };
  EXPECT_NE(text(1.).find("There is no '"), std::string::npos);
  EXPECT_NE(text(1.).find("is positive everywhere or nearly so in the mesh, "
                          "which reaches from (0 0) to (1 1)"),
            std::string::npos);
  EXPECT_NE(text(-1.).find("is negative everywhere"), std::string::npos);
}
