// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/turn_nodes.h>
#include <thalweg/fluid/coupled_system.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  CoupledSystem<dim>::CoupledSystem(const CoupledParts<dim>    &parts,
                                    const CoupledStabilization &stabilization)
    : parts(parts)
    , stabilization(stabilization)
  {
    const NodeSpace<dim> &space = parts.space;
    for (Vector *vector : {&work, &acceleration, &friction, &against})
      space.initialize_velocity(*vector);
    space.initialize_scalar(measures);
    space.initialize_scalar(extents);
    initialize(space, pressure_work);
    initialize(space, load);
    const Q1Integrals<dim> integrals;
    const CellGraph<dim>  &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto local = integrals.node_measures(graph.cell(c));
        const auto point = Q1::middle<dim>(graph.cell(c));
        inverse_squares.push_back(point.covariant.norm_square() / dim);
        for (unsigned int i = 0; i < local.size(); ++i)
          {
            const unsigned int node = space.nodes(c)[i];
            measures.local_element(node) += local[i];
            extents.local_element(node) +=
              graph.cell(c).measure * point.gradients[i].norm();
          }
      }
    space.fold(measures, 1);
    space.fold(extents, 1);
  }



  template <int dim>
  double
  CoupledSystem<dim>::update(const double                  duration,
                             const double                  part_of_end,
                             const dealii::Tensor<2, dim> &turning)
  {
    dt                         = duration;
    theta                      = part_of_end;
    deflection                 = turning;
    const unsigned int n_cells = parts.space.mesh().graph().n_owned_cells();
    taus.resize(n_cells);
    impulse_times.resize(n_cells);
    rests.resize(n_cells);
    double largest = 0.;
    largest_tau    = 0.;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        const double rate =
          parts.viscous.largest_kinematic_viscosity(c) * inverse_squares[c];
        impulse_times[c] = 1. / stabilization.rate(rate, 1. / dt);
        rests[c]         = 1. - impulse_times[c] / dt;
        taus[c] =
          1. /
          stabilization.rate(parts.viscous.kinematic_viscosity_of_lightest(c) *
                               inverse_squares[c],
                             1. / dt);
        largest     = std::max(largest, rate * dt);
        largest_tau = std::max(largest_tau, taus[c]);
      }
    const MPI_Comm communicator =
      parts.space.mesh().triangulation().get_communicator();
    largest_tau = dealii::Utilities::MPI::max(largest_tau, communicator);
    return dealii::Utilities::MPI::max(largest, communicator);
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_jumps(const EnrichedPressure &pressure,
                                Vector                 &result) const
  {
    if (!parts.phase.has_jumps())
      return;
    friction = 0.;
    parts.pressure.subtract_jump_forces(pressure, friction);
    finish_friction(1.);
    result.add(1., friction);
  }



  template <int dim>
  void
  CoupledSystem<dim>::find_friction(const Vector &velocity_,
                                    const double  factor,
                                    const bool    with_tangent) const
  {
    friction = 0.;
    parts.viscous.subtract_viscous_force(velocity_, friction);
    if (with_tangent && tangent_factor > 0.)
      parts.shear.subtract_tangent(velocity_, tangent_factor, friction);
    finish_friction(factor);
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish_friction(const double factor) const
  {
    parts.space.fold(friction, dim);
    friction.zero_out_ghost_values();
    const Vector &inverse = parts.mass.inverse_lumped();
    for (unsigned int n = 0; n < inverse.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        friction.local_element(dim * n + d) *=
          factor * inverse.local_element(n);
    parts.boundary.project(friction);
  }



  template <int dim>
  void
  CoupledSystem<dim>::clear_dependent(Vector &rows) const
  {
    for (unsigned int n = 0; n < parts.space.n_owned_nodes(); ++n)
      if (parts.space.is_dependent(n))
        for (unsigned int d = 0; d < dim; ++d)
          rows.local_element(dim * n + d) = 0.;
  }



  template <int dim>
  void
  CoupledSystem<dim>::find_balance(const Vector &projection,
                                   const Vector &change) const
  {
    against.zero_out_ghost_values();
    switch (stabilization.balance())
      {
        case CoupledStabilization::Balance::acceleration:
          against.equ(1. / dt, change);
          break;
        case CoupledStabilization::Balance::friction:
          against.equ(-1., friction);
          break;
        case CoupledStabilization::Balance::projection:
          against.copy_locally_owned_data_from(projection);
          break;
      }
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_stabilization(const bool              with_forces,
                                        const EnrichedPressure &pressure) const
  {
    against *= -1.;
    parts.space.interpolate(against, dim);
    parts.pressure.add_residual(against, with_forces, &pressure, &taus, load);
  }



  template <int dim>
  void
  CoupledSystem<dim>::balance(Vector &rows) const
  {
    if (parts.boundary.conditions().has_open_boundary())
      return;
    double sums[2] = {0., 0.};
    for (unsigned int n = 0; n < rows.locally_owned_size(); ++n)
      {
        sums[0] += rows.local_element(n);
        sums[1] += measures.local_element(n);
      }
    dealii::Utilities::MPI::sum(
      sums, parts.space.mesh().triangulation().get_communicator(), sums);
    rows.add(-sums[0] / sums[1], measures);
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish_momentum(Vector &rows) const
  {
    if (parts.forces.is_rotating())
      turn_nodes<dim>(deflection, rows);
    parts.boundary.project(rows);
    clear_dependent(rows);
    rows *= 1. / scales[0];
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish(const double factor, CoupledFlow &rows) const
  {
    for (unsigned int b = 0; b < load.n_blocks(); ++b)
      parts.space.fold(load.block(b), 1);
    parts.pressure.remove_given(nodal(load));
    balance(nodal(load));
    load *= factor / scales[1];
    set_pressure(load, rows);
  }



  template <int dim>
  void
  CoupledSystem<dim>::find_residual(const Vector           &velocity_,
                                    const Vector           &rate,
                                    const Vector           &lead,
                                    const Vector           &change,
                                    const EnrichedPressure &pressure,
                                    CoupledFlow            &residual)
  {
    parts.pressure.accelerate(pressure, true, parts.mass, acceleration);
    work.zero_out_ghost_values();
    work.copy_locally_owned_data_from(velocity_);
    work.add(theta, change);
    parts.space.interpolate(work, dim);
    find_friction(work, 1.);
    Vector &rows = velocity(residual);
    rows.copy_locally_owned_data_from(acceleration);
    rows.add(1., friction);
    find_balance(acceleration, change);
    add_jumps(pressure, rows);
    finish_momentum(rows);
    rows.add(-1. / (dt * scales[0]), change);
    clear_dependent(rows);

    load = 0.;
    parts.pressure.add_residual(change, false, nullptr, nullptr, load);
    add_stabilization(true, pressure);
    parts.pressure.subtract_outflow(rate, impulse_times, load);
    work.zero_out_ghost_values();
    work.copy_locally_owned_data_from(velocity_);
    work.add(1., lead);
    parts.space.interpolate(work, dim);
    parts.pressure.subtract_outflow(work, rests, load);
    finish(1., residual);
  }



  template <int dim>
  void
  CoupledSystem<dim>::vmult(CoupledFlow &result, const CoupledFlow &flow) const
  {
    get_pressure(flow, pressure_work);
    parts.pressure.remove_given(nodal(pressure_work));
    for (unsigned int b = 0; b < pressure_work.n_blocks(); ++b)
      parts.space.interpolate(pressure_work.block(b), 1);
    work.zero_out_ghost_values();
    work.copy_locally_owned_data_from(velocity(flow));
    parts.boundary.project(work);
    parts.space.interpolate(work, dim);

    parts.pressure.accelerate(pressure_work, false, parts.mass, acceleration);
    find_friction(work, theta, true);
    Vector &rows = velocity(result);
    rows.copy_locally_owned_data_from(acceleration);
    rows.add(1., friction);
    find_balance(acceleration, work);
    add_jumps(pressure_work, rows);
    rows *= -1.;
    finish_momentum(rows);
    // of w / dt itself, which nothing deflects
    rows.add(1. / (dt * scales[0]), work);
    clear_dependent(rows);

    load = 0.;
    parts.pressure.add_residual(work, false, nullptr, nullptr, load);
    add_stabilization(false, pressure_work);
    finish(-1., result);
  }



  template <int dim>
  void
  CoupledSystem<dim>::find_scales(const Vector           &velocity_,
                                  const EnrichedPressure &given)
  {
    parts.pressure.accelerate(given, true, parts.mass, acceleration);
    find_friction(velocity_, 1.);
    double sums[2] = {0., 0.};
    for (unsigned int n = 0; n < extents.locally_owned_size(); ++n)
      {
        double squares[2] = {0., 0.}; // of acceleration and velocity
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int k = dim * n + d;
            squares[0] += std::pow(std::abs(acceleration.local_element(k)) +
                                     std::abs(friction.local_element(k)),
                                   2);
            squares[1] += std::pow(velocity_.local_element(k), 2);
          }
        sums[0] += squares[0] + squares[1] / (dt * dt);
        sums[1] += std::pow(extents.local_element(n), 2) *
                   (squares[1] + largest_tau * largest_tau * squares[0]);
      }
    dealii::Utilities::MPI::sum(
      sums, parts.space.mesh().triangulation().get_communicator(), sums);
    for (unsigned int i = 0; i < 2; ++i)
      scales[i] = sums[i] > 0. ? std::sqrt(sums[i]) : 1.;
  }



  THALWEG_INSTANTIATE(CoupledSystem)
} // namespace Thalweg
