// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/numerical_derivative.h>

#include <cmath>
#include <gtest/gtest.h>

using namespace Thalweg;



TEST(NumericalDerivative, IsExactEnoughForAnyPeriod)
{
  for (const double period : {1e-3, 1e-2, .1, 1., 10., 100.})
    for (const double t : {0., .1, 1.234, 10.})
      {
        const double omega = 2. * M_PI / period;
        const auto   f     = [omega](const double s) {
          return std::sin(omega * s + .3);
        };
        EXPECT_NEAR(derivative(f, t, 1),
                    omega * std::cos(omega * t + .3),
                    1e-8 * omega)
          << period << " " << t;
        EXPECT_NEAR(derivative(f, t, 2),
                    -omega * omega * std::sin(omega * t + .3),
                    1e-6 * omega * omega)
          << period << " " << t;
      }
}



TEST(NumericalDerivative, OfPolynomialsAndConstants)
{
  EXPECT_NEAR(derivative([](const double t) { return 3. * t * t; }, 2., 1),
              12.,
              1e-9);
  EXPECT_NEAR(derivative([](const double t) { return 3. * t * t; }, 2., 2),
              6.,
              1e-7);
  EXPECT_EQ(derivative([](const double) { return 7.; }, 2., 2), 0.);
}



TEST(NumericalDerivative, IsNoNumberWhereTheFunctionIsNone)
{
  EXPECT_TRUE(
    std::isnan(derivative([](const double t) { return std::sqrt(t); }, 0., 2)));
  // Far enough from there short differences are left.
  EXPECT_NEAR(derivative([](const double t) { return std::sqrt(t); }, .05, 1),
              .5 / std::sqrt(.05),
              1e-8);
}



TEST(NumericalIntegral, OfASine)
{
  for (const double end : {0., .5, 20., 300.})
    EXPECT_NEAR(integral([](const double t) { return std::sin(5. * t); },
                         0.,
                         end),
                (1. - std::cos(5. * end)) / 5.,
                1e-11 * std::max(1., end));
}
