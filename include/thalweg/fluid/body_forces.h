#ifndef thalweg_fluid_body_forces_h
#define thalweg_fluid_body_forces_h

#include <thalweg/core/section.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The parameters of the section "Body forces", and what follows from them.
  template <int dim>
  class BodyForces
  {
  public:
    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// Tries the expressions. @throws dealii::ExcMessage
    void
    check() const;

    /// Reads the expressions. @throws dealii::ExcMessage
    void
    initialize();

    /// Evaluates the force density at @p time from now on.
    void
    set_time(const double time);

    /// The gravitational acceleration, m/s^2.
    const dealii::Tensor<1, dim> &
    gravity() const
    {
      return gravity_;
    }

    /// Whether there is a force density at all.
    bool
    has_density() const
    {
      return density_function != nullptr;
    }

    /// The force density at @p x, N/m^3.
    dealii::Tensor<1, dim>
    density(const dealii::Point<dim> &x) const;

  private:
    std::unique_ptr<dealii::FunctionParser<dim>>
    parse() const;

    std::vector<double>    gravity_components = std::vector<double>(dim, 0.);
    std::string            density_expression;
    dealii::Tensor<1, dim> gravity_;
    std::unique_ptr<dealii::FunctionParser<dim>> density_function;
  };
} // namespace Thalweg

#endif
