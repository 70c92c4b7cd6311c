// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/turn_nodes.h>
#include <thalweg/fluid/enriched_flow.h>

namespace Thalweg
{
  template <int dim>
  void
  EnrichedFlow<dim>::declare_common_parameters(const Section &section)
  {
    section.add("Divergence tolerance",
                divergence_tolerance,
                "",
                "The velocity has been made free of divergence when an "
                "iteration changes it by less than this part of the whole "
                "change.",
                dealii::Patterns::Double(0, 1));
    section.add("Maximal linear iterations",
                maximal_iterations,
                "",
                "A linear solver that needs more fails, and the step is "
                "repeated with half the size.",
                dealii::Patterns::Integer(1));
  }



  template <int dim>
  void
  EnrichedFlow<dim>::initialize(const FlowSetup<dim> &setup)
  {
    context  = &setup.context;
    space    = &setup.space;
    boundary = &setup.boundary;
    phase    = &setup.phase;
    forces   = &setup.forces;
    terms    = &setup.terms;
    tension  = setup.tension;
    mass     = std::make_unique<NodalMass<dim>>(*space, *boundary, *phase);
    budget   = std::make_unique<KineticBudget<dim>>(*context, *mass);
    pressure_system = std::make_unique<PressureSystem<dim>>(
      *space, *boundary, *phase, *forces, tension);
    cell_projection = std::make_unique<CellProjection<dim>>(*space,
                                                            *boundary,
                                                            *mass,
                                                            *pressure_system);
    shear           = std::make_unique<ShearViscosities<dim>>(*space,
                                                    *boundary,
                                                    *phase,
                                                    setup.viscosities);
    viscous         = std::make_unique<ViscousOperator<dim>>(*space,
                                                     *boundary,
                                                     *phase,
                                                     &shear->viscosities());
    Thalweg::initialize(*space, p);
    space->initialize_velocity(force);
    space->initialize_velocity(change);
    space->initialize_velocity(deflected);
    space->initialize_velocity(v);
    if (has_hidden_pressure())
      {
        whole_pressure.reinit(0);
        space->initialize_scalar(whole_pressure);
      }
  }



  template <int dim>
  void
  EnrichedFlow<dim>::begin(const Vector &velocity_star,
                           const Vector &lead,
                           const double  duration)
  {
    {
      dealii::TimerOutput::Scope scope(context->timers, "assembly");
      mass->update();
      pressure_system->assemble();
      if (tension != nullptr)
        tension->update();
      add_terms();
      shear->update(v);
    }
    change.copy_locally_owned_data_from(v);
    v.copy_locally_owned_data_from(velocity_star);
    if (forces->is_rotating())
      deflect(lead, duration);
    apply_boundary();
    budget->begin(v);
    // The last step's pressure is the initial guess.
    apply_open_boundary();
    star(p).zero_out_ghost_values();
    star(p) = 0.;
  }



  template <int dim>
  void
  EnrichedFlow<dim>::apply_boundary()
  {
    boundary->apply(v);
    space->interpolate(v, dim);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::advance(const Vector &acceleration, const double duration)
  {
    v.zero_out_ghost_values();
    v.add(duration, acceleration);
    apply_boundary();
  }



  template <int dim>
  void
  EnrichedFlow<dim>::add_terms()
  {
    if (!terms->has_acceleration())
      return;
    force.zero_out_ghost_values();
    force = 0.;
    terms->add_acceleration(force);
    pressure_system->add_acceleration(1., force);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::deflect(const Vector &lead, const double duration)
  {
    const dealii::Tensor<2, dim> spin = duration * forces->spin();
    deflection = dealii::invert(dealii::unit_symmetric_tensor<dim>() + spin);
    // change: what the rotation makes of V*, from the velocity before
    change.zero_out_ghost_values();
    change.add(2., lead);
    turn_nodes<dim>(spin, change);
    change.sadd(-1., 1., v);
    turn_nodes<dim>(deflection, change);
    change.add(-1., v);
    v.zero_out_ghost_values();
    v.add(1., change);
    deflected.zero_out_ghost_values();
    deflected.equ(1. / duration, change);
    space->interpolate(deflected, dim);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::normalize_pressure()
  {
    if (boundary->conditions().has_open_boundary())
      return;
    double sum[2] = {0, 0};
    for (unsigned int n = 0; n < nodal(p).locally_owned_size(); ++n)
      if (!space->is_dependent(n))
        {
          sum[0] += nodal(p).local_element(n);
          sum[1] += 1.;
        }
    dealii::Utilities::MPI::sum(sum, context->communicator, sum);
    nodal(p).zero_out_ghost_values();
    nodal(p).add(-sum[0] / sum[1]);
    space->interpolate(nodal(p), 1);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::finish_pressure()
  {
    normalize_pressure();
    if (!has_hidden_pressure())
      return;
    whole_pressure.zero_out_ghost_values();
    whole_pressure.copy_locally_owned_data_from(nodal(p));
    tension->add_hidden_pressure(whole_pressure);
    space->interpolate(whole_pressure, 1);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::apply_open_boundary()
  {
    nodal(p).zero_out_ghost_values();
    pressure_system->apply_open_boundary(nodal(p));
    for (const auto &node : boundary->pressure_nodes())
      if (node.node < nodal(p).locally_owned_size())
        {
          dealii::Tensor<1, dim> velocity;
          for (unsigned int d = 0; d < dim; ++d)
            velocity[d] = v.local_element(dim * node.node + d);
          const double inward = std::min(velocity * node.normal, 0.);
          nodal(p).local_element(node.node) -=
            .5 * mass->density(node.node) * inward * inward;
        }
    space->interpolate(nodal(p), 1);
  }



  template <int dim>
  void
  EnrichedFlow<dim>::remove_divergence(const Vector &lead)
  {
    dealii::TimerOutput::Scope scope(context->timers, "divergence");
    v.zero_out_ghost_values();
    v.add(1., lead);
    space->interpolate(v, dim);
    const SolveReport report =
      cell_projection->project(v, divergence_tolerance, maximal_iterations);
    v.zero_out_ghost_values();
    v.add(-1., lead);
    space->interpolate(v, dim);
    context->statistics.set("divergence iterations", report.iterations);
    context->statistics.set("divergence [1/s]", report.residual);
  }



  THALWEG_INSTANTIATE(EnrichedFlow)
} // namespace Thalweg
