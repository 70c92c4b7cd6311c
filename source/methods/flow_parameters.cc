// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/flow_parameters.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  FlowParameters<dim>::FlowParameters(const bool computes_flow)
    : computes_flow(computes_flow)
  {}



  template <int dim>
  void
  FlowParameters<dim>::declare(const Section &sections)
  {
    fluids.declare_parameters(sections);
    declare_start(sections.enter("Initial conditions"));
    boundary_conditions.declare(sections);
    declare_particles(sections.enter("Particles"));
    projection.declare_parameters(sections.enter("Projection"),
                                  "least squares",
                                  "projection from particles to the mesh");
    interface.declare(sections);
    interface_force.declare_parameters(
      sections.enter("Interface").enter("Surface tension"),
      "sharp",
      "way in which surface tension acts");
    fluid_solver.declare_parameters(sections.enter("Fluid solver"),
                                    "fractional step",
                                    "solver of the flow equations");
    sections.enter("Statistics")
      .add("Energy budget",
           energy_budget,
           "",
           "Whether `statistics.csv` says what each part of a step does "
           "to the energy of particles and mesh, in columns that begin "
           "with `budget`; for two fluids.");
  }



  template <int dim>
  void
  FlowParameters<dim>::declare_start(const Section &section)
  {
    section.add("Velocity",
                initial_velocity,
                "m/s",
                "A function of x, y and z with a semicolon between the "
                "components.",
                dealii::Patterns::Anything());
    section.add("Level set",
                initial_level_set,
                "m",
                "A function of x, y and z that is negative in the first "
                "fluid and positive in the second. It need not be a "
                "distance: particles that carry one find it.",
                dealii::Patterns::Anything());
  }



  template <int dim>
  void
  FlowParameters<dim>::declare_particles(const Section &section)
  {
    seeding.declare_parameters(section);
    convection.declare_parameters(section);
    population.declare_parameters(section);
    section.add("Carry",
                particles_carry,
                "",
                "What tells the fluids apart: the sign of the level set "
                "(Eq. 69), or the distance from where it vanishes at the "
                "start, which makes for a smoother interface and keeps the "
                "volume better; or its value as it is, whatever that means "
                "(a concentration).",
                dealii::Patterns::Selection("sign|distance|value"));
    section.add("Distance band",
                distance_band,
                "",
                "At how many times the shortest edge of a particle's cell "
                "the distance that it carries is cut off before it is "
                "projected, where the flow has distorted distances: those "
                "from farther away say nothing about the surface.",
                dealii::Patterns::Double(0));
    section.add("Spray",
                spray,
                "",
                "What becomes of particles where the mesh shows the other "
                "fluid, since drops, jets and bubbles are finer than its "
                "cells: drops fly freely on parabolas and bubbles rise until "
                "they are back in their own fluid (`ballistic`), or all are "
                "carried by the fluid around them (`none`). `automatic` is "
                "`ballistic` if the first fluid is at least a hundred times "
                "as dense as the second. Where particles carry values that "
                "are neither a sign nor a distance, there is none.",
                dealii::Patterns::Selection("automatic|ballistic|none"));
  }



  template <int dim>
  bool
  FlowParameters<dim>::has_spray() const
  {
    if (fluids.size() == 1 || !computes_flow || spray == "none" ||
        particles_carry == "value")
      return false;
    constexpr double as_in_a_vacuum = 100.;
    return spray == "ballistic" ||
           fluids[0].density >= as_in_a_vacuum * fluids[1].density;
  }



  template <int dim>
  double
  FlowParameters<dim>::particles_per_cell() const
  {
    return std::pow(seeding.particles_per_direction, dim);
  }



#define THALWEG_INSTANTIATE_PARAMETERS(dim)                      \
  template FlowParameters<dim>::FlowParameters(const bool);      \
  template void   FlowParameters<dim>::declare(const Section &); \
  template bool   FlowParameters<dim>::has_spray() const;        \
  template double FlowParameters<dim>::particles_per_cell() const;
  THALWEG_INSTANTIATE_PARAMETERS(2)
  THALWEG_INSTANTIATE_PARAMETERS(3)
#undef THALWEG_INSTANTIATE_PARAMETERS
} // namespace Thalweg
