// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/spline.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Thalweg
{
  Spline::Spline(const std::vector<double> &t,
                 const std::vector<double> &values)
    : t(t)
    , values(values)
    , curvatures(t.size(), 0.)
  {
    AssertDimension(t.size(), values.size());
    Assert(t.size() > 1, dealii::ExcInternalError());
    if (t.size() > 2)
      find_curvatures();
  }



  void
  Spline::find_curvatures()
  {
    const unsigned int  n = t.size() - 1;
    std::vector<double> h(n), slope(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        h[i]     = t[i + 1] - t[i];
        slope[i] = (values[i + 1] - values[i]) / h[i];
      }
    if (n == 2)
      {
        std::fill(curvatures.begin(),
                  curvatures.end(),
                  2. * (slope[1] - slope[0]) / (h[0] + h[1]));
        return;
      }
    // The first and the last curvature follow from their neighbours.
    const double        begin = h[0] / h[1], end = h[n - 1] / h[n - 2];
    std::vector<double> diagonal(n), upper(n), right(n);
    for (unsigned int i = 1; i < n; ++i)
      {
        double lower = h[i - 1];
        diagonal[i]  = 2. * (h[i - 1] + h[i]);
        upper[i]     = h[i];
        right[i]     = 6. * (slope[i] - slope[i - 1]);
        if (i == 1)
          {
            diagonal[i] += h[0] * (1. + begin);
            upper[i] -= h[0] * begin;
          }
        if (i == n - 1)
          {
            diagonal[i] += h[n - 1] * (1. + end);
            lower -= h[n - 1] * end;
          }
        if (i > 1)
          {
            const double factor = lower / diagonal[i - 1];
            diagonal[i] -= factor * upper[i - 1];
            right[i] -= factor * right[i - 1];
          }
      }
    for (unsigned int i = n - 1; i > 0; --i)
      curvatures[i] =
        (right[i] - (i < n - 1 ? upper[i] * curvatures[i + 1] : 0.)) /
        diagonal[i];
    curvatures[0] = (1. + begin) * curvatures[1] - begin * curvatures[2];
    curvatures[n] = (1. + end) * curvatures[n - 1] - end * curvatures[n - 2];
  }



  double
  Spline::evaluate(const double at, const unsigned int order) const
  {
    const auto         right = std::upper_bound(t.begin(), t.end() - 1, at);
    const unsigned int i     = right == t.begin() ? 0 : right - t.begin() - 1;
    const unsigned int k     = std::min<unsigned int>(i, t.size() - 2);
    const double       h = t[k + 1] - t[k], s = at - t[k];
    const double       c0 = curvatures[k], c1 = curvatures[k + 1];
    const double       slope =
      (values[k + 1] - values[k]) / h - h * (2. * c0 + c1) / 6.;
    const double third = (c1 - c0) / h;
    if (order == 0)
      return values[k] + s * (slope + s * (.5 * c0 + s * third / 6.));
    return order == 1 ? slope + s * (c0 + .5 * s * third) : c0 + s * third;
  }
} // namespace Thalweg
