// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fluid/body_forces.h>

#include <deal.II/lac/vector.h>

namespace Thalweg
{
  template <int dim>
  void
  BodyForces<dim>::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Body forces");
    section.add("Gravity",
                gravity_components,
                "m/s^2",
                "The acceleration, a component for each direction.",
                dealii::Patterns::List(dealii::Patterns::Double(), dim, dim));
    section.add("Acceleration",
                acceleration_expression,
                "m/s^2",
                "An acceleration besides gravity, on each fluid with its "
                "density: a function of x, y, z and t with a semicolon "
                "between the components. Empty: none.",
                dealii::Patterns::Anything());
    section.add("Force density",
                density_expression,
                "N/m^3",
                "A force per volume that is the same on every fluid, for "
                "example minus a mean pressure gradient; in closed tanks "
                "pressure balances it where it has a potential: a function of "
                "x, y, z and t with a "
                "semicolon between the components. Empty: none.",
                dealii::Patterns::Anything());
    frame_.declare_parameters(root);
  }



  template <int dim>
  void
  BodyForces<dim>::check(const double end) const
  {
    BodyForces trial;
    trial.gravity_components      = gravity_components;
    trial.density_expression      = density_expression;
    trial.acceleration_expression = acceleration_expression;
    trial.frame_                  = frame_;
    trial.initialize(end);
  }



  template <int dim>
  void
  BodyForces<dim>::initialize(const double end)
  {
    const auto parse = [](const std::string &text, const std::string &name) {
      return text.empty()
               ? nullptr
               : parse_expression<dim>(text, dim, "Body forces/" + name);
    };
    density_function      = parse(density_expression, "Force density");
    acceleration_function = parse(acceleration_expression, "Acceleration");
    frame_.initialize(end);
    set_time(0.);
  }



  template <int dim>
  void
  BodyForces<dim>::set_time(const double time)
  {
    if (density_function)
      density_function->set_time(time);
    if (acceleration_function)
      acceleration_function->set_time(time);
    for (unsigned int d = 0; d < dim; ++d)
      gravity_[d] = gravity_components[d];
    uniform = gravity_;
    if (!frame_.is_active())
      return;
    state              = frame_.at(time);
    const auto to_tank = dealii::transpose(state.orientation);
    gravity_           = to_tank * gravity_;
    uniform            = gravity_ - to_tank * state.acceleration;
    turning            = -(state.spin_rate + state.spin * state.spin);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BodyForces<dim>::gravity(const double time) const
  {
    dealii::Tensor<1, dim> g;
    for (unsigned int d = 0; d < dim; ++d)
      g[d] = gravity_components[d];
    return frame_.is_rotating()
             ? dealii::transpose(frame_.at(time).orientation) * g
             : g;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BodyForces<dim>::field(const dealii::Point<dim> &x) const
  {
    dealii::Tensor<1, dim> value;
    if (acceleration_function)
      for (unsigned int d = 0; d < dim; ++d)
        value[d] = acceleration_function->value(x, d);
    if (frame_.is_rotating())
      value += turning * (x - frame_.center());
    return value;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BodyForces<dim>::density(const dealii::Point<dim> &x) const
  {
    dealii::Tensor<1, dim> value;
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = density_function->value(x, d);
    return value;
  }



  THALWEG_INSTANTIATE(BodyForces)
} // namespace Thalweg
