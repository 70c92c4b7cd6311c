// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_flow_method_h
#define thalweg_methods_flow_method_h

#include <thalweg/methods/flow_step_numbers.h>
#include <thalweg/methods/interface_flow.h>
#include <thalweg/methods/medium.h>
#include <thalweg/methods/method.h>
#include <thalweg/particles/particle_host.h>
#include <thalweg/particles/streamlines.h>

namespace Thalweg
{
  /**
   * @brief What methods of flows have in common: they play on an
   * InterfaceFlow, and differ in the fields they add and in how they advance.
   */
  template <int dim>
  class FlowMethod : public Method<dim>,
                     public Streamlines<dim>,
                     public ParticleHost<dim>
  {
  public:
    /// @param computes_flow whether the method does, so that given velocities
    ///   must suit an incompressible fluid
    /// @param heeds_viscosities whether it does what FluidViscosities say
    explicit FlowMethod(const bool computes_flow,
                        const bool heeds_viscosities = false);

    /// The flow in spaces of the method's own, nullptr if it has none.
    virtual const FlowFields<dim> *
    flow_fields() const
    {
      return nullptr;
    }

    void
    declare_sections(const Section &sections) final;

    void
    check(std::vector<std::string> &faults) const final;

    void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const final;

    std::vector<std::string>
    warnings(const Mesh<dim> &coarse, const double n_cells) const final;

    double
    particles_per_cell() const final;

    void
    publish(const std::string &name, RunOutline<dim> &outline) const final;

    void
    create(const Host<dim> &host) final;

    void
    release() final;

    void
    attach() final;

    void
    offer(Ports &ports) const final;

    StreamlineWalk<dim>
    streamlines() const final;

    unsigned int
    add_property(const std::string &name, const InflowValue<dim> &inflow) final
    {
      return flow->add_property(name, inflow);
    }

    Population<dim> &
    population() final
    {
      return flow->particles();
    }

    const Population<dim> *
    dispersed() const final
    {
      return flow->dispersed();
    }

    void
    initialize() final;

    void
    clear() final;

    void
    keep_constants(const Archive &archive) final;

    void
    keep(const State<dim> &state) final;

    void
    repopulate() final;

    void
    check_conditions(const double time) const final;

    void
    check_conditions_of_step(const double end) const final;

    void
    publish(const std::string &name, SolutionView<dim> &solution) const final;

    /// The flow as others see it.
    FlowView<dim>
    view(const Moment &moment) const;

    std::vector<std::string>
    columns() const final;

    void
    record(const double time) final;

    std::string
    size() const final;

    void
    warn_at_start() const final;

    std::string
    headline() const final;

  protected:
    /// Checks the method's own parameters. @throws dealii::ExcMessage
    virtual void
    check_parameters() const
    {}

    /// Whether the method can say where energy goes.
    virtual bool
    has_energy_budget() const
    {
      return false;
    }

    /// Makes what the method adds to the parts, with zero fields.
    virtual void
    attach_fields() = 0;

    /// Prepares the first step.
    virtual void
    initialize_fields(const typename InterfaceFlow<dim>::Start &start) = 0;

    /// Lets go of what attach_fields() made, as far as it knows the mesh.
    virtual void
    release_fields()
    {}

    /// Names the method's own state.
    virtual void
    keep_fields(const State<dim> &state) = 0;

    /// Fills empty cells and thins crowded ones where the mesh has changed.
    virtual void
    repopulate_cells() = 0;

    /// The velocity that particles followed in the last step, cell by cell.
    virtual const CellVelocity<dim> &
    convecting_velocity_of_cells() const = 0;

    /// The time of the flow's velocity, in s, when the last step has ended
    /// at @p time: later where velocities are staggered.
    virtual double
    velocity_time(const double time) const
    {
      return time;
    }

    /// On the present mesh.
    std::unique_ptr<Parts<dim>> parts;

  private:
    std::unique_ptr<Medium<dim>>        medium;
    FlowParameters<dim>                 parameters;
    std::string                         name;
    std::unique_ptr<InterfaceFlow<dim>> flow;
    /// By how many the particles became more before the present step.
    double n_new_particles = 0.;
  };
} // namespace Thalweg

#endif
