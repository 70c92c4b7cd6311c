// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/particle_budget.h>

namespace Thalweg
{
  namespace
  {
    std::string
    column(const std::string &part, const char *kind, const unsigned int fluid)
    {
      return "budget: " + part + ' ' + kind + ' ' + std::to_string(fluid + 1) +
             " [J]";
    }
  } // namespace



  template <int dim>
  ParticleBudget<dim>::ParticleBudget(const Parts<dim> &parts)
    : parts(parts)
  {}



  template <int dim>
  void
  ParticleBudget<dim>::begin(const double time)
  {
    if (!parts.context.has_energy_budget)
      return;
    gravity = parts.forces.gravity(time);
    last    = sum();
    for (const char *part :
         {"motion", "boundaries", "dispersal", "increment", "limit"})
      for (unsigned int f = 0; f < parts.fluids.size(); ++f)
        for (const char *kind : {"kinetic", "potential"})
          parts.context.statistics.set(column(part, kind, f), 0.);
  }



  template <int dim>
  void
  ParticleBudget<dim>::record(const std::string &part)
  {
    if (!parts.context.has_energy_budget)
      return;
    const Energies now        = sum();
    auto          &statistics = parts.context.statistics;
    for (unsigned int f = 0; f < parts.fluids.size(); ++f)
      {
        statistics.add(column(part, "kinetic", f),
                       now.kinetic[f] - last.kinetic[f]);
        statistics.add(column(part, "potential", f),
                       now.potential[f] - last.potential[f]);
      }
    last = now;
  }



  template <int dim>
  void
  ParticleBudget<dim>::end()
  {
    if (!parts.context.has_energy_budget)
      return;
    auto &statistics = parts.context.statistics;
    for (unsigned int f = 0; f < parts.fluids.size(); ++f)
      {
        statistics.set(column("particles", "kinetic", f), last.kinetic[f]);
        statistics.set(column("particles", "potential", f), last.potential[f]);
      }
  }



  template <int dim>
  void
  ParticleBudget<dim>::add(const Population<dim> &population,
                           Energies              &energies) const
  {
    const dealii::Point<dim> reference = parts.mesh.box().first;
    for (const auto &particle : population.handler())
      {
        const auto         properties = particle.get_properties();
        const unsigned int fluid      = Population<dim>::fluid_of(properties);
        const double       mass = parts.fluids.of_particle(fluid).density *
                            properties[Population<dim>::volume_offset];
        double square = 0.;
        for (const double v : Population<dim>::velocity_of(properties))
          square += v * v;
        energies.kinetic[fluid] += .5 * mass * square;
        energies.potential[fluid] -=
          mass * (gravity * (particle.get_location() - reference));
      }
  }



  template <int dim>
  typename ParticleBudget<dim>::Energies
  ParticleBudget<dim>::sum() const
  {
    Energies energies;
    add(parts.population, energies);
    if (parts.dispersed != nullptr)
      add(parts.dispersed->particles(), energies);
    for (auto *values : {&energies.kinetic, &energies.potential})
      for (double &value : *values)
        value = dealii::Utilities::MPI::sum(value, parts.context.communicator);
    return energies;
  }



  THALWEG_INSTANTIATE(ParticleBudget)
} // namespace Thalweg
