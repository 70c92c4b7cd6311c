// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_body_forces_h
#define thalweg_fluid_body_forces_h

#include <thalweg/core/section.h>
#include <thalweg/fluid/moving_frame.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The parameters of the section "Body forces", and all that
   * accelerates fluids from outside, in the axes of the tank if that moves:
   *
   * a = R^T (g - d'') + b(x, t) - dOmega/dt x r - Omega x (Omega x r)
   *     - 2 Omega x V + f(x, t) / rho
   *
   * with what MovingFrame says.
   */
  template <int dim>
  class BodyForces
  {
  public:
    /// Declares the sections below @p root.
    void
    declare_parameters(const Section &root);

    /// Tries what is given. @param end of the run, s
    /// @throws dealii::ExcMessage
    void
    check(const double end) const;

    /// Reads what is given. @param end of the run, s
    /// @throws dealii::ExcMessage
    void
    initialize(const double end = 0.);

    /// Evaluates everything at @p time from now on.
    void
    set_time(const double time);

    /// The gravitational acceleration in the axes of the tank, m/s^2.
    const dealii::Tensor<1, dim> &
    gravity() const
    {
      return gravity_;
    }

    /// The same at @p time.
    dealii::Tensor<1, dim>
    gravity(const double time) const;

    /// What accelerates everything alike: gravity, and the translation of the
    /// tank, m/s^2.
    const dealii::Tensor<1, dim> &
    uniform_acceleration() const
    {
      return uniform;
    }

    /// Whether there are accelerations besides that.
    bool
    has_field() const
    {
      return acceleration_function != nullptr || frame_.is_rotating();
    }

    /// Those at @p x but for what depends on the velocity, m/s^2.
    dealii::Tensor<1, dim>
    field(const dealii::Point<dim> &x) const;

    /// Whether velocities are deflected, since the tank turns.
    bool
    is_rotating() const
    {
      return frame_.is_rotating();
    }

    /// Omega x V = spin V, 1/s; the tank deflects V by -2 Omega x V.
    const dealii::Tensor<2, dim> &
    spin() const
    {
      return state.spin;
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

    const MovingFrame<dim> &
    frame() const
    {
      return frame_;
    }

  private:
    std::vector<double>    gravity_components = std::vector<double>(dim, 0.);
    std::string            density_expression, acceleration_expression;
    MovingFrame<dim>       frame_;
    dealii::Tensor<1, dim> gravity_, uniform;
    /// -dOmega/dt x r - Omega x (Omega x r) = turning r
    dealii::Tensor<2, dim>                       turning;
    typename MovingFrame<dim>::State             state;
    std::unique_ptr<dealii::FunctionParser<dim>> density_function,
      acceleration_function;
  };
} // namespace Thalweg

#endif
