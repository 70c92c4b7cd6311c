// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/step_snapshot.h>

namespace Thalweg
{
  template <int dim>
  void
  StepSnapshot<dim>::save(SimulationParts<dim> &parts)
  {
    values = Archive();
    const State<dim> state(values);
    parts.keep(state);
    fields.resize(state.fields().size());
    for (unsigned int i = 0; i < fields.size(); ++i)
      fields[i] = *state.fields()[i].vector;
    particles.save(parts.particles());
    dispersed.save(parts.dispersed());
  }



  template <int dim>
  void
  StepSnapshot<dim>::restore(SimulationParts<dim> &parts) const
  {
    const State<dim> state(values.reader());
    parts.keep(state);
    for (unsigned int i = 0; i < fields.size(); ++i)
      {
        const auto &field = state.fields()[i];
        field.vector->zero_out_ghost_values();
        field.vector->copy_locally_owned_data_from(fields[i]);
        field.space->interpolate(*field.vector, field.n_components);
      }
    particles.restore(parts.particles());
    dispersed.restore(parts.dispersed());
    parts.update();
  }



  THALWEG_INSTANTIATE(StepSnapshot)
} // namespace Thalweg
