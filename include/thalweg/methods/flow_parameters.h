// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_flow_parameters_h
#define thalweg_methods_flow_parameters_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_conditions.h>
#include <thalweg/fluid/fluid_solver.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/materials/fluids.h>
#include <thalweg/particles/population_control.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/particles/streamline_convection.h>
#include <thalweg/transfer/projection.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// What the input says of a flow: fluids, their boundaries and their start,
  /// and how particles and mesh share the work.
  template <int dim>
  struct FlowParameters
  {
    /// @param computes_flow whether the method does; else velocities are given
    explicit FlowParameters(const bool computes_flow);

    /// Declares the sections.
    void
    declare(const Section &sections);

    /// Appends faults that are seen without a mesh.
    void
    check(std::vector<std::string> &faults) const;

    /// Appends faults that are seen on the coarse mesh.
    void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const;

    /// What to say if a fluid is nowhere; empty: nothing.
    /// @param n_cells about how many the run begins with
    std::string
    missing_fluid(const Mesh<dim> &coarse, const double n_cells) const;

    /// Particles in a cell at the start.
    double
    particles_per_cell() const;

    /// Whether what the mesh does not see moves by itself.
    bool
    has_spray() const;

    const bool computes_flow;
    /// Whether the method does what FluidViscosities say.
    bool                        heeds_viscosities = false;
    Fluids                      fluids;
    BoundaryConditionParameters boundary_conditions;
    std::string initial_velocity  = dim == 2 ? "0; 0" : "0; 0; 0";
    std::string initial_level_set = "1";
    /// "sign" or "distance"
    std::string particles_carry = "distance";
    /// In smallest cell sizes: greater distances are cut off there.
    double                    distance_band = 1.;
    SeedingParameters         seeding;
    ConvectionParameters      convection;
    PopulationParameters<dim> population;
    /// "automatic", "ballistic" or "none"
    std::string                 spray = "automatic";
    InterfaceParameters         interface;
    Choice<Projection<dim>>     projection;
    Choice<InterfaceForce<dim>> interface_force;
    Choice<FluidSolver<dim>>    fluid_solver;
    bool                        energy_budget = false;

  private:
    void
    declare_start(const Section &section);

    void
    declare_particles(const Section &section);

    /// @throws dealii::ExcMessage if the particles carry no fluid
    void
    check_distance_band() const;
  };
} // namespace Thalweg

#endif
