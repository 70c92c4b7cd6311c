// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/particle_budget.h>

namespace Thalweg
{
  template <int dim>
  ParticleBudget<dim>::ParticleBudget(const Parts<dim> &parts)
    : parts(parts)
  {}



  template <int dim>
  template <typename Action>
  void
  ParticleBudget<dim>::for_each_column(const std::string &part,
                                       const Action      &action) const
  {
    unsigned int number = 0;
    for (unsigned int f = 0; f < parts.fluids.size(); ++f)
      for (const char *kind : {"kinetic", "potential"})
        action("budget: " + part + ' ' + kind + ' ' + std::to_string(f + 1) +
                 " [J]",
               number++);
  }



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
      for_each_column(part, [this](const std::string &column, unsigned int) {
        parts.context.statistics.set(column, 0.);
      });
  }



  template <int dim>
  void
  ParticleBudget<dim>::record(const std::string &part)
  {
    if (!parts.context.has_energy_budget)
      return;
    const Energies now = sum();
    for_each_column(part, [&](const std::string &column, const unsigned int i) {
      parts.context.statistics.add(column, now[i] - last[i]);
    });
    last = now;
  }



  template <int dim>
  void
  ParticleBudget<dim>::end()
  {
    if (!parts.context.has_energy_budget)
      return;
    for_each_column("particles",
                    [this](const std::string &column, const unsigned int i) {
                      parts.context.statistics.set(column, last[i]);
                    });
  }



  template <int dim>
  void
  ParticleBudget<dim>::add(const Population<dim> &population,
                           Energies              &energies) const
  {
    const dealii::Point<dim> reference = parts.mesh.box().first;
    for (const auto &particle : population.particles())
      {
        const auto         properties = particle.properties();
        const unsigned int fluid      = Population<dim>::fluid_of(properties);
        const double       mass = parts.fluids.of_particle(fluid).density *
                            properties[Population<dim>::volume_offset];
        double square = 0.;
        for (const double v : Population<dim>::velocity_of(properties))
          square += v * v;
        energies[2 * fluid] += .5 * mass * square;
        energies[2 * fluid + 1] -=
          mass * (gravity * (particle.position() - reference));
      }
  }



  template <int dim>
  typename ParticleBudget<dim>::Energies
  ParticleBudget<dim>::sum() const
  {
    Energies energies{};
    add(parts.population, energies);
    if (parts.dispersed != nullptr)
      add(parts.dispersed->particles(), energies);
    const dealii::ArrayView<double> view(energies.data(), energies.size());
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(view),
                                parts.context.communicator,
                                view);
    return energies;
  }



  THALWEG_INSTANTIATE(ParticleBudget)
} // namespace Thalweg
