// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_compat_h
#define thalweg_core_compat_h

#include <deal.II/base/config.h>
#include <deal.II/dofs/dof_handler.h>

namespace Thalweg
{
  /// Everything that differs between versions of deal.II.
  namespace Compat
  {
    /// The cell of a triangulation as a cell of @p dofs (a member function
    /// of the cell itself from deal.II 9.5 on).
    template <typename CellIterator, int dim>
    typename dealii::DoFHandler<dim>::active_cell_iterator
    on_dof_handler(const CellIterator            &cell,
                   const dealii::DoFHandler<dim> &dofs)
    {
      return typename dealii::DoFHandler<dim>::active_cell_iterator(
        &dofs.get_triangulation(), cell->level(), cell->index(), &dofs);
    }
  } // namespace Compat
} // namespace Thalweg

#endif
