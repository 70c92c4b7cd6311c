// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_phase_extent_h
#define thalweg_postprocess_phase_extent_h

#include <thalweg/methods/flow_view.h>

#include <limits>

namespace Thalweg
{
  /// The part of space between two planes that are normal to an axis.
  struct Band
  {
    unsigned int axis  = 0;
    double       lower = -std::numeric_limits<double>::max();
    double       upper = std::numeric_limits<double>::max();
  };

  /**
   * @brief How far fluid 0 reaches along an axis, in m. Collective.
   *
   * Exact for the piecewise linear level set of SimplexCut, also where the
   * band cuts through cells or is a plane (lower = upper).
   *
   * @param solution the state
   * @param axis the direction
   * @param sign 1 for the greatest coordinate, -1 for the least
   * @param band what lies outside does not count
   * @return not-a-number if there is no fluid 0 in the band
   */
  template <int dim>
  double
  phase_extent(const FlowView<dim> &solution,
               const unsigned int   axis,
               const double         sign,
               const Band          &band);
} // namespace Thalweg

#endif
