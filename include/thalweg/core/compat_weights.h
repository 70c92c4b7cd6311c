// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_compat_weights_h
#define thalweg_core_compat_weights_h

#include <deal.II/base/config.h>
#include <deal.II/grid/tria.h>

#include <boost/signals2/connection.hpp>

namespace Thalweg
{
  namespace Compat
  {
    /// What happens to a cell while the mesh changes.
    enum class CellFate
    {
      /// remains
      persists,
      /// is refined; the question is about any one of its children
      is_refined,
      /// is the parent of cells that are going to vanish into it
      is_coarsened
    };

#if DEAL_II_VERSION_GTE(9, 6, 0)
    using CellStatus = dealii::CellStatus;

    template <int>
    CellFate
    fate(const CellStatus status)
    {
      if (status == CellStatus::cell_will_persist)
        return CellFate::persists;
      return status == CellStatus::children_will_be_coarsened
               ? CellFate::is_coarsened
               : CellFate::is_refined;
    }
#else
    template <int dim>
    CellFate
    fate(const typename dealii::Triangulation<dim>::CellStatus status)
    {
      using Triangulation = dealii::Triangulation<dim>;
      if (status == Triangulation::CELL_PERSIST)
        return CellFate::persists;
      return status == Triangulation::CELL_COARSEN ? CellFate::is_coarsened
                                                   : CellFate::is_refined;
    }
#endif

    /**
     * @brief Lets @p weight decide how much a cell counts when cells are
     * distributed over the processes.
     *
     * The signal is called `weight` and adds nothing of its own from deal.II
     * 9.4 on; where the type of the status lives changed in 9.6.
     *
     * @param weight called as `weight(cell, fate)`, returns unsigned int
     */
    template <int dim, typename Weight>
    boost::signals2::connection
    connect_weight(dealii::Triangulation<dim> &triangulation,
                   const Weight               &weight)
    {
      return triangulation.signals.weight.connect(
        [weight](const auto &cell, const auto status) -> unsigned int {
          return weight(cell, fate<dim>(status));
        });
    }
  } // namespace Compat
} // namespace Thalweg

#endif
