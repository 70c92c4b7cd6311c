// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_spline_h
#define thalweg_fields_spline_h

#include <vector>

namespace Thalweg
{
  /**
   * @brief A cubic spline through given values: its second derivative is
   * continuous, and its third one, too, at the second and the last but one
   * point ("not a knot"), so that a cubic polynomial is reproduced.
   *
   * Three points make a parabola, two a straight line.
   */
  class Spline
  {
  public:
    /// @param t increasing @param values of the same length, at least two
    Spline(const std::vector<double> &t, const std::vector<double> &values);

    /// The value (@p order 0), or the first or second derivative; outside of
    /// the points the nearest polynomial goes on.
    double
    evaluate(const double t, const unsigned int order) const;

  private:
    void
    find_curvatures();

    std::vector<double> t, values;
    std::vector<double> curvatures; ///< the second derivatives
  };
} // namespace Thalweg

#endif
