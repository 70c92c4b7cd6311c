// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/methods/flow_method.h>
#include <thalweg/methods/flow_quantities.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  FlowMethod<dim>::FlowMethod(const bool computes_flow,
                              const bool heeds_viscosities)
    : parameters(computes_flow)
  {
    parameters.heeds_viscosities = heeds_viscosities;
  }



  template <int dim>
  void
  FlowMethod<dim>::declare_sections(const Section &sections)
  {
    parameters.declare(sections);
  }



  template <int dim>
  void
  FlowMethod<dim>::check(std::vector<std::string> &faults) const
  {
    parameters.check(faults);
    collect_fault(faults, [this]() { check_parameters(); });
    collect_fault(faults, [this]() {
      AssertThrow(!parameters.energy_budget ||
                    (parameters.fluids.size() == 2 && has_energy_budget()),
                  dealii::ExcMessage(
                    "'Statistics/Energy budget' is for two fluids and the "
                    "method 'pfem2'. Leave it out, or choose those."));
    });
  }



  template <int dim>
  void
  FlowMethod<dim>::check_on_mesh(const Mesh<dim>          &coarse,
                                 std::vector<std::string> &faults) const
  {
    parameters.check_on_mesh(coarse, faults);
  }



  template <int dim>
  std::vector<std::string>
  FlowMethod<dim>::warnings(const Mesh<dim> &coarse, const double n_cells) const
  {
    return {parameters.missing_fluid(coarse, n_cells)};
  }



  template <int dim>
  double
  FlowMethod<dim>::particles_per_cell() const
  {
    return parameters.particles_per_cell();
  }



  template <int dim>
  void
  FlowMethod<dim>::publish(const std::string &name,
                           RunOutline<dim>   &outline) const
  {
    outline.flows.add(name,
                      {outline.mesh,
                       parameters.fluids,
                       outline.fills_domain,
                       parameters.has_spray()});
    for (const char *thing : {"streamlines", "particles", "medium"})
      outline.offered.add(name, thing);
    if (parameters.computes_flow)
      outline.offered.add(name, FlowTerms<dim>::port);
    if (parameters.heeds_viscosities)
      outline.offered.add(name, FluidViscosities<dim>::port);
  }



  template <int dim>
  void
  FlowMethod<dim>::publish(const std::string &name,
                           SolutionView<dim> &solution) const
  {
    solution.flows.add(name, view(solution.moment));
  }



  template <int dim>
  void
  FlowMethod<dim>::create(const Host<dim> &host)
  {
    name                           = host.name;
    host.context.has_energy_budget = parameters.energy_budget;
    flow = std::make_unique<InterfaceFlow<dim>>(parameters, host);
    host.ports.template offer<ParticleHost<dim>>(name, "particles", *this);
  }



  template <int dim>
  void
  FlowMethod<dim>::release()
  {
    release_fields();
    medium.reset();
    parts.reset();
    flow.reset();
  }



  template <int dim>
  void
  FlowMethod<dim>::attach()
  {
    flow->build();
    parts  = std::make_unique<Parts<dim>>(flow->parts());
    medium = std::make_unique<Medium<dim>>(
      Medium<dim>{parts->space, parts->fluids, parts->phase, parts->boundary});
    attach_fields();
  }



  template <int dim>
  void
  FlowMethod<dim>::offer(Ports &ports) const
  {
    ports.offer<const Streamlines<dim>>(name, "streamlines", *this);
    ports.offer<const Medium<dim>>(name, "medium", *medium);
    if (parameters.computes_flow)
      ports.offer<FlowTerms<dim>>(name, FlowTerms<dim>::port, parts->terms);
    if (parameters.heeds_viscosities)
      ports.offer<FluidViscosities<dim>>(name,
                                         FluidViscosities<dim>::port,
                                         parts->viscosities);
  }



  template <int dim>
  StreamlineWalk<dim>
  FlowMethod<dim>::streamlines() const
  {
    const CellVelocity<dim> &velocity = convecting_velocity_of_cells();
    Assert(velocity.size() == parts->mesh.graph().n_cells(),
           dealii::ExcMessage("No step has been made on this mesh."));
    return parts->convection.walk(velocity, 1.);
  }



  template <int dim>
  void
  FlowMethod<dim>::initialize()
  {
    flow->forget();
    attach();
    initialize_fields(flow->seed());
  }



  template <int dim>
  void
  FlowMethod<dim>::clear()
  {
    flow->clear();
  }



  template <int dim>
  void
  FlowMethod<dim>::keep_constants(const Archive &archive)
  {
    flow->keep_constants(archive);
  }



  template <int dim>
  void
  FlowMethod<dim>::keep(const State<dim> &state)
  {
    state.values().value("new particles", n_new_particles);
    flow->keep(state.enter("parts"));
    keep_fields(state.enter("fields"));
  }



  template <int dim>
  void
  FlowMethod<dim>::repopulate()
  {
    const double before = parts->population.n_global_particles();
    repopulate_cells();
    n_new_particles += parts->population.n_global_particles() - before;
  }



  template <int dim>
  void
  FlowMethod<dim>::check_conditions(const double time) const
  {
    flow->check_flux_balance(time);
  }



  template <int dim>
  void
  FlowMethod<dim>::check_conditions_of_step(const double end) const
  {
    flow->check_flux_balance_of_step(end);
  }



  template <int dim>
  FlowView<dim>
  FlowMethod<dim>::view(const Moment &moment) const
  {
    return {parts->mesh,
            parts->space,
            parts->fluids,
            parts->population,
            parts->flow.velocity(),
            parts->flow.pressure(),
            parts->phase.level_set(),
            moment.time,
            moment.time_step,
            velocity_time(moment.time),
            moment.step,
            moment.end_time,
            moment.last_step,
            flow_fields(),
            flow->dispersed()};
  }



  template <int dim>
  std::vector<std::string>
  FlowMethod<dim>::columns() const
  {
    return InterfaceFlow<dim>::columns();
  }



  template <int dim>
  void
  FlowMethod<dim>::record(const double time)
  {
    auto &statistics = parts->context.statistics;
    statistics.set("dofs", parts->space.n_dofs());
    statistics.set("velocity time [s]", velocity_time(time));
    flow->record_volumes(time);
    for (const auto &[name, value] : flow_quantities(
           view({time}), parts->phase, parts->forces.gravity(time)))
      statistics.set(name, value);
    // So that the numbers of particles add up from row to row.
    statistics.add("particles added", std::max(n_new_particles, 0.));
    statistics.add("particles removed", std::max(-n_new_particles, 0.));
    n_new_particles = 0.;
  }



  template <int dim>
  std::string
  FlowMethod<dim>::size() const
  {
    return std::to_string(parts->space.n_dofs()) + " degrees of freedom, " +
           std::to_string(parts->population.n_global_particles()) +
           " particles";
  }



  template <int dim>
  void
  FlowMethod<dim>::warn_at_start() const
  {
    flow->warn_at_start();
  }



  template <int dim>
  std::string
  FlowMethod<dim>::headline() const
  {
    return "particles = " +
           std::to_string(parts->population.n_global_particles());
  }



  THALWEG_INSTANTIATE(FlowMethod)
} // namespace Thalweg
