// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/block_preconditioner.h>

namespace Thalweg
{
  template <int dim>
  BlockPreconditioner<dim>::BlockPreconditioner(
    const CoupledParts<dim>  &parts,
    const CoupledSystem<dim> &system,
    const VelocityBlock<dim> &velocity_block,
    const SchurBlock<dim>    &schur_block)
    : parts(parts)
    , system(system)
    , velocity_block(velocity_block)
    , schur_block(schur_block)
  {
    initialize(parts.space, load);
    initialize(parts.space, pressure);
    parts.space.initialize_velocity(gradient);
    parts.space.initialize_velocity(change);
  }



  template <int dim>
  void
  BlockPreconditioner<dim>::vmult(CoupledFlow       &result,
                                  const CoupledFlow &rows) const
  {
    get_pressure(rows, load);
    load *= system.continuity_scale();
    parts.pressure.remove_given(nodal(load));
    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      pressure.block(b).zero_out_ghost_values();
    schur_block.vmult(pressure, load);
    parts.pressure.remove_given(nodal(pressure));
    set_pressure(pressure, result);

    for (unsigned int b = 0; b < pressure.n_blocks(); ++b)
      parts.space.interpolate(pressure.block(b), 1);
    parts.pressure.accelerate(pressure, false, parts.mass, gradient);
    gradient.zero_out_ghost_values();
    system.add_jumps(pressure, gradient);
    gradient.add(system.momentum_scale(), velocity(rows));
    const Vector &masses = parts.mass.lumped();
    for (unsigned int n = 0; n < masses.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        gradient.local_element(dim * n + d) *=
          masses.local_element(n) / system.part_of_end();
    parts.boundary.project(gradient);
    velocity_block.vmult(change, gradient);
    velocity(result).copy_locally_owned_data_from(change);
  }



  THALWEG_INSTANTIATE(BlockPreconditioner)
} // namespace Thalweg
