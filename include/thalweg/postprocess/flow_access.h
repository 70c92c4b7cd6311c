// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_flow_access_h
#define thalweg_postprocess_flow_access_h

#include <thalweg/methods/flow_view.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The flow in the method's own spaces or, where it has none, by its
   * values at the vertices of straight cells, so that nobody needs to know
   * the difference.
   *
   * In the second case density and viscosity are those of the first fluid,
   * and there is neither reaction nor traction.
   */
  template <int dim>
  FlowFields<dim>
  flow_of(const FlowView<dim> &solution);

  /// Whether forces by the residual of the momentum equation are available.
  template <int dim>
  bool
  has_reaction(const FlowFields<dim> &flow)
  {
    return flow.reaction != nullptr && flow.reaction->size() > 0;
  }

  /// Whether viscous forces at the boundary's nodes are available.
  template <int dim>
  bool
  has_traction(const FlowFields<dim> &flow)
  {
    return flow.traction != nullptr && flow.traction->size() > 0;
  }

  /// The flow at a point.
  template <int dim>
  struct PointValue
  {
    double                 pressure = 0.; ///< Pa
    dealii::Tensor<1, dim> velocity;      ///< m/s
  };

  /**
   * @brief Velocity and pressure at @p points, the same on all processes.
   * Collective.
   *
   * With curved cells, points beyond the boundary by less than a twentieth
   * of a cell count as points on it, since polynomials do not follow a
   * circle exactly.
   * @throws dealii::ExcMessage on all processes for points outside the
   *   mesh; @p what begins the message, as in "The point probe"
   */
  template <int dim>
  std::vector<PointValue<dim>>
  evaluate_at(const FlowView<dim>                   &solution,
              const std::vector<dealii::Point<dim>> &points,
              const std::string                     &what);

  /// @throws dealii::ExcMessage on all processes for points that lie outside
  /// the mesh whether its cells are curved or not. Collective.
  template <int dim>
  void
  check_points(const Mesh<dim>                       &mesh,
               const std::vector<dealii::Point<dim>> &points,
               const std::string                     &what);
} // namespace Thalweg

#endif
