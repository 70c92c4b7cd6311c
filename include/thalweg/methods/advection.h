// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_advection_h
#define thalweg_methods_advection_h

#include <thalweg/methods/flow_method.h>

#include <deal.II/base/function_parser.h>

namespace Thalweg
{
  /**
   * @brief Particles and interface in a prescribed velocity field, to
   * measure convection alone.
   */
  template <int dim>
  class Advection : public FlowMethod<dim>
  {
  public:
    Advection();

    void
    declare_parameters(const Section &section) override;

    void
    update() override;

    void
    advance(const double time, const double dt) override;

    StepNumbers
    step_numbers() const override
    {
      return numbers->of(convecting_velocity);
    }

  private:
    using FlowMethod<dim>::parts;

    void
    check_parameters() const override;

    void
    attach_fields() override;

    void
    initialize_fields(const typename InterfaceFlow<dim>::Start &start) override;

    void
    keep_fields(const State<dim> &state) override;

    void
    repopulate_cells() override;

    const CellVelocity<dim> &
    convecting_velocity_of_cells() const override
    {
      return cell_velocity;
    }

    std::unique_ptr<dealii::FunctionParser<dim>>
    parse() const;

    /// Interpolates the expression at @p time to the nodes.
    void
    set_velocity(const double time);

    std::string                                  expression;
    std::unique_ptr<dealii::FunctionParser<dim>> function;
    std::unique_ptr<FlowStepNumbers<dim>>        numbers;
    Vector                                       convecting_velocity;
    Vector                                       projected_velocity;
    Vector                                       level_set;
    CellVelocity<dim>                            cell_velocity;
    CellField<dim, 1>                            cell_level_set;
  };
} // namespace Thalweg

#endif
