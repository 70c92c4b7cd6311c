// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/simulation/step_snapshot.h>

namespace Thalweg
{
  template <int dim>
  void
  StepSnapshot<dim>::save(const Keep &keep)
  {
    values = Archive();
    const State<dim> state(values);
    keep(state);
    fields.resize(state.fields().size());
    for (unsigned int i = 0; i < fields.size(); ++i)
      fields[i] = *state.fields()[i].vector;
    for (const auto &[name, item] : state.carried())
      item->save();
  }



  template <int dim>
  void
  StepSnapshot<dim>::restore(const Keep &keep) const
  {
    const State<dim> state(values.reader());
    keep(state);
    for (unsigned int i = 0; i < state.fields().size(); ++i)
      {
        const auto &field = state.fields()[i];
        field.vector->zero_out_ghost_values();
        field.vector->copy_locally_owned_data_from(fields[i]);
        field.space->interpolate(*field.vector, field.n_components);
      }
    for (const auto &[name, item] : state.carried())
      item->restore();
  }



  THALWEG_INSTANTIATE(StepSnapshot)
} // namespace Thalweg
