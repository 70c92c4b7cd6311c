// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_round_off_h
#define thalweg_mesh_round_off_h

#include <thalweg/mesh/cell_graph.h>

#include <cmath>

namespace Thalweg
{
  /// A distance at @p x that says nothing, m, where edges are as long as
  /// @p length.
  template <int dim>
  inline double
  negligible_distance(const double length, const dealii::Point<dim> &x)
  {
    constexpr double part = 1e-9;
    return part * length + coordinate_round_off(x);
  }



  /**
   * @brief A level set's value at a point, zero where it is nothing but
   * round-off: an interface that was put through a node or a particle passes
   * through it. Else the digits of the place and the library's order of sums
   * decided on which side it is.
   * @param value about a distance, m
   * @param length of edges near the point, m
   * @param x the point
   */
  template <int dim>
  inline double
  without_round_off(const double              value,
                    const double              length,
                    const dealii::Point<dim> &x)
  {
    return std::abs(value) <= negligible_distance(length, x) ? 0. : value;
  }
} // namespace Thalweg

#endif
