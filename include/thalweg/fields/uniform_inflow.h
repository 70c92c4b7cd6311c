// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_uniform_inflow_h
#define thalweg_fields_uniform_inflow_h

#include <thalweg/mesh/mesh.h>

#include <deal.II/base/function.h>
#include <deal.II/base/function_parser.h>

#include <memory>

namespace Thalweg
{
  /**
   * @brief The integral of the outward normal over a boundary, in m^(dim-1).
   *
   * Its length is the area of a plane boundary. It depends on the boundary's
   * rim alone, so that refinement within a curved one does not change it.
   * Collective.
   */
  template <int dim>
  dealii::Tensor<1, dim>
  vector_area(const Mesh<dim> &mesh, const dealii::types::boundary_id boundary);

  /// The area of a boundary, in m^(dim-1). Collective.
  template <int dim>
  double
  scalar_area(const Mesh<dim> &mesh, const dealii::types::boundary_id boundary);

  /**
   * @brief The uniform velocity with which a flow rate comes in through a
   * boundary, in the direction of the boundary's mean normal.
   *
   * V = -Q A / |A|^2 with the vector area A: its flux is Q whatever the shape
   * of the boundary.
   */
  template <int dim>
  class UniformInflow : public dealii::Function<dim>
  {
  public:
    /**
     * @param flow_rate into the domain, m^dim/s, a function of time; of its
     *   place only the time is looked at
     * @param area vector_area() of the boundary, not zero
     */
    UniformInflow(std::unique_ptr<dealii::FunctionParser<dim>> flow_rate,
                  const dealii::Tensor<1, dim>                &area);

    void
    set_time(const double time) override;

    double
    value(const dealii::Point<dim> &x,
          const unsigned int        component = 0) const override;

    void
    vector_value(const dealii::Point<dim> &x,
                 dealii::Vector<double>   &values) const override;

  private:
    const std::unique_ptr<dealii::FunctionParser<dim>> flow_rate;
    /// The velocity of a flow rate of one, 1/m^(dim-1).
    const dealii::Tensor<1, dim> direction;
  };
} // namespace Thalweg

#endif
