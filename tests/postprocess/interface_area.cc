// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "fixture.h"
#include "support/dimensions.h"

namespace
{
  template <typename T>
  class InterfaceAreaMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(InterfaceAreaMpi, Dimensions);
} // namespace


// A plane through cells, hanging nodes and corners.
TYPED_TEST(InterfaceAreaMpi, IsThatOfAPlane)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(hanging_box<dim>(4));
  state.set(state.level_set,
            [](const auto &p) { return .6 * p[0] + .8 * p[1] - .7; });
  state.run("interface area", {"Interval = 0"});
  // from (0, 7/8) to (1, 1/8)
  EXPECT_NEAR(state.read("interface_area.csv").second[1], 1.25, 1e-12);
}


TYPED_TEST(InterfaceAreaMpi, ABallIsRound)
{
  constexpr int dim = TypeParam::value;
  for (const bool is_bubble : {false, true})
    {
      State<dim> state(unit_box<dim>(dim == 2 ? 32 : 16) + two_fluids(2., 1.));
      state.set(state.level_set, [&](const auto &p) {
        double squares = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          squares += (p[d] - .51) * (p[d] - .51);
        return (is_bubble ? -1. : 1.) * (std::sqrt(squares) - .3);
      });
      state.run("interface area",
                {std::string("Fluid = ") + (is_bubble ? "air" : "water")});
      const auto   values = state.read("interface_area.csv").second;
      const double exact  = dim == 2 ? 2. * M_PI * .3 : 4. * M_PI * .09;
      EXPECT_NEAR(values[1] / exact, 1., dim == 2 ? 2e-3 : 1.5e-2);
      EXPECT_NEAR(values[2], 1., dim == 2 ? 1e-3 : 5e-3);
    }
}


TEST(InterfaceAreaMpi2d, NoInterfaceIsNotRound)
{
  State<2> state(unit_box<2>(4));
  state.run("interface area", {});
  const auto values = state.read("interface_area.csv").second;
  EXPECT_EQ(values[1], 0.);
  EXPECT_EQ(values[2], 0.);
}
