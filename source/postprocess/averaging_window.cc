// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/averaging_window.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  void
  AveragingWindow::declare_parameters(const Section &section)
  {
    section.add("Average from",
                from,
                "s",
                "When averaging begins: after the flow has developed.");
    section.add("Average until",
                until,
                "s",
                "When averaging ends, if not at the end of the run.");
  }


  void
  AveragingWindow::check(const std::string &what) const
  {
    AssertThrow(from < until,
                dealii::ExcMessage("'Average until' of '" + what +
                                   "' must be later than 'Average from'."));
  }


  bool
  AveragingWindow::contains(const double time) const
  {
    // Times that are sums of steps miss a bound by round-off.
    const double tolerance = 1e-9 * std::abs(time);
    return time >= from - tolerance && time <= until + tolerance;
  }


  double
  AveragingWindow::overlap(const double time, const double time_step) const
  {
    const double part =
      std::min(time, until) - std::max(time - time_step, from);
    return part > 1e-9 * time_step ? part : 0.;
  }
} // namespace Thalweg
