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
    section.add("Force density",
                density_expression,
                "N/m^3",
                "A force per volume on every fluid, for example minus a mean "
                "pressure gradient: a function of x, y, z and t with a "
                "semicolon between the components. Empty: none.",
                dealii::Patterns::Anything());
  }



  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  BodyForces<dim>::parse() const
  {
    if (density_expression.empty())
      return nullptr;
    return parse_expression<dim>(density_expression,
                                 dim,
                                 "Body forces/Force density");
  }



  template <int dim>
  void
  BodyForces<dim>::check() const
  {
    parse();
  }



  template <int dim>
  void
  BodyForces<dim>::initialize()
  {
    for (unsigned int d = 0; d < dim; ++d)
      gravity_[d] = gravity_components[d];
    density_function = parse();
  }



  template <int dim>
  void
  BodyForces<dim>::set_time(const double time)
  {
    if (density_function)
      density_function->set_time(time);
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
