// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_vertical_line_h
#define thalweg_postprocess_vertical_line_h

#include <thalweg/methods/flow_view.h>

#include <deal.II/base/point.h>

namespace Thalweg
{
  /// What a line parallel to an axis meets.
  struct LineContent
  {
    double wet_length = 0.;     ///< in fluid 0, m
    double top        = -1e300; ///< greatest coordinate in fluid 0, m
    double length     = 0.;     ///< within the mesh, m
  };

  /**
   * @brief Cuts the level set along the line through @p point parallel to
   * @p axis. Collective.
   *
   * Exact for the piecewise linear level set of SimplexCut. A line in faces
   * between cells is moved aside by a billionth of the mesh, towards the
   * side where the mesh is, so that no cell counts twice.
   */
  template <int dim>
  LineContent
  cut_line(const FlowView<dim>      &solution,
           const dealii::Point<dim> &point,
           const unsigned int        axis);

  /// Whether the line through @p point parallel to @p axis meets the mesh.
  /// Collective.
  template <int dim>
  bool
  meets_line(const Mesh<dim>          &mesh,
             const dealii::Point<dim> &point,
             const unsigned int        axis);
} // namespace Thalweg

#endif
