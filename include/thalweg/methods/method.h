// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_method_h
#define thalweg_methods_method_h

#include <thalweg/core/context.h>
#include <thalweg/core/registry.h>
#include <thalweg/core/step_number.h>
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/flow_fields.h>
#include <thalweg/fields/state.h>
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
  /// The parts that a method plays on.
  template <int dim>
  struct Parts
  {
    Context                         &context;
    const Mesh<dim>                 &mesh;
    const NodeSpace<dim>            &space;
    const Fluids                    &fluids;
    BodyForces<dim>                 &forces;
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
   * @brief An algorithm that advances the solution by one time step;
   * registered under "Method".
   */
  template <int dim>
  class Method
  {
  public:
    virtual ~Method() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Looks at the parameters before anything is built.
    /// @throws dealii::ExcMessage if they cannot be used
    virtual void
    check() const
    {}

    /// Whether the method computes the flow, so that given velocities must
    /// suit an incompressible fluid.
    virtual bool
    computes_flow() const
    {
      return true;
    }

    /// Whether the method can say where energy goes.
    virtual bool
    has_energy_budget() const
    {
      return false;
    }

    /**
     * @brief Sets up for the present mesh, with zero fields; once for each
     * mesh.
     * @param parts must outlive the method, or its next attach()
     */
    virtual void
    attach(const Parts<dim> &parts) = 0;

    /**
     * @brief Prepares the first step.
     * @param velocity at the start, m/s
     * @param initial_velocity the same at the nodes, ghosted
     * @param initial_level_set ghosted
     */
    virtual void
    initialize(const dealii::Function<dim> &velocity,
               const Vector                &initial_velocity,
               const Vector                &initial_level_set) = 0;

    /// Names what the next step starts from.
    virtual void
    keep(const State<dim> &state) = 0;

    /// Finds what follows from the state, when that was carried to another
    /// mesh or restored.
    virtual void
    update() = 0;

    /// Adds and removes particles where the mesh has changed.
    virtual void
    repopulate() = 0;

    /// From @p time to @p time + @p dt, in s. @throws StepFailure
    virtual void
    advance(const double time, const double dt) = 0;

    /// The time of the flow's velocity, in s, when the last step has ended
    /// at @p time: later where velocities are staggered.
    virtual double
    velocity_time(const double time) const
    {
      return time;
    }

    /// What bounds the size of the next step. Collective.
    virtual StepNumbers
    step_numbers() const = 0;

    /// What the line of a step says of the method.
    virtual std::string
    headline() const = 0;

    /// The flow in spaces of the method's own, nullptr if it has none.
    virtual const FlowFields<dim> *
    flow_fields() const
    {
      return nullptr;
    }
  };

  /**
   * @brief Fills empty cells with particles that have @p velocity and
   * @p level_set where they stand, and thins crowded ones; for
   * Method::repopulate(). Collective.
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

  /// How many particles there are, for Method::headline().
  template <int dim>
  std::string
  count_particles(const Parts<dim> &parts);

  /// Writes what convection and population control did into the statistics.
  template <int dim>
  void
  record_particles(const Parts<dim>       &parts,
                   const ConvectionReport &report,
                   const unsigned int      n_added,
                   const unsigned int      n_removed);
} // namespace Thalweg

#endif
