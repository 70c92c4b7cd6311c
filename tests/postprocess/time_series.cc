// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/time_series.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
  using namespace Thalweg::TimeSeries;

  /// A function at unequal times between 0 and @p end.
  struct Series
  {
    Series(const std::function<double(const double)> &function,
           const double                               end,
           const unsigned int                         n)
    {
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double part = double(i) / n;
          times.push_back(
            end *
            (part + .1 / (2. * dealii::numbers::PI) *
                      std::sin(2. * dealii::numbers::PI * 3. * part) / 3.));
          values.push_back(function(times.back()));
        }
    }

    std::vector<double> times, values;
  };

  /// 3 + 2 sin(2 pi 0.7 t + 0.3)
  double
  wave(const double t)
  {
    return 3. + 2. * std::sin(2. * dealii::numbers::PI * .7 * t + .3);
  }
} // namespace


TEST(TimeSeries, SummaryOfASineWithOffsetAndUnequalSteps)
{
  // Seven whole periods.
  const Series  series(wave, 10., 2000);
  const Summary summary = summarize(series.times, series.values);
  EXPECT_NEAR(summary.mean, 3., 1e-4);
  EXPECT_NEAR(summary.rms, std::sqrt(2.), 1e-4);
  EXPECT_NEAR(summary.minimum, 1., 1e-3);
  EXPECT_NEAR(summary.maximum, 5., 1e-3);
}


TEST(TimeSeries, LongStepsCountMore)
{
  // Linear: the trapezoidal rule is exact.
  const Summary summary = summarize({0., 1., 4.}, {0., 2., 8.});
  EXPECT_NEAR(summary.mean, 4., 1e-14);
  EXPECT_NEAR(summarize({2.}, {7.}).mean, 7., 0.);
  EXPECT_TRUE(std::isnan(summarize({}, {}).mean));
}


TEST(TimeSeries, FrequencyOfASineByZeroCrossings)
{
  const Series series(wave, 10.9, 1500);
  const auto   crossings = upward_crossings(series.times, series.values);
  // At (k - 0.3 / (2 pi)) / 0.7 s for k = 1 ... 7.
  ASSERT_EQ(crossings.size(), 7u);
  EXPECT_NEAR(crossing_frequency(crossings), .7, 1e-4);
}


TEST(TimeSeries, NoiseNearTheMeanMakesNoPeriods)
{
  const auto noisy = [](const double t) {
    return wave(t) + .05 * std::sin(2. * dealii::numbers::PI * 61. * t);
  };
  const Series series(noisy, 10., 8000);
  const auto   crossings = upward_crossings(series.times, series.values);
  ASSERT_EQ(crossings.size(), 7u);
  EXPECT_NEAR(crossing_frequency(crossings), .7, 5e-3);
}


TEST(TimeSeries, FrequencyOfASineBySpectrum)
{
  // Neither whole periods nor a power of two of records.
  for (const double end : {6.1, 10., 17.3})
    {
      const Series series(wave, end, 900);
      EXPECT_NEAR(spectral_peak(series.times, series.values), .7, .01 / end);
    }
}


TEST(TimeSeries, SpectrumFindsTheStrongerOfTwoWaves)
{
  const auto two = [](const double t) {
    return wave(t) + 1.2 * std::sin(2. * dealii::numbers::PI * 2.9 * t);
  };
  const Series series(two, 20., 1200);
  EXPECT_NEAR(spectral_peak(series.times, series.values), .7, 1e-3);
}


TEST(TimeSeries, ConstantsHaveNoFrequency)
{
  const Series series([](const double) { return 4.; }, 1., 20);
  const auto   crossings = upward_crossings(series.times, series.values);
  EXPECT_TRUE(crossings.empty());
  EXPECT_TRUE(std::isnan(crossing_frequency(crossings)));
  EXPECT_TRUE(std::isnan(spectral_peak(series.times, series.values)));
}
