// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_time_series_h
#define thalweg_postprocess_time_series_h

#include <vector>

namespace Thalweg
{
  /**
   * @brief What can be said of a quantity that was recorded at increasing,
   * not necessarily equidistant times.
   *
   * Pure functions; @p times (in s) and @p values have one entry a record.
   */
  namespace TimeSeries
  {
    /// Not-a-number without any value.
    struct Summary
    {
      double mean;
      double minimum;
      double maximum;
      double rms; ///< of the difference from the mean
    };

    /// The mean and the fluctuations with the weights of the trapezoidal
    /// rule, so that short steps do not count as much as long ones.
    Summary
    summarize(const std::vector<double> &times,
              const std::vector<double> &values);

    /**
     * @brief The times when the series rises through its mean, interpolated
     * linearly between records.
     *
     * A rise counts when the series was below the mean by a tenth of the rms
     * of its fluctuations before and gets above it by as much, so that noise
     * near the mean does not make periods.
     */
    std::vector<double>
    upward_crossings(const std::vector<double> &times,
                     const std::vector<double> &values);

    /// The frequency in Hz, the inverse of the mean period between the first
    /// and the last of these @p crossings; not-a-number if there is no period.
    double
    crossing_frequency(const std::vector<double> &crossings);

    /**
     * @brief The frequency in Hz at which the amplitude of the discrete
     * Fourier spectrum is greatest.
     *
     * The series is interpolated at equidistant times, freed from its mean
     * and weighted by a Hann window; the peak is that of a parabola through
     * the logarithms of the three greatest amplitudes beside each other.
     * @return not-a-number for fewer than eight records or a constant series
     */
    double
    spectral_peak(const std::vector<double> &times,
                  const std::vector<double> &values);
  } // namespace TimeSeries
} // namespace Thalweg

#endif
