// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_advection_h
#define thalweg_methods_advection_h

#include <thalweg/methods/flow_step_numbers.h>
#include <thalweg/methods/method.h>

#include <deal.II/base/function_parser.h>

namespace Thalweg
{
  /**
   * @brief Particles and interface in a prescribed velocity field, to
   * measure convection alone.
   */
  template <int dim>
  class Advection : public Method<dim>
  {
  public:
    void
    declare_parameters(const Section &section) override;

    void
    check() const override;

    bool
    computes_flow() const override
    {
      return false;
    }

    void
    attach(const Parts<dim> &parts) override;

    void
    initialize(const dealii::Function<dim> &velocity,
               const Vector                &initial_velocity,
               const Vector                &initial_level_set) override;

    void
    keep(const State<dim> &state) override;

    void
    update() override;

    void
    repopulate() override;

    void
    advance(const double time, const double dt) override;

    StepNumbers
    step_numbers() const override
    {
      return numbers->of(convecting_velocity);
    }

    std::string
    headline() const override
    {
      return count_particles(*parts);
    }

  private:
    std::unique_ptr<dealii::FunctionParser<dim>>
    parse() const;

    /// Interpolates the expression at @p time to the nodes.
    void
    set_velocity(const double time);

    std::string                                  expression;
    std::unique_ptr<dealii::FunctionParser<dim>> function;
    std::unique_ptr<Parts<dim>>                  parts;
    std::unique_ptr<FlowStepNumbers<dim>>        numbers;
    Vector                                       convecting_velocity;
    Vector                                       projected_velocity;
    Vector                                       level_set;
    CellVelocity<dim>                            cell_velocity;
    CellField<dim, 1>                            cell_level_set;
  };
} // namespace Thalweg

#endif
