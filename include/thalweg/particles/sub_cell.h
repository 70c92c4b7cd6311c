// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_sub_cell_h
#define thalweg_particles_sub_cell_h

#include <thalweg/core/compat_weights.h>
#include <thalweg/mesh/cell_graph.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  /// Differences of reference coordinates that say nothing: decisions must
  /// not depend on them, else runs on other numbers of ranks, which differ by
  /// round-off, part ways where particles stand symmetrically.
  constexpr double reference_round_off = 1e-6;

  /// A reference coordinate in units of what can be told apart.
  inline long
  rounded(const double coordinate)
  {
    return std::lround(coordinate / reference_round_off);
  }

  /// A total order of points that does not see round-off.
  template <int dim>
  bool
  stands_before(const dealii::Point<dim> &a, const dealii::Point<dim> &b)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (const long i = rounded(a[d]), j = rounded(b[d]); i != j)
        return i < j;
    return false;
  }

  /// Which of the 2^dim halves of the reference cell @p reference lies in,
  /// numbered as the cell's children are.
  template <int dim>
  unsigned int
  sub_cell(const dealii::Point<dim> &reference)
  {
    unsigned int index = 0;
    for (unsigned int d = 0; d < dim; ++d)
      index += (reference[d] >= .5 - reference_round_off ? 1u : 0u) << d;
    return index;
  }

  /// The coordinates in the child that covers a point of its parent.
  template <int dim>
  inline dealii::Point<dim>
  from_parent(const dealii::Point<dim> &reference, const unsigned int child)
  {
    auto inside =
      dealii::GeometryInfo<dim>::cell_to_child_coordinates(reference, child);
    for (unsigned int d = 0; d < dim; ++d)
      inside[d] = std::max(0., inside[d]);
    return inside;
  }

  /// The coordinates of a child's point in its parent.
  template <int dim>
  inline dealii::Point<dim>
  to_parent(const dealii::Point<dim> &reference, const unsigned int child)
  {
    return dealii::GeometryInfo<dim>::child_to_cell_coordinates(reference,
                                                                child);
  }

  /**
   * @brief The owned cell where something is that came along with a cell, see
   * Carried::unpack(): that cell, or one of its children.
   * @param reference its coordinates, then in the cell that is returned
   */
  template <int dim, typename CellIterator>
  unsigned int
  find_cell_after(const CellGraph<dim>  &graph,
                  const CellIterator    &cell,
                  const Compat::CellFate fate,
                  dealii::Point<dim>    &reference)
  {
    if (fate != Compat::CellFate::is_refined)
      return graph.index(cell);
    const unsigned int child = sub_cell<dim>(reference);
    reference                = from_parent<dim>(reference, child);
    return graph.index(cell->child(child));
  }
} // namespace Thalweg

#endif
