// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/fluid/pressure_system.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Thalweg
{
  template <int dim>
  PressureSystem<dim>::PressureSystem(const NodeSpace<dim>      &space,
                                      const BoundaryNodes<dim>  &boundary,
                                      const PhaseField<dim>     &phase,
                                      const BodyForces<dim>     &forces,
                                      const InterfaceForce<dim> *tension)
    : space(space)
    , boundary(boundary)
    , phase(phase)
    , forces(forces)
    , tension(tension)
    , singular(!boundary.conditions().has_open_boundary())
  {
    initialize(space, residual);
    initialize(space, increment);
    space.initialize_velocity(field);
    initialize_matrix();
  }



  template <int dim>
  PressureSystem<dim>::~PressureSystem() = default;



  template <int dim>
  void
  PressureSystem<dim>::find_acceleration()
  {
    if (has_field && !forces.has_field())
      field = 0.;
    has_field = forces.has_field();
    if (!has_field)
      return;
    for_each_owned_node<dim>(space,
                             [&](const unsigned int        node,
                                 const dealii::Point<dim> &position) {
                               const auto a = forces.field(position);
                               for (unsigned int d = 0; d < dim; ++d)
                                 field.local_element(dim * node + d) = a[d];
                             });
    space.interpolate(field, dim);
  }



  template <int dim>
  void
  PressureSystem<dim>::add_divergence(const unsigned int cell,
                                      const Vector      &rate,
                                      Load              &load) const
  {
    const auto r = gather_velocity<dim>(rate, space.nodes(cell));
    integrals.add_divergence(space.mesh().graph().cell(cell), r, load.nodal);
    subtract_star_outflow(cell, r, load);
  }



  template <int dim>
  void
  PressureSystem<dim>::subtract_star_outflow(
    const unsigned int                         cell,
    const std::array<double, dim *(1 << dim)> &field,
    Load                                      &load) const
  {
    if (const CutCell<dim> *cut = enriched_cell(cell))
      for (unsigned int j = 0; j < load.star.size(); ++j)
        for (unsigned int v = 0; v < load.nodal.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            load.star[j] -= cut->star_divergence[j][v][d] * field[dim * v + d];
  }



  template <int dim>
  void
  PressureSystem<dim>::subtract_jumps(
    const CutCell<dim>                        &cut,
    const std::array<double, dim *(1 << dim)> &field,
    Load                                      &load) const
  {
    constexpr unsigned int n = 1 << dim;
    if (!cut.star_jump.empty())
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int d = 0; d < dim; ++d)
            load.star[j] -= cut.star_jump[n * i + j][d] * field[dim * i + d];
  }



  template <int dim>
  void
  PressureSystem<dim>::add_forces(const unsigned int cell, Load &load) const
  {
    const auto         &geometry  = space.mesh().graph().cell(cell);
    const auto          gradients = integrals.gradient_integrals(geometry);
    const CutCell<dim> *cut       = cut_cell(cell);
    auto                g         = forces.uniform_acceleration();
    const auto          f         = forces.has_density()
                                      ? forces.density(Q1::center<dim>(geometry))
                                      : dealii::Tensor<1, dim>();
    if (has_field)
      {
        auto a = gather_velocity<dim>(field, space.nodes(cell));
        for (unsigned int d = 0; d < dim; ++d)
          {
            double mean = 0.;
            for (unsigned int v = 0; v < load.nodal.size(); ++v)
              mean += a[dim * v + d] / load.nodal.size();
            g[d] += mean;
            for (unsigned int v = 0; v < load.nodal.size(); ++v)
              {
                a[dim * v + d] -= mean;
                if (cut && cut->enriched)
                  for (unsigned int j = 0; j < load.star.size(); ++j)
                    load.star[j] +=
                      cut->star_gradient[v][j][d] * a[dim * v + d];
              }
          }
        integrals.add_divergence(geometry, a, load.nodal);
      }
    for (unsigned int v = 0; v < load.nodal.size(); ++v)
      load.nodal[v] +=
        g * gradients[v] +
        f * (cut ? cut->gradient[v] : gradients[v] / phase.fluid(cell).density);
    if (cut && cut->enriched)
      for (unsigned int j = 0; j < load.star.size(); ++j)
        load.star[j] += g * cut->star_load[j] + f * cut->star_inverse_load[j];
    if (tension != nullptr)
      if (const auto *force = tension->force(cell))
        add_tension(cell, *force, load);
  }



  template <int dim>
  void
  PressureSystem<dim>::add_tension(
    const unsigned int                             cell,
    const typename InterfaceForce<dim>::CellForce &force,
    Load                                          &load) const
  {
    add_nodal_pressure(cell, force.pressures, 1., load);
    const CutCell<dim> *cut = cut_cell(cell);
    if (cut == nullptr)
      return;
    const Fluids &fluids    = phase.both_fluids();
    const auto acceleration = force.density / fluids[fluids.denser()].density;
    for (unsigned int i = 0; i < load.nodal.size(); ++i)
      load.nodal[i] += acceleration * cut->denser_gradient[i];
    if (cut->enriched)
      for (unsigned int i = 0; i < load.star.size(); ++i)
        load.star[i] += acceleration * cut->denser_star_load[i];
  }



  template <int dim>
  void
  PressureSystem<dim>::add_nodal_pressure(
    const unsigned int                    cell,
    const std::array<double, (1 << dim)> &pressure,
    const double                          factor,
    Load                                 &load) const
  {
    const CutCell<dim> *cut = cut_cell(cell);
    const auto          laplace =
      cut ? cut->laplace : integrals.laplace(space.mesh().graph().cell(cell));
    const double scale = cut ? factor : factor / phase.fluid(cell).density;
    for (unsigned int i = 0; i < load.nodal.size(); ++i)
      for (unsigned int j = 0; j < load.nodal.size(); ++j)
        load.nodal[i] += scale * laplace[i][j] * pressure[j];
    if (cut && cut->enriched)
      for (unsigned int i = 0; i < load.nodal.size(); ++i)
        for (unsigned int j = 0; j < load.nodal.size(); ++j)
          load.star[i] += factor * cut->laplace_star[j][i] * pressure[j];
  }



  template <int dim>
  void
  PressureSystem<dim>::subtract_pressure(const unsigned int      cell,
                                         const EnrichedPressure &pressure,
                                         Load                   &load) const
  {
    constexpr unsigned int n = 1 << dim;
    add_nodal_pressure(cell,
                       gather<dim>(nodal(pressure), space.nodes(cell)),
                       -1.,
                       load);
    if (const CutCell<dim> *cut = enriched_cell(cell))
      {
        const auto q = gather<dim>(star(pressure), space.nodes(cell));
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              load.nodal[i] -= cut->laplace_star[i][j] * q[j];
              load.star[i] -= cut->laplace_star_star[i][j] * q[j];
            }
      }
  }



  template <int dim>
  void
  PressureSystem<dim>::add(const unsigned int cell,
                           const Load        &load,
                           const double       factor,
                           EnrichedPressure  &all) const
  {
    const auto &nodes = space.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      nodal(all).local_element(nodes[v]) += factor * load.nodal[v];
    if (enriched_cell(cell))
      for (unsigned int v = 0; v < nodes.size(); ++v)
        star(all).local_element(nodes[v]) += factor * load.star[v];
  }



  template <int dim>
  void
  PressureSystem<dim>::add_residual(const Vector              &rate,
                                    const bool                 with_forces,
                                    const EnrichedPressure    *pressure,
                                    const std::vector<double> *cell_factors,
                                    EnrichedPressure          &all) const
  {
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        Load load;
        add_divergence(c, rate, load);
        const CutCell<dim> *cut = enriched_cell(c);
        if (cut && cell_factors)
          subtract_jumps(*cut,
                         gather_velocity<dim>(rate, space.nodes(c)),
                         load);
        if (with_forces)
          add_forces(c, load);
        if (pressure)
          subtract_pressure(c, *pressure, load);
        add(c, load, cell_factors ? (*cell_factors)[c] : 1., all);
      }
  }



  template <int dim>
  void
  PressureSystem<dim>::subtract_outflow(const Vector              &field,
                                        const std::vector<double> &cell_factors,
                                        EnrichedPressure          &all) const
  {
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        Load       load;
        const auto u = gather_velocity<dim>(field, space.nodes(c));
        integrals.add_outflow(space.mesh().graph().cell(c), u, -1., load.nodal);
        subtract_star_outflow(c, u, load);
        add(c, load, cell_factors[c], all);
      }
  }



  template <int dim>
  void
  PressureSystem<dim>::assemble_residual(const Vector           &rate,
                                         const bool              with_forces,
                                         const EnrichedPressure *pressure)
  {
    residual = 0.;
    boundary.add_flux(rate, -1., nodal(residual));
    add_residual(rate, with_forces, pressure, nullptr, residual);
    space.fold(nodal(residual), 1);
    space.fold(star(residual), 1);
    enriched->remove_given(nodal(residual));
  }



  template <int dim>
  SolveReport
  PressureSystem<dim>::correct(const Vector      &rate,
                               const bool         with_forces,
                               EnrichedPressure  &pressure,
                               const double       tolerance,
                               const unsigned int maximal_iterations)
  {
    if (with_forces)
      {
        // Given pressures are part of the right hand side: they may be all
        // that moves the fluid.
        EnrichedPressure given;
        initialize(space, given);
        apply_open_boundary(nodal(given));
        space.interpolate(nodal(given), 1);
        assemble_residual(rate, true, &given);
        reference_norm = residual.l2_norm();
      }
    assemble_residual(rate, with_forces, with_forces ? &pressure : nullptr);
    const SolveReport report =
      solve(tolerance * reference_norm, maximal_iterations);
    Thalweg::add(space, increment, pressure);
    return report;
  }



  template <int dim>
  SolveReport
  PressureSystem<dim>::solve(const double       tolerance,
                             const unsigned int maximal_iterations)
  {
    increment = 0.;
    if (reference_norm == 0.)
      return {};
    SolveReport          report;
    const Preconditioner preconditioner{*enriched, amg};
    const auto           attempt = [&](const unsigned int iterations) {
      enriched->invert_beside_interface(increment, residual);
      report = solve_cg(*enriched,
                        increment,
                        residual,
                        preconditioner,
                        tolerance,
                        iterations,
                        "pressure");
    };
    try
      {
        attempt(std::min(maximal_iterations, patience));
      }
    catch (const StepFailure &)
      {
        amg.build(*matrix, AmgPreconditioner::Smoother::chebyshev);
        attempt(maximal_iterations);
      }
    report.residual /= reference_norm;
    return report;
  }



  template <int dim>
  void
  PressureSystem<dim>::precondition(Vector &result, Vector &load) const
  {
    enriched->remove_given(load);
    result.zero_out_ghost_values();
    amg.vmult(result, load);
    enriched->remove_given(result);
    space.interpolate(result, 1);
  }



  template <int dim>
  void
  PressureSystem<dim>::apply_open_boundary(Vector &pressure) const
  {
    for (const auto &node : boundary.pressure_nodes())
      if (node.node < pressure.locally_owned_size())
        pressure.local_element(node.node) =
          boundary.conditions().at(node.id).function->value(node.position);
  }



  THALWEG_INSTANTIATE(PressureSystem)
} // namespace Thalweg
