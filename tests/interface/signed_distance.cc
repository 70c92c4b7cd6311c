// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/expression.h>
#include <thalweg/interface/signed_distance.h>

#include <cmath>
#include <gtest/gtest.h>

using namespace Thalweg;

namespace
{
  double
  distance(const std::string &expression, const dealii::Point<2> &x)
  {
    const auto function = parse_expression<2>(expression, 1, "test");
    return SignedDistance<2>(*function, .1).value(x);
  }

  const dealii::Point<2> points[] = {{.3, .2}, {.51, .9}, {.77, .53}};
} // namespace



TEST(SignedDistance, IsThatOfPlanesAndCirclesHoweverTheyAreWritten)
{
  for (const auto &x : points)
    {
      EXPECT_NEAR(distance("y^2 - 0.25", x), x[1] - .5, 1e-13);
      EXPECT_NEAR(distance("exp(y) - exp(0.5)", x), x[1] - .5, 1e-13);
      EXPECT_NEAR(distance("40*(x + y - 1)", x),
                  (x[0] + x[1] - 1.) / std::sqrt(2.),
                  1e-13);
      EXPECT_NEAR(distance("x^2 + y^2 - 0.25", x), x.norm() - .5, 1e-13);
    }
}



TEST(SignedDistance, LeavesDistancesAsTheyAre)
{
  for (const auto &x : points)
    {
      EXPECT_EQ(distance("y - 0.25", x), x[1] - .25);
      EXPECT_EQ(distance("max(x - 0.6, y - 0.4)", x),
                std::max(x[0] - .6, x[1] - .4));
    }
  // On an edge too.
  EXPECT_EQ(distance("max(x - 0.5, y - 0.5)", {.25, .25}), -.25);
}



TEST(SignedDistance, SignsKeepTheirSign)
{
  for (const auto &x : points)
    EXPECT_EQ(distance("if(y < 0.525, -1, 1)", x), x[1] < .525 ? -1. : 1.);
}
