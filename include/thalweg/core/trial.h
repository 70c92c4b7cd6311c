// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_trial_h
#define thalweg_core_trial_h

#include <functional>
#include <string>

namespace Thalweg
{
  /// What a trial may take.
  struct TrialLimits
  {
    unsigned int seconds   = 6; ///< of a processor
    double       gigabytes = 1.5;
  };

  /**
   * @brief Does @p work in a process of its own, which vanishes with all that
   * was made; what crashes, or does not end, does no harm.
   *
   * For functions of libraries that trust in what they are given. Nothing in
   * @p work may communicate.
   * @return what was wrong: the message of an exception, or that the limits
   *   were exceeded, or how it crashed; empty: nothing
   */
  std::string
  fault_in_trial(const std::function<void()> &work,
                 const TrialLimits           &limits = {});
} // namespace Thalweg

#endif
