// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/single_fluid_flow_parameters.h>

namespace Thalweg
{
  void
  IncrementalStepParameters::declare_parameters(const Section &section)
  {
    section.add("Viscous theta",
                viscous_theta,
                "",
                "Implicit part of the viscous forces (Eq. 68): 0 explicit, "
                "1/2 the trapezoidal rule, 1 implicit. Steps of second order "
                "are so with 1/2 and with 1, since the implicit solve only "
                "replaces a guess; 1 damps what the mesh cannot resolve. Below "
                "1/2 steps are limited by the Fourier number (Eq. 65).",
                dealii::Patterns::Double(0, 1));
    section.add("Pressure gamma",
                pressure_gamma,
                "",
                "1: particles feel the last pressure on their way and the mesh "
                "solves for its increment (second order); 0: the mesh solves "
                "for all of it (Eq. 70).",
                dealii::Patterns::Integer(0, 1));
    section.add("Splitting iterations",
                iterations,
                "",
                "How often velocity and pressure are solved for in turn; more "
                "than one removes the splitting error.",
                dealii::Patterns::Integer(1));
    section.add("Rotational",
                rotational,
                "",
                "Whether the pressure increment takes the divergence of the "
                "predictor along, which spares it a false boundary layer.");
    section.add("Pressure tolerance",
                pressure_tolerance,
                "",
                "Residual of the pressure equation relative to its right hand "
                "side.",
                dealii::Patterns::Double(0, 1));
    section.add("Velocity tolerance",
                velocity_tolerance,
                "",
                "Residual of the equations for velocities and accelerations "
                "relative to the momentum.",
                dealii::Patterns::Double(0, 1));
    section.add("Maximal linear iterations",
                maximal_cg_iterations,
                "",
                "A linear solver that needs more fails.",
                dealii::Patterns::Integer(1));
  }



  template <int dim>
  void
  SingleFluidFlowParameters<dim>::declare_parameters(const Section &section)
  {
    section.add("Velocity degree",
                velocity_degree,
                "",
                "Degree of the finite elements of the velocity.",
                dealii::Patterns::Integer(1, 2));
    section.add("Pressure degree",
                pressure_degree,
                "",
                "Degree of the finite elements of the pressure; one less than "
                "that of the velocity (Taylor-Hood), or the same with a "
                "stabilization.",
                dealii::Patterns::Integer(1, 2));
    section.add("Mass",
                mass,
                "",
                "The mass matrix of the mesh: `consistent`, `lumped` (by "
                "quadrature at the nodes), or `by degree`: consistent for "
                "velocities of degree 1, lumped for those of degree 2.",
                dealii::Patterns::Selection("by degree|consistent|lumped"));
    section.add("Time integration",
                order,
                "",
                "`first order`: particles follow the last velocity and feel "
                "the explicit part of the last forces on their way (Eq. 81). "
                "`second order`: both are linear in time during the step, "
                "extrapolated at first, and the implicit solve replaces the "
                "part of the end.",
                dealii::Patterns::Selection("first order|second order"));
    section.add("Explicit pressure",
                explicit_pressure,
                "",
                "The pressure that particles feel on their way. `consistent`: "
                "it is found from the velocity by a Poisson equation of its "
                "own, at the beginning of the step, and extrapolated to its "
                "end; `incremental`: that of the last step (Eq. 81), with its "
                "rate of change in steps of second order. The latter forgets "
                "errors only slowly where particles cross a vortex in one "
                "step.",
                dealii::Patterns::Selection("consistent|incremental"));
    step.declare_parameters(section);
    stabilization.declare_parameters(section.enter("Stabilization"),
                                     "oss",
                                     "stabilization of the pressure");
  }



  template <int dim>
  bool
  SingleFluidFlowParameters<dim>::is_lumped() const
  {
    return mass == "lumped" || (mass == "by degree" && velocity_degree == 2);
  }



  template <int dim>
  void
  SingleFluidFlowParameters<dim>::check() const
  {
    AssertThrow(pressure_degree <= velocity_degree,
                dealii::ExcMessage(
                  "The 'Pressure degree' of 'Method/single fluid pfem2' must "
                  "not be above the 'Velocity degree': write 1 and 2, 1 and "
                  "1, or 2 and 2."));
    AssertThrow(pressure_degree < velocity_degree || step.pressure_gamma == 0 ||
                  stabilization->is_active(),
                dealii::ExcMessage(
                  "With equal degrees for velocity and pressure and 'Pressure "
                  "gamma = 1' the pressure would oscillate: choose a "
                  "'Stabilization/Model', for example 'oss'."));
  }



  template struct SingleFluidFlowParameters<2>;
  template struct SingleFluidFlowParameters<3>;
} // namespace Thalweg
