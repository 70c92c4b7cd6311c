// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_pfem2_h
#define thalweg_methods_pfem2_h

#include <thalweg/methods/convected_change.h>
#include <thalweg/methods/flow_method.h>
#include <thalweg/methods/particle_budget.h>
#include <thalweg/transfer/carried_distance.h>

namespace Thalweg
{
  /**
   * @brief PFEM-2 for one or two fluids (Eq. 87): particles carry velocity
   * and phase along the streamlines, the mesh solves what remains.
   */
  template <int dim>
  class Pfem2 : public FlowMethod<dim>
  {
  public:
    Pfem2();

    void
    declare_parameters(const Section &section) override;

    void
    update() override;

    void
    advance(const double time, const double dt) override;

    StepNumbers
    step_numbers() const override
    {
      return numbers->of(convecting_velocity);
    }

  private:
    using FlowMethod<dim>::parts;

    void
    attach_fields() override;

    void
    initialize_fields(const typename InterfaceFlow<dim>::Start &start) override;

    void
    keep_fields(const State<dim> &state) override;

    void
    repopulate_cells() override;

    const CellVelocity<dim> &
    convecting_velocity_of_cells() const override
    {
      return cell_velocity;
    }

    bool
    has_energy_budget() const override
    {
      return true;
    }

    double
    velocity_time(const double) const override
    {
      return flow_time;
    }

    /// Accelerates the particles with what acts on them where they are, as
    /// far as the time integration takes this from the step's beginning.
    void
    accelerate_before_convection(const double time, const double dt);

    /// The velocity at @p time, along whose streamlines the particles go.
    void
    choose_convecting_velocity(const double time);

    /// What the particles carry remains the distance from the interface while
    /// they move for @p dt; what new ones get, too.
    void
    keep_distance(const double dt);

    /// Lets particles go along the streamlines, and drops and bubbles their
    /// own ways, from @p time to @p time + @p dt.
    ConvectionReport
    move_particles(const double time, const double dt);

    /// The time of the velocities of particles whose places are those at
    /// @p time + @p dt.
    double
    time_of_particles(const double time, const double dt) const;

    /// Finds out which particles the level set does not see at @p time +
    /// @p dt: they are drops and bubbles from now on.
    void
    disperse(const double time, const double dt);

    /// What particles carry takes a part of the shift of the level set.
    void
    keep_shift();

    /// Whether particles carry distances that the flow and shifts change.
    bool
    carries_distances() const;

    /// V* of the particles before they move.
    void
    project_before_convection();

    /// V* and the level set from the particles, V* as slip walls admit it.
    void
    project_particles();

    /// What the motion of the particles has changed of V* in the time @p dt,
    /// where velocities are given what the conditions have changed of them.
    void
    find_rate(const double dt);

    /// Finds the lead: staggered velocities are those of the middle of a step
    /// at the places of its beginning. @p time half a step
    void
    find_lead(const double time);

    /// Without the normal components at slip walls, and ghosted.
    void
    obey_slip_walls(Vector &velocity) const;

    /// When the velocity of the mesh is to be after a step to @p time.
    double
    end_of_acceleration(const double time, const double dt) const;

    /// When body forces are taken for an acceleration that ends at @p time:
    /// in its middle, or where its integration wants them.
    double
    time_of_forces(const double duration, const double time) const;

    /// The mesh solves for what acts on the convected velocity for
    /// @p duration, and the particles take the increment: afterwards
    /// velocities are those at @p time, and particles will follow them for
    /// twice @p half_step.
    void
    accelerate(const double duration,
               const double time,
               const double half_step);

    /// The particles take @p factor times the last increment of the mesh.
    void
    accelerate_particles(const double factor);

    std::string time_integration = "staggered";

    std::unique_ptr<FlowStepNumbers<dim>> numbers;
    std::unique_ptr<ParticleBudget<dim>>  budget;
    std::unique_ptr<CarriedDistance<dim>> carried_distance;
    std::unique_ptr<ConvectedChange<dim>> convected_change; ///< if staggered
    Vector                                convecting_velocity;
    Vector                                old_velocity;
    Vector                                velocity_star;
    /// V* before the particles moved, then the rate at which it changed.
    Vector rate;
    /// What the flow's velocity will have changed by when particles follow it.
    Vector            lead;
    Vector            level_set;
    CellVelocity<dim> cell_velocity;
    CellField<dim, 1> cell_level_set; ///< that new particles take
    CellField<dim, 1> cell_distance;  ///< that the mesh shows
    /// The times of the flow's velocity and of the old one.
    double flow_time     = 0;
    double old_flow_time = 0;
    /// How long the last acceleration took, 0 before the first.
    double acceleration_time = 0;
  };
} // namespace Thalweg

#endif
