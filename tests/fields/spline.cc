// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/spline.h>

#include <cmath>
#include <gtest/gtest.h>

using Thalweg::Spline;



TEST(Spline, ReproducesCubicPolynomials)
{
  const auto f = [](const double t) { return 1. + t * (2. + t * (3. - t)); };
  const std::vector<double> t{0., .4, .5, 1.3, 2.};
  std::vector<double>       values;
  values.reserve(t.size());
  for (const double s : t)
    values.push_back(f(s));
  const Spline spline(t, values);
  for (const double s : {-.1, 0., .2, .45, 1., 1.9, 2., 2.1})
    {
      EXPECT_NEAR(spline.evaluate(s, 0), f(s), 1e-12);
      EXPECT_NEAR(spline.evaluate(s, 1), 2. + s * (6. - 3. * s), 1e-12);
      EXPECT_NEAR(spline.evaluate(s, 2), 6. - 6. * s, 1e-11);
    }
}



TEST(Spline, OfTwoAndThreePoints)
{
  const Spline line({0., 2.}, {1., 5.});
  EXPECT_NEAR(line.evaluate(.5, 0), 2., 1e-14);
  EXPECT_NEAR(line.evaluate(.5, 1), 2., 1e-14);
  EXPECT_EQ(line.evaluate(.5, 2), 0.);
  const Spline parabola({0., 1., 3.}, {0., 1., 9.});
  EXPECT_NEAR(parabola.evaluate(2., 0), 4., 1e-13);
  EXPECT_NEAR(parabola.evaluate(2., 2), 2., 1e-13);
}



TEST(Spline, SecondDerivativesConvergeUpToTheEnds)
{
  double errors[2];
  for (unsigned int k = 0; k < 2; ++k)
    {
      const unsigned int  n = 20 << k;
      std::vector<double> t, values;
      for (unsigned int i = 0; i <= n; ++i)
        {
          t.push_back(3. * i / n);
          values.push_back(std::cos(2. * t.back()));
        }
      const Spline spline(t, values);
      errors[k] = 0.;
      for (double s = 0.; s <= 3.; s += .01)
        errors[k] =
          std::max(errors[k],
                   std::abs(spline.evaluate(s, 2) + 4. * std::cos(2. * s)));
    }
  EXPECT_LT(errors[1], errors[0] / 3.5);
  // h^2 times the fourth derivative
  EXPECT_LT(errors[1], std::pow(3. / 40., 2) * 16.);
}
