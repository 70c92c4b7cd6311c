// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_single_fluid_pfem2_h
#define thalweg_methods_single_fluid_pfem2_h

#include <thalweg/fluid/single_fluid_flow.h>
#include <thalweg/methods/flow_method.h>
#include <thalweg/particles/population_snapshot.h>
#include <thalweg/transfer/velocity_projection.h>

namespace Thalweg
{
  /**
   * @brief PFEM-2 for a single fluid with explicit forces along the
   * streamlines (Eq. 81), of second order in space and time.
   */
  template <int dim>
  class SingleFluidPfem2 : public FlowMethod<dim>
  {
  public:
    SingleFluidPfem2();

    void
    declare_parameters(const Section &section) override;

    void
    update() override;

    void
    advance(const double time, const double dt) override;

    StepNumbers
    step_numbers() const override
    {
      return numbers->of(parts->flow.velocity());
    }

    const FlowFields<dim> *
    flow_fields() const override
    {
      return flow ? &flow->fields() : nullptr;
    }

  private:
    using FlowMethod<dim>::parts;

    void
    check_parameters() const override;

    void
    attach_fields() override;

    void
    initialize_fields(const typename InterfaceFlow<dim>::Start &start) override;

    void
    keep_fields(const State<dim> &state) override;

    void
    repopulate_cells() override;

    void
    release_fields() override
    {
      flow.reset();
    }

    const CellVelocity<dim> &
    convecting_velocity_of_cells() const override;

    /// The largest Fourier number with which steps are stable (Eq. 65).
    double
    fourier_limit() const;

    /// x_p and the explicit part of V_p (Eq. 81a); empty cells are filled.
    void
    move_particles(const double dt);

    /// Copies velocity and pressure to the Q1 fields that all methods have.
    void
    show_at_vertices();

    /// How often the step is made again whatever was predicted.
    unsigned int
    n_given_corrections() const;

    /// Whether the step must be made once more after @p n_passes times.
    bool
    is_another_needed(const unsigned int n_passes) const;

    unsigned int                    corrector_iterations = 0;
    double                          corrector_tolerance  = .002;
    unsigned int                    maximal_corrections  = 1;
    unsigned int                    first_corrections    = 2;
    double                          blend                = 0.;
    SingleFluidFlowParameters<dim>  flow_parameters;
    Choice<VelocityProjection<dim>> projection;

    std::unique_ptr<FlowStepNumbers<dim>> numbers;
    std::unique_ptr<SingleFluidFlow<dim>> flow;
    Vector                                level_set;
    PopulationSnapshot<dim>               particles_at_start;
    PathFields<dim>                       path;
    Vector begin_acceleration, end_acceleration, velocity_star;
    Vector begin_velocity;                   ///< at the vertices
    mutable CellVelocity<dim> mean_velocity; ///< for others that go along
    /// Whether there was a step on this mesh.
    bool has_begun = false;
    /// Of the present pass.
    ConvectionReport report;
    unsigned int     n_added = 0;
  };
} // namespace Thalweg

#endif
