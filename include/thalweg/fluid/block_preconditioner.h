// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_block_preconditioner_h
#define thalweg_fluid_block_preconditioner_h

#include <thalweg/fluid/coupled_system.h>
#include <thalweg/fluid/schur_block.h>
#include <thalweg/fluid/velocity_block.h>

namespace Thalweg
{
  /**
   * @brief The block triangular preconditioner of a CoupledSystem: with
   * approximations of the Schur complement S and of the velocity's block A,
   *
   *   p = S^{-1} r_p,   w = A^{-1} (r_w - G p),
   *
   * after which, were both exact, two iterations would do (H. Elman,
   * D. Silvester, A. Wathen, Finite elements and fast iterative solvers, 2014).
   */
  template <int dim>
  class BlockPreconditioner
  {
  public:
    /// All must outlive the object.
    BlockPreconditioner(const CoupledParts<dim>  &parts,
                        const CoupledSystem<dim> &system,
                        const VelocityBlock<dim> &velocity_block,
                        const SchurBlock<dim>    &schur_block);

    /// Collective.
    void
    vmult(CoupledFlow &result, const CoupledFlow &rows) const;

  private:
    const CoupledParts<dim>   parts;
    const CoupledSystem<dim> &system;
    const VelocityBlock<dim> &velocity_block;
    const SchurBlock<dim>    &schur_block;
    mutable EnrichedPressure  load, pressure;
    mutable Vector            gradient, change;
  };
} // namespace Thalweg

#endif
