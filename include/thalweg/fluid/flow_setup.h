// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_flow_setup_h
#define thalweg_fluid_flow_setup_h

#include <thalweg/core/context.h>
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/fluid/flow_terms.h>
#include <thalweg/fluid/fluid_viscosities.h>
#include <thalweg/interface/interface_force.h>
#include <thalweg/interface/phase_field.h>

namespace Thalweg
{
  /// What a FluidSolver stands on.
  template <int dim>
  struct FlowSetup
  {
    Context                     &context;
    const NodeSpace<dim>        &space;
    const BoundaryNodes<dim>    &boundary;
    const PhaseField<dim>       &phase;
    const BodyForces<dim>       &forces;
    const FlowTerms<dim>        &terms;
    const FluidViscosities<dim> &viscosities;
    InterfaceForce<dim>         *tension = nullptr; ///< nullptr: none
  };
} // namespace Thalweg

#endif
