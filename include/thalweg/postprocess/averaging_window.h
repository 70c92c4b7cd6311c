// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_averaging_window_h
#define thalweg_postprocess_averaging_window_h

#include <thalweg/core/section.h>

#include <string>

namespace Thalweg
{
  /// The time over which something is averaged.
  class AveragingWindow
  {
  public:
    /// Declares "Average from" and "Average until".
    void
    declare_parameters(const Section &section);

    /// @throws dealii::ExcMessage if it ends before it begins
    /// @param what the postprocessor's name
    void
    check(const std::string &what) const;

    bool
    contains(const double time) const;

    /// How much of the step that ends at @p time is in the window, in s.
    double
    overlap(const double time, const double time_step) const;

  private:
    double from  = 0.;
    double until = 1e30;
  };
} // namespace Thalweg

#endif
