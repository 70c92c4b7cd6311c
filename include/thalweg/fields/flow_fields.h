// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_flow_fields_h
#define thalweg_fields_flow_fields_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace Thalweg
{
  /**
   * @brief The flow of a single fluid in the finite element spaces in which
   * it was computed, whatever their degree, for those who only look.
   *
   * Vectors are ghosted and consistent with their constraints.
   */
  template <int dim>
  struct FlowFields
  {
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    /// Of the cells as the flow sees them, with curved boundaries.
    const dealii::Mapping<dim> &mapping;
    /// FESystem of dim FE_Q.
    const dealii::DoFHandler<dim> &velocity_dofs;
    /// FE_Q.
    const dealii::DoFHandler<dim> &pressure_dofs;
    const Vector                  &velocity; ///< m/s
    const Vector                  &pressure; ///< Pa
    /**
     * The force of the fluid on each boundary degree of freedom whose
     * velocity is fixed, in N (N/m in 2D): the residual of the momentum
     * equation with its test function. Summed over the nodes of a body it is
     * the force on the body, one order more accurate than an integral of
     * stresses. Zero elsewhere. nullptr or empty: not known.
     */
    const Vector *reaction;
    /**
     * The viscous force of the fluid per area at these nodes, in Pa: what
     * the reaction has beyond that of the pressure, over the node's part of
     * the boundary. One order more accurate than the stress of linear
     * elements at the boundary, which is that in the middle of a cell.
     * nullptr or empty: not known.
     */
    const Vector *traction;
    double        density;       ///< kg/m^3
    double        viscosity;     ///< Pa s
    double        pressure_time; ///< s; the middle of the last step
  };
} // namespace Thalweg

#endif
