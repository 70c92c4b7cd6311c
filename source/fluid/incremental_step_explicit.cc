// SPDX-License-Identifier: LGPL-2.1-or-later
// The explicit fields of IncrementalStep; its steps are in incremental_step.cc.
#include <thalweg/core/registry.h>
#include <thalweg/fluid/incremental_step.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  void
  IncrementalStep<dim>::viscous_acceleration(const Vector &velocity, Vector &g)
  {
    load = 0.;
    operators.stiffness.add_product(velocity, load, dim, -nu);
    operators.add_boundary_gradient(velocity, load, nu);
    operators.velocity_space.fold(load, dim);
    if (operators.velocity_space.degree() == 1)
      extend_to_boundary(g);
    else
      solve(slip_mass, g, "viscous acceleration");
  }



  template <int dim>
  void
  IncrementalStep<dim>::extend_to_boundary(Vector &g)
  {
    const auto &space = operators.velocity_space;
    change.zero_out_ghost_values();
    change = 0.;
    for (unsigned int i = 0; i < dim * space.n_owned_nodes(); ++i)
      if (!space.is_dependent(i / dim))
        change.local_element(i) =
          load.local_element(i) / lumped_mass.local_element(i);
    boundary.project_slip(change);
    Vector at_boundary(change);
    extension.extend(change, at_boundary);
    change.zero_out_ghost_values();
    change = 0.;
    operators.mass.add_product(at_boundary, change, dim, -1.);
    space.fold(change, dim);
    load.add(1., change);
    solve(fixed_mass, g, "viscous acceleration");
    g.zero_out_ghost_values();
    g.add(1., at_boundary);
    space.interpolate(g, dim);
  }



  template <int dim>
  void
  IncrementalStep<dim>::pressure_acceleration(const Vector &pressure,
                                              Vector       &pi)
  {
    load = 0.;
    operators.add_gradient(pressure, load, 1.);
    operators.velocity_space.fold(load, dim);
    solve(mass, pi, "pressure gradient");
  }



  template <int dim>
  void
  IncrementalStep<dim>::smooth(const Vector &g,
                               const double  dt,
                               Vector       &smoothed)
  {
    update_implicit(dt);
    smoothed.zero_out_ghost_values();
    smoothed.copy_locally_owned_data_from(g);
    smooth_once(g, smoothed);

    // The same for what this has taken away.
    change.zero_out_ghost_values();
    change.copy_locally_owned_data_from(g);
    change.add(-1., smoothed);
    operators.velocity_space.interpolate(change, dim);
    smooth_once(change, change);
    smoothed.zero_out_ghost_values();
    smoothed.add(1., change);
    operators.velocity_space.interpolate(smoothed, dim);
  }



  template <int dim>
  void
  IncrementalStep<dim>::smooth_once(const Vector &field, Vector &smoothed)
  {
    load = 0.;
    operators.mass.add_product(field, load, dim, 1.);
    operators.velocity_space.fold(load, dim);
    solve(*implicit, smoothed, "smooth viscous acceleration");
  }



  template <int dim>
  void
  IncrementalStep<dim>::find_pressure(const Vector &velocity,
                                      const Vector &forces,
                                      const Vector &viscous,
                                      const Vector &boundary_acceleration,
                                      Vector       &pressure)
  {
    const auto &P = operators.pressure_space;
    load          = 0.;
    convection.add(velocity, load, -1.);
    operators.velocity_space.fold(load, dim);
    change.zero_out_ghost_values();
    change = 0.;
    solve(mass, change, "convective acceleration");
    pressure_load = 0.;
    operators.add_weak_gradient(forces, pressure_load, 1.);
    operators.add_weak_gradient(change, pressure_load, 1.);
    // <q, n . w> = (grad q, w) + (q, div w)
    operators.add_weak_gradient(boundary_acceleration, pressure_load, -1.);
    operators.add_divergence(boundary_acceleration, pressure_load, 1.);
    stokes.add(velocity, viscous, pressure_load);
    P.fold(pressure_load, 1);
    const double tolerance =
      parameters.pressure_tolerance * pressure_load.l2_norm();
    divergence = 0.;
    operators.pressure_stiffness.add_product(pressure, divergence, 1, -1.);
    P.fold(divergence, 1);
    pressure_load.add(1., divergence);
    add_to_pressure(tolerance, pressure);
    if (operators.velocity_space.degree() == 1)
      sharpen_pressure(tolerance, pressure);
    poisson.normalize(pressure);
  }



  template <int dim>
  void
  IncrementalStep<dim>::sharpen_pressure(const double tolerance,
                                         Vector      &pressure)
  {
    change.zero_out_ghost_values();
    change = 0.;
    pressure_acceleration(pressure, change);
    pressure_load = 0.;
    operators.pressure_stiffness.add_product(pressure, pressure_load, 1, 1.);
    operators.add_weak_gradient(change, pressure_load, -1.);
    operators.pressure_space.fold(pressure_load, 1);
    add_to_pressure(tolerance, pressure);
  }



  template <int dim>
  void
  IncrementalStep<dim>::add_to_pressure(const double tolerance,
                                        Vector      &pressure)
  {
    std::fill(factors.begin(), factors.end(), 1.);
    solve_poisson(pressure_load, tolerance);
    pressure.zero_out_ghost_values();
    pressure.add(1., increment);
    operators.pressure_space.interpolate(pressure, 1);
  }



  template void
  IncrementalStep<2>::viscous_acceleration(const Vector &, Vector &);
  template void
  IncrementalStep<3>::viscous_acceleration(const Vector &, Vector &);
  template void
  IncrementalStep<2>::pressure_acceleration(const Vector &, Vector &);
  template void
  IncrementalStep<3>::pressure_acceleration(const Vector &, Vector &);
  template void
  IncrementalStep<2>::smooth(const Vector &, double, Vector &);
  template void
  IncrementalStep<3>::smooth(const Vector &, double, Vector &);
  template void
  IncrementalStep<2>::find_pressure(const Vector &,
                                    const Vector &,
                                    const Vector &,
                                    const Vector &,
                                    Vector &);
  template void
  IncrementalStep<3>::find_pressure(const Vector &,
                                    const Vector &,
                                    const Vector &,
                                    const Vector &,
                                    Vector &);
} // namespace Thalweg
