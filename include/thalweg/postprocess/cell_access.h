// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_cell_access_h
#define thalweg_postprocess_cell_access_h

#include <thalweg/methods/flow_view.h>

#include <deal.II/base/point.h>
#include <deal.II/fe/mapping.h>

#include <array>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The names of the axes for a pattern, "x|y" or "x|y|z".
  template <int dim>
  constexpr const char *axis_names = dim == 2 ? "x|y" : "x|y|z";

  /// The number of the axis "x", "y" or "z", a sign before it is skipped.
  inline unsigned int
  axis_number(const std::string &name)
  {
    return name.back() - 'x';
  }

  /// The unit of a length to the power @p exponent, as in "m^3".
  std::string
  length_unit(const unsigned int exponent);

  /// The level set at the vertices of a cell of the graph; negative
  /// everywhere in a run with a single fluid.
  template <int dim>
  std::array<double, (1 << dim)>
  cell_level_set(const FlowView<dim> &solution, const unsigned int cell);

  /// A point in a locally owned cell.
  template <int dim>
  struct LocatedPoint
  {
    /// Whether this process owns the point's cell: exactly one does.
    bool               is_here = false;
    unsigned int       cell    = 0;
    dealii::Point<dim> xi;
  };

  /**
   * @brief Finds the cells of @p points; on faces between cells the one with
   * the least global number has it. Collective.
   * @throws dealii::ExcMessage on all processes for points outside the
   *   mesh; @p what begins the message, as in "The point probe"
   */
  template <int dim>
  std::vector<LocatedPoint<dim>>
  locate(const Mesh<dim>                       &mesh,
         const std::vector<dealii::Point<dim>> &points,
         const std::string                     &what);

  /**
   * @brief The same for cells as @p mapping sees them, and for points that
   * lie outside by up to @p tolerance (in reference coordinates) of the
   * nearest cell: they are moved to its side.
   */
  template <int dim>
  std::vector<LocatedPoint<dim>>
  locate(const Mesh<dim>                       &mesh,
         const dealii::Mapping<dim>            &mapping,
         const std::vector<dealii::Point<dim>> &points,
         const std::string                     &what,
         const double                           tolerance);

  /**
   * @brief Refuses an interval along an axis that the mesh does not reach.
   * Collective.
   * @param from, to, in m
   * @param what begins the message, as in "The 'Band' of the front position"
   * @throws dealii::ExcMessage on all processes
   */
  template <int dim>
  void
  check_reach(const Mesh<dim>   &mesh,
              const unsigned int axis,
              const double       from,
              const double       to,
              const std::string &what);
} // namespace Thalweg

#endif
