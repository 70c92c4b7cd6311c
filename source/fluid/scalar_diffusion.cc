// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/scalar_diffusion.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    const double gamma_of_stages = 1. - std::sqrt(.5);

    constexpr unsigned int most_iterations = 10000;
  } // namespace



  template <int dim>
  ScalarDiffusion<dim>::ScalarDiffusion(const NodeSpace<dim>  &space,
                                        ScalarConditions<dim> &conditions,
                                        dealii::Function<dim> *source,
                                        const double           tolerance,
                                        const Melting         &law)
    : space(space)
    , conditions(conditions)
    , source(source)
    , tolerance(tolerance)
    , matrix(space)
    , melting_(space, law)
    , is_given(space.n_owned_nodes(), false)
  {
    for (Vector *vector : {&load,
                           &exchange,
                           &source_load,
                           &residual,
                           &increment,
                           &before,
                           &value})
      space.initialize_scalar(*vector);
    faces = boundary_faces<dim>(space.mesh().graph(),
                                [&](const dealii::types::boundary_id id) {
                                  const ScalarBoundary kind =
                                    conditions.at(id).kind;
                                  return kind == ScalarBoundary::flux ||
                                         kind == ScalarBoundary::exchange;
                                });
    collect_given_nodes();
    if (melting_.is_active())
      melting_solver =
        std::make_unique<MeltingSolver<dim>>(space, matrix, melting_);
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::update(const PhaseField<dim> &phase,
                               const Material        &capacity,
                               const Material        &conductivity,
                               const Material        &latent_heat)
  {
    matrix.update(phase, capacity, conductivity);
    if (!melting_.is_active())
      return;
    matrix.lump(phase, latent_heat, melting_.latent_heat());
    melting_.update(matrix.capacity());
    melting_solver->update();
  }



  template <int dim>
  const Vector &
  ScalarDiffusion<dim>::value_of(const Vector &heat)
  {
    if (!melting_.is_active())
      return heat;
    melting_.find_value(heat, value);
    return value;
  }



  template <int dim>
  std::vector<double>
  ScalarDiffusion<dim>::heats_of(std::vector<double> values) const
  {
    if (melting_.is_active())
      for (unsigned int i = 0; i < values.size(); ++i)
        {
          const Melting law = melting_.at(given_nodes[i].node);
          values[i]         = law.heat(values[i], law.molten_at(values[i]));
        }
    return values;
  }



  template <int dim>
  double
  ScalarDiffusion<dim>::content(const Vector &heat) const
  {
    double sum = 0.;
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      sum += capacity().local_element(n) * heat.local_element(n);
    return dealii::Utilities::MPI::sum(
      sum, space.mesh().triangulation().get_communicator());
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::find_gain(const Vector &scalar)
  {
    matrix.diffuse(residual, scalar);
    for (unsigned int n = 0; n < is_given.size(); ++n)
      residual.local_element(n) +=
        load.local_element(n) -
        exchange.local_element(n) * scalar.local_element(n);
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::diffuse(Vector &scalar, const double tau)
  {
    find_gain(scalar);
    double scale = 0.;
    for (unsigned int n = 0; n < is_given.size(); ++n)
      {
        if (is_given[n] || space.is_dependent(n))
          residual.local_element(n) = 0.;
        const double amount =
          capacity().local_element(n) / tau * scalar.local_element(n);
        scale += amount * amount;
      }
    scale = std::sqrt(dealii::Utilities::MPI::sum(
      scale, space.mesh().triangulation().get_communicator()));
    matrix.set_step(tau, exchange, is_given, {});
    increment               = 0.;
    const double norm       = residual.l2_norm();
    const double round_off  = std::numeric_limits<double>::epsilon() * scale;
    unsigned int iterations = 0;
    if (norm > round_off || std::isnan(norm))
      iterations = solve_cg(matrix,
                            increment,
                            residual,
                            matrix.jacobi(),
                            std::max(tolerance * norm, round_off),
                            most_iterations,
                            "scalar")
                     .iterations;
    scalar.zero_out_ghost_values();
    scalar.add(1., increment);
    space.interpolate(scalar, 1);
    return iterations;
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::melt(Vector &heat, const double tau)
  {
    residual.zero_out_ghost_values();
    for (unsigned int n = 0; n < is_given.size(); ++n)
      residual.local_element(n) =
        load.local_element(n) +
        capacity().local_element(n) / tau * before.local_element(n);
    return melting_solver->solve(heat,
                                 residual,
                                 {tau, exchange, is_given},
                                 tolerance);
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::make_stage(Vector                    &heat,
                                   const double               time,
                                   const double               tau,
                                   const std::vector<double> &given,
                                   const double               weight,
                                   ScalarSupply              &supply)
  {
    before.zero_out_ghost_values();
    before.copy_locally_owned_data_from(heat);
    find_load(time);
    set_given(heat, heats_of(given));

    const unsigned int iterations =
      melting_solver ? melt(heat, tau) : diffuse(heat, tau);

    increment.copy_locally_owned_data_from(heat);
    increment.add(-1., before);
    increment *= 1. / tau;
    count(value_of(heat), increment, weight, supply);
    return iterations;
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::advance(Vector       &heat,
                                const double  time,
                                const double  dt,
                                ScalarSupply &supply)
  {
    const double              gamma = gamma_of_stages;
    const std::vector<double> end   = given_values(time + dt);
    std::vector<double>       given; // on the way there
    const Vector             &start = value_of(heat);
    for (unsigned int i = 0; i < end.size(); ++i)
      {
        const double at_start = start.local_element(given_nodes[i].node);
        given.push_back(at_start + gamma * (end[i] - at_start));
      }
    Vector       stage(heat);
    unsigned int iterations = make_stage(
      stage, time + gamma * dt, gamma * dt, given, (1. - gamma) * dt, supply);
    heat.zero_out_ghost_values();
    stage.zero_out_ghost_values();
    // h + (1 - gamma) dt k
    const double part = (1. - gamma) / gamma;
    for (unsigned int n = 0; n < heat.locally_owned_size(); ++n)
      heat.local_element(n) +=
        part * (stage.local_element(n) - heat.local_element(n));
    space.interpolate(heat, 1);
    iterations +=
      make_stage(heat, time + dt, gamma * dt, end, gamma * dt, supply);
    return iterations;
  }



  THALWEG_INSTANTIATE(ScalarDiffusion)
} // namespace Thalweg
