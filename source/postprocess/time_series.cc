// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/time_series.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace Thalweg
{
  namespace TimeSeries
  {
    namespace
    {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();


      /// Half of the time between a record's neighbours; ones where no time
      /// passes.
      std::vector<double>
      weights(const std::vector<double> &times)
      {
        std::vector<double> result(times.size(), 0.);
        if (times.empty() || times.back() <= times.front())
          return std::vector<double>(times.size(), 1.);
        for (std::size_t i = 0; i + 1 < times.size(); ++i)
          {
            result[i] += .5 * (times[i + 1] - times[i]);
            result[i + 1] += .5 * (times[i + 1] - times[i]);
          }
        return result;
      }


      /// Whether there is more than round-off around the mean.
      bool
      fluctuates(const Summary &summary)
      {
        return summary.rms > 1e-12 * std::max(std::abs(summary.minimum),
                                              std::abs(summary.maximum));
      }


      /// The Fourier transform of 2^n values.
      void
      transform(std::vector<std::complex<double>> &values)
      {
        const std::size_t n = values.size();
        for (std::size_t i = 1, reversed = 0; i < n; ++i)
          {
            std::size_t bit = n >> 1;
            for (; reversed & bit; bit >>= 1)
              reversed ^= bit;
            reversed ^= bit;
            if (i < reversed)
              std::swap(values[i], values[reversed]);
          }
        for (std::size_t length = 2; length <= n; length *= 2)
          for (std::size_t k = 0; k < length / 2; ++k)
            {
              const std::complex<double> factor =
                std::polar(1., -2. * dealii::numbers::PI * k / length);
              for (std::size_t i = k; i < n; i += length)
                {
                  const std::complex<double> odd =
                    factor * values[i + length / 2];
                  values[i + length / 2] = values[i] - odd;
                  values[i] += odd;
                }
            }
      }


      /// @p n values at equidistant times, without the mean, in a window
      /// that is zero at both ends; then zeros up to @p n_padded.
      std::vector<std::complex<double>>
      windowed_samples(const std::vector<double> &times,
                       const std::vector<double> &values,
                       const std::size_t          n,
                       const std::size_t          n_padded)
      {
        const double mean = summarize(times, values).mean;
        const double step = (times.back() - times.front()) / n;
        std::vector<std::complex<double>> samples(n_padded);
        for (std::size_t i = 0, left = 0; i < n; ++i)
          {
            const double time = times.front() + i * step;
            while (left + 2 < times.size() && times[left + 1] <= time)
              ++left;
            const double part =
              (time - times[left]) / (times[left + 1] - times[left]);
            const double window =
              .5 - .5 * std::cos(2. * dealii::numbers::PI * i / n);
            samples[i] = window * ((1. - part) * values[left] +
                                   part * values[left + 1] - mean);
          }
        return samples;
      }
    } // namespace


    Summary
    summarize(const std::vector<double> &times,
              const std::vector<double> &values)
    {
      AssertDimension(times.size(), values.size());
      if (values.empty())
        return {nan, nan, nan, nan};
      const std::vector<double> weight = weights(times);
      double                    total = 0., mean = 0., square = 0.;
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          total += weight[i];
          mean += weight[i] * values[i];
        }
      mean /= total;
      for (std::size_t i = 0; i < values.size(); ++i)
        square += weight[i] * (values[i] - mean) * (values[i] - mean);
      return {mean,
              *std::min_element(values.begin(), values.end()),
              *std::max_element(values.begin(), values.end()),
              std::sqrt(square / total)};
    }


    std::vector<double>
    upward_crossings(const std::vector<double> &times,
                     const std::vector<double> &values)
    {
      const Summary       summary = summarize(times, values);
      const double        margin  = .1 * summary.rms;
      std::vector<double> crossings;
      if (!fluctuates(summary))
        return crossings;
      bool   was_below = false;
      double candidate = nan;
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          const double now = values[i] - summary.mean;
          if (now < -margin)
            was_below = true;
          if (i > 0)
            {
              const double before = values[i - 1] - summary.mean;
              if (before < 0. && now >= 0.)
                candidate = times[i - 1] +
                            (times[i] - times[i - 1]) * before / (before - now);
            }
          if (was_below && now > margin)
            {
              crossings.push_back(candidate);
              was_below = false;
            }
        }
      return crossings;
    }


    double
    crossing_frequency(const std::vector<double> &crossings)
    {
      if (crossings.size() < 2)
        return nan;
      return (crossings.size() - 1) / (crossings.back() - crossings.front());
    }


    double
    spectral_peak(const std::vector<double> &times,
                  const std::vector<double> &values)
    {
      AssertDimension(times.size(), values.size());
      if (times.size() < 8 || !fluctuates(summarize(times, values)))
        return nan;
      std::size_t n = 8;
      while (n < times.size() && n < (1u << 17))
        n *= 2;
      // Zeros behind the samples make the spectrum dense enough for a
      // parabola to find its peak to a thousandth of the resolution.
      const std::size_t padding = 4;
      auto samples = windowed_samples(times, values, n, padding * n);
      transform(samples);

      std::vector<double> logarithm(padding * n / 2);
      for (std::size_t k = 0; k < logarithm.size(); ++k)
        logarithm[k] = std::log(std::max(std::abs(samples[k]), 1e-300));
      // Below one period in the whole time stands what the window makes of
      // the mean.
      const auto        first = logarithm.begin() + padding;
      const std::size_t peak =
        std::max_element(first, logarithm.end() - 1) - logarithm.begin();
      const double left = logarithm[peak - 1], right = logarithm[peak + 1];
      const double curvature = left - 2. * logarithm[peak] + right;
      const double shift =
        curvature < 0. ? .5 * (left - right) / curvature : 0.;
      return (peak + shift) / (padding * (times.back() - times.front()));
    }
  } // namespace TimeSeries
} // namespace Thalweg
