// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_surface_chain_h
#define thalweg_postprocess_surface_chain_h

#include <deal.II/base/point.h>

#include <vector>

namespace Thalweg
{
  /// A piece of a line in the plane, in the direction in which it is passed.
  struct Segment
  {
    dealii::Point<2> begin;
    dealii::Point<2> end;
  };

  /**
   * @brief Strings segments together where one begins at another's end.
   *
   * Open chains come first, ordered by the x coordinate (then y) where they
   * begin; closed ones follow, each from the point with the greatest x (then
   * the least y), which is the trailing edge of an airfoil.
   * @return the numbers of the segments of each chain
   */
  std::vector<std::vector<std::size_t>>
  chain(const std::vector<Segment> &segments);
} // namespace Thalweg

#endif
