// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/population_snapshot.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  template <int dim>
  void
  PopulationSnapshot<dim>::save(const Population<dim> &population)
  {
    rows          = population.all();
    begin_of_cell = population.beginnings();
    begin_of_cell.resize(population.mesh().graph().n_owned_cells() + 1,
                         rows.size());
  }


  template <int dim>
  void
  PopulationSnapshot<dim>::restore(Population<dim> &population) const
  {
    AssertThrow(begin_of_cell.size() ==
                  population.mesh().graph().n_owned_cells() + 1,
                dealii::ExcMessage(
                  "Particles can only be put back into the cells that they "
                  "were in: save them again after each change of the mesh."));
    population.exchange(ParticleRows<dim>(rows),
                        std::vector<unsigned int>(begin_of_cell));
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::PopulationSnapshot)
