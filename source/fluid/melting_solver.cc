// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/registry.h>
#include <thalweg/fluid/melting_solver.h>
#include <thalweg/linear_algebra/krylov.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    constexpr unsigned int most_turns = 500;

    constexpr unsigned int most_linear_iterations = 10000;

    /// Halvings of an interval in which a step ends.
    constexpr unsigned int n_halvings = 6;



    /// The heat with factor * heat + majorant * value(heat) = amount.
    double
    heat_alone(const Melting &law,
               const double   factor,
               const double   majorant,
               const double   amount)
    {
      const double solid = amount / (factor + majorant);
      if (solid <= law.solidus || law.latent == 0.)
        return solid;
      const double liquid =
        (amount + majorant * law.latent) / (factor + majorant);
      if (liquid >= law.solidus + law.range())
        return liquid;
      const double slope = law.slope(Melting::State::melting);
      return (amount - majorant * law.solidus * (1. - slope)) /
             (factor + majorant * slope);
    }
  } // namespace



  template <int dim>
  MeltingSolver<dim>::MeltingSolver(const NodeSpace<dim>    &space,
                                    ScalarOperator<dim>     &matrix,
                                    const NodalMelting<dim> &melting)
    : space(space)
    , matrix(matrix)
    , melting(melting)
    , states(space.n_owned_nodes(), Melting::State::solid)
    , slopes(space.n_owned_nodes(), 1.)
  {
    for (Vector *vector :
         {&majorant, &value, &gain, &residual, &increment, &change})
      space.initialize_scalar(*vector);
  }



  template <int dim>
  void
  MeltingSolver<dim>::find_gain(const Vector &values,
                                const Vector &right_side,
                                const Step   &step)
  {
    matrix.diffuse(gain, values);
    for (unsigned int n = 0; n < states.size(); ++n)
      gain.local_element(n) +=
        right_side.local_element(n) -
        step.exchange.local_element(n) * values.local_element(n);
  }



  template <int dim>
  void
  MeltingSolver<dim>::find_residual(const Vector &heat,
                                    const Vector &right_side,
                                    const Step   &step)
  {
    find_gain(value, right_side, step);
    for (unsigned int n = 0; n < states.size(); ++n)
      residual.local_element(n) =
        is_free(n, step)
          ? gain.local_element(n) - matrix.capacity().local_element(n) /
                                      step.tau * heat.local_element(n)
          : 0.;
  }



  template <int dim>
  void
  MeltingSolver<dim>::relax(Vector       &heat,
                            const Vector &right_side,
                            const Step   &step)
  {
    find_gain(value, right_side, step);
    heat.zero_out_ghost_values();
    for (unsigned int n = 0; n < states.size(); ++n)
      {
        if (!is_free(n, step))
          continue;
        const double bound =
          majorant.local_element(n) + step.exchange.local_element(n);
        heat.local_element(n) =
          heat_alone(melting.at(n),
                     matrix.capacity().local_element(n) / step.tau,
                     bound,
                     gain.local_element(n) + bound * value.local_element(n));
      }
    space.interpolate(heat, 1);
    melting.find_value(heat, value);
  }



  template <int dim>
  bool
  MeltingSolver<dim>::find_states(const Vector &heat)
  {
    bool is_new = false;
    for (unsigned int n = 0; n < states.size(); ++n)
      {
        const Melting law   = melting.at(n);
        const auto    state = law.state(heat.local_element(n));
        is_new              = is_new || state != states[n];
        states[n]           = state;
        slopes[n]           = law.slope(state);
      }
    return dealii::Utilities::MPI::max(
             static_cast<int>(is_new),
             space.mesh().triangulation().get_communicator()) > 0;
  }



  template <int dim>
  unsigned int
  MeltingSolver<dim>::linearize(const Step  &step,
                                const double tolerance,
                                const double round_off)
  {
    matrix.set_step(step.tau, step.exchange, step.is_given, slopes);
    // What melts at one temperature has none of its own to find.
    change.zero_out_ghost_values();
    change.copy_locally_owned_data_from(residual);
    for (unsigned int n = 0; n < slopes.size(); ++n)
      if (slopes[n] == 0.)
        change.local_element(n) = 0.;
    increment.zero_out_ghost_values();
    increment         = 0.;
    const double norm = change.l2_norm();
    if (norm == 0.)
      return 0;
    const unsigned int iterations =
      solve_cg(matrix,
               increment,
               change,
               matrix.jacobi(),
               std::max(tolerance * norm, round_off),
               most_linear_iterations,
               "scalar")
        .iterations;
    space.interpolate(increment, 1);
    matrix.diffuse(change, increment);
    for (unsigned int n = 0; n < slopes.size(); ++n)
      change.local_element(n) -=
        step.exchange.local_element(n) * increment.local_element(n);
    return iterations;
  }



  template <int dim>
  double
  MeltingSolver<dim>::length_of_step(const Step &step) const
  {
    // Upwards there where this is positive.
    const auto ascent = [&](const double length) {
      double sum = 0.;
      for (unsigned int n = 0; n < states.size(); ++n)
        {
          if (!is_free(n, step) || increment.local_element(n) == 0.)
            continue;
          const Melting law = melting.at(n);
          const double  at =
            value.local_element(n) + length * increment.local_element(n);
          sum += increment.local_element(n) *
                 (matrix.capacity().local_element(n) / step.tau *
                    law.heat(at, law.molten_at(at)) -
                  gain.local_element(n) - length * change.local_element(n));
        }
      return dealii::Utilities::MPI::sum(
        sum, space.mesh().triangulation().get_communicator());
    };
    if (ascent(1.) <= 0.)
      return 1.;
    double length = 0., too_far = 1.;
    for (unsigned int i = 0; i < n_halvings; ++i)
      {
        const double middle                       = .5 * (length + too_far);
        (ascent(middle) <= 0. ? length : too_far) = middle;
      }
    return length;
  }



  template <int dim>
  unsigned int
  MeltingSolver<dim>::solve(Vector       &heat,
                            const Vector &right_side,
                            const Step   &step,
                            const double  tolerance)
  {
    melting.find_value(heat, value);
    find_residual(heat, right_side, step);
    const double round_off =
      std::numeric_limits<double>::epsilon() * right_side.l2_norm();
    const double first = residual.l2_norm();
    if (first <= round_off)
      return 0;
    const double target     = std::max(tolerance * first, round_off);
    unsigned int iterations = 0;
    for (unsigned int turn = 0; turn < most_turns; ++turn)
      {
        relax(heat, right_side, step);
        find_states(heat);
        find_residual(heat, right_side, step);
        if (residual.l2_norm() <= target)
          return iterations;
        iterations += linearize(step, tolerance, round_off);
        heat.zero_out_ghost_values();
        for (unsigned int n = 0; n < states.size(); ++n)
          if (is_free(n, step))
            heat.local_element(n) +=
              step.tau / matrix.capacity().local_element(n) *
              (residual.local_element(n) + change.local_element(n));
        space.interpolate(heat, 1);
        if (!find_states(heat))
          return iterations;
        const double length = length_of_step(step);
        value.zero_out_ghost_values();
        value.add(length, increment);
        space.interpolate(value, 1);
      }
    throw StepFailure("What melts in a step was not found in " +
                      std::to_string(most_turns) + " turns.");
  }



  THALWEG_INSTANTIATE(MeltingSolver)
} // namespace Thalweg
