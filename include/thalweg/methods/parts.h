// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_parts_h
#define thalweg_methods_parts_h

#include <thalweg/core/context.h>
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fluid/fluid_solver.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/particles/boundary_exchange.h>
#include <thalweg/particles/dispersed_phase.h>
#include <thalweg/particles/path_convection.h>
#include <thalweg/particles/population_control.h>
#include <thalweg/particles/streamline_convection.h>
#include <thalweg/transfer/projection.h>

#include <string>

namespace Thalweg
{
  /// The parts that a method of a flow plays on.
  template <int dim>
  struct Parts
  {
    Context                         &context;
    const Mesh<dim>                 &mesh;
    const NodeSpace<dim>            &space;
    const Fluids                    &fluids;
    BodyForces<dim>                 &forces;
    FlowTerms<dim>                  &terms;
    FluidViscosities<dim>           &viscosities;
    BoundaryConditions<dim>         &conditions;
    const BoundaryNodes<dim>        &boundary;
    Population<dim>                 &population;
    const StreamlineConvection<dim> &convection;
    const PopulationControl<dim>    &control;
    const Projection<dim>           &projection;
    PhaseField<dim>                 &phase;
    FluidSolver<dim>                &flow;
    const PathConvection<dim>       &paths;
    BoundaryExchange<dim>           &exchange;
    DispersedPhase<dim>             *dispersed; ///< nullptr without
  };



  /**
   * @brief Fills empty cells with particles that have @p velocity and
   * @p level_set where they stand, and thins crowded ones; for
   * FlowMethod::repopulate(). Collective.
   * @param velocity_space, velocity in m/s, ghosted
   * @param level_set at the nodes of Parts::space, ghosted
   */
  template <int dim>
  void
  repopulate_in_place(const Parts<dim>         &parts,
                      const LagrangeSpace<dim> &velocity_space,
                      const Vector             &velocity,
                      const Vector             &level_set);

  /// Lets fluid in and out through the boundaries after the particles were
  /// moved, if there are two fluids. Collective.
  /// @param velocity with which they moved, ghosted, m/s
  /// @param cell_velocity the same cell by cell
  /// @param middle of the step, s
  /// @return the number of new particles on this rank
  template <int dim>
  unsigned int
  pass_boundaries(const Parts<dim>        &parts,
                  const ConvectionReport  &report,
                  const Vector            &velocity,
                  const CellVelocity<dim> &cell_velocity,
                  const double             middle,
                  const double             dt);

  /// Writes what convection and population control did into the statistics.
  template <int dim>
  void
  record_particles(const Parts<dim>       &parts,
                   const ConvectionReport &report,
                   const unsigned int      n_added,
                   const unsigned int      n_removed);
} // namespace Thalweg

#endif
