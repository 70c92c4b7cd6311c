// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_single_fluid_flow_h
#define thalweg_fluid_single_fluid_flow_h

#include <thalweg/fields/flow_fields.h>
#include <thalweg/fields/state.h>
#include <thalweg/fluid/boundary_reaction.h>
#include <thalweg/fluid/flow_terms.h>
#include <thalweg/fluid/incremental_step.h>
#include <thalweg/fluid/single_fluid_flow_parameters.h>

#include <deal.II/base/function.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <memory>

namespace Thalweg
{
  /**
   * @brief Velocity and pressure of a single fluid on the mesh between two
   * steps of PFEM-2, and the accelerations that particles meet on their way
   * (Eq. 77 to 81).
   *
   * Velocities belong to the ends of the steps, pressures to their middles.
   * Pressures and forces are divided by the density.
   */
  template <int dim>
  class SingleFluidFlow
  {
  public:
    /// All arguments must outlive the object.
    SingleFluidFlow(Context                              &context,
                    const Mesh<dim>                      &mesh,
                    const SingleFluidFlowParameters<dim> &parameters,
                    const Fluid                          &fluid,
                    const BodyForces<dim>                &forces,
                    const FlowTerms<dim>                 &terms,
                    BoundaryConditions<dim>              &conditions);

    /// Sets the velocity at the start.
    void
    initialize(const dealii::Function<dim> &velocity);

    /// Prepares the step from @p time to @p time + @p dt: guesses the fields
    /// at its end.
    void
    start_step(const double time, const double dt);

    /**
     * @brief The accelerations of the step as far as they are known, m/s^2.
     * @param begin along the path, at the beginning of the step
     * @param end the same at its end, linear in time in between
     */
    void
    find_accelerations(Vector &begin, Vector &end);

    /// Solves for the end of the step (Eq. 81b to 81d).
    /// @param velocity_star projected from the particles, ghosted
    void
    solve(const Vector &velocity_star);

    /**
     * @brief By how much the velocity that solve() found for the end of the
     * step differs from the one the step was made with: the largest
     * difference at a node over the largest velocity.
     */
    double
    prediction_error() const
    {
      return error_of_prediction;
    }

    /// Takes what was solved for as the state.
    void
    end_step();

    /// What the next step starts from, and its solvers' first guesses.
    void
    keep(const State<dim> &state);

    const LagrangeSpace<dim> &
    space() const
    {
      return *velocity_space;
    }

    /// V^n, ghosted.
    const Vector &
    velocity() const
    {
      return begin_velocity;
    }

    /// V^{n+1} as far as it is known, ghosted.
    const Vector &
    velocity_at_end() const
    {
      return end_velocity;
    }

    /// The velocity along whose streamlines particles move at the end of the
    /// step: V^n in steps of first order.
    const Vector &
    convecting_velocity_at_end() const
    {
      return second_order ? end_velocity : begin_velocity;
    }

    /// Whether nothing is known from which the end of this step could be
    /// extrapolated: in the first step, and in one that is far longer than
    /// the time that is known before it.
    bool
    is_at_start() const
    {
      return !is_within_reach(known_span);
    }

    const FlowFields<dim> &
    fields() const
    {
      return view;
    }

    const LagrangeSpace<dim> &
    space_of_pressure() const
    {
      return *pressure_space;
    }

  private:
    /// Nodal body forces at the time of the forces, m/s^2.
    void
    find_body_force();

    /// body_force and what turning of the frame adds at @p velocity, into
    /// with_coriolis.
    void
    add_coriolis(const Vector &velocity);

    /// g of @p velocity and what an implicit step makes of it.
    void
    find_viscous(const Vector &velocity, Vector &g, Vector &smoothed);

    /// What the implicit solve starts from: the projected velocity, and the
    /// viscous acceleration of the beginning that particles do not carry.
    void
    find_start(const Vector &velocity_star);

    /// Compares what was found with what was @p predicted. Collective.
    void
    find_prediction_error(const Vector &predicted);

    /// Whether the explicit pressure follows from the velocity.
    bool
    is_consistent() const
    {
      return parameters.explicit_pressure == "consistent" &&
             parameters.step.pressure_gamma == 1;
    }

    /// The pressure of @p velocity with the viscous acceleration @p g at
    /// @p at.
    void
    find_pressure(const Vector &velocity,
                  const Vector &g,
                  const double  at,
                  Vector       &pressure);

    /// Spaces and operators for explicit pressures of the velocity's degree,
    /// whose gradients are as good as the velocity.
    void
    make_explicit_space();

    /// The explicit pressures before anything of the step is known.
    void
    guess_pressures();

    /// Takes the pressures at the beginnings of the last steps one step back.
    void
    remember_begin_pressure();

    /// The explicit pressure at the end of the step from those before it.
    void
    extrapolate_pressure();

    /// Whether a slope over the last @p span seconds says anything about this
    /// step.
    bool
    is_within_reach(const double span) const
    {
      return span > 0. && dt <= largest_reach * span;
    }

    /// Whether the step is too short for a difference over it to be more than
    /// noise.
    bool
    is_short() const
    {
      return known_span > 0. && dt < .5 * usual_dt &&
             known_span + dt < 2. * usual_dt;
    }

    /// What happened since old_velocity, this step included: the means of
    /// pressure and body force.
    void
    find_means();

    /// pi (Eq. 79) at both ends of the step.
    void
    find_pressure_gradients();

    Context                                    &context;
    const SingleFluidFlowParameters<dim>       &parameters;
    const Fluid                                 fluid;
    const BodyForces<dim>                      &forces;
    const FlowTerms<dim>                       &terms;
    BoundaryConditions<dim>                    &conditions;
    const bool                                  second_order;
    std::unique_ptr<dealii::MappingQCache<dim>> mapping;
    std::unique_ptr<LagrangeSpace<dim>>         velocity_space;
    std::unique_ptr<LagrangeSpace<dim>>         pressure_space;
    std::unique_ptr<FlowBoundary<dim>>          boundary;
    std::unique_ptr<FlowOperators<dim>>         operators;
    std::unique_ptr<IncrementalStep<dim>>       step;
    std::unique_ptr<BoundaryReaction<dim>>      boundary_reaction;
    /// For explicit pressures; own ones only where the degrees differ.
    const LagrangeSpace<dim>             *explicit_space;
    const FlowBoundary<dim>              *explicit_boundary;
    IncrementalStep<dim>                 *explicit_step;
    std::unique_ptr<LagrangeSpace<dim>>   own_explicit_space;
    std::unique_ptr<FlowBoundary<dim>>    own_explicit_boundary;
    std::unique_ptr<FlowOperators<dim>>   own_explicit_operators;
    std::unique_ptr<IncrementalStep<dim>> own_explicit_step;

    /// How many times longer a step may be than the time that its
    /// extrapolation follows from. Short steps are less than half of the usual
    /// one, so this is one half times as much again.
    static constexpr double largest_reach = 4.;

    /// The present step, and the last one.
    double time = 0., dt = 0., last_dt = 0.;
    /// old_velocity is so many seconds older than begin_velocity: the last
    /// step, or the last usual one and short ones after it.
    double known_span = 0., usual_dt = 0.;
    /// Whether the last step was short.
    bool was_short = false;
    /// The same of old_begin_pressure, and of the one before it.
    double pressure_span = 0., older_pressure_span = 0.;
    /// The time of which old_pressure is the mean.
    double mean_span = 0.;
    /// Whether the fields at the end of the step were solved for.
    bool   has_solution = false;
    Vector begin_velocity, end_velocity, old_velocity;
    /// Explicit pressures at the beginnings of the two last steps, and at both
    /// ends of this one.
    Vector older_begin_pressure, old_begin_pressure;
    Vector begin_pressure, end_pressure;
    /// In the middle of this step: explicit, and solved for; of the last one.
    Vector pressure, new_pressure, old_pressure;
    /// Incremental: the change of the pressure in a second.
    Vector pressure_rate;
    /// Integrals over time since old_velocity.
    Vector pressure_impulse, force_impulse;
    /// What a step is judged by: means over it, or over all since old_velocity.
    Vector mean_pressure, mean_force;
    Vector body_force, boundary_acceleration, with_coriolis;
    Vector viscous, begin_viscous, end_viscous, end_smooth, start;
    Vector begin_gradient, end_gradient, pressure_gradient, force;
    double error_of_prediction = 0.;
    /// For those who look: Pa, N and Pa.
    Vector          physical_pressure, reaction, traction;
    FlowFields<dim> view;
  };
} // namespace Thalweg

#endif
