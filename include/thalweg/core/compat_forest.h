// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_compat_forest_h
#define thalweg_core_compat_forest_h

#include <deal.II/distributed/p4est_wrappers.h>

#include <p4est_io.h>
#include <p8est_io.h>

namespace Thalweg
{
  namespace Compat
  {
    /// p4est's functions that deal.II has no names for, in both dimensions.
    inline p4est_t *
    inflate(const MPI_Comm        communicator,
            p4est_connectivity_t *connectivity,
            const p4est_gloidx_t *first_of_rank,
            const p4est_gloidx_t *before_trees,
            sc_array_t           *quadrants)
    {
      return p4est_inflate(communicator,
                           connectivity,
                           first_of_rank,
                           before_trees,
                           quadrants,
                           nullptr,
                           nullptr);
    }

    inline p8est_t *
    inflate(const MPI_Comm        communicator,
            p8est_connectivity_t *connectivity,
            const p4est_gloidx_t *first_of_rank,
            const p4est_gloidx_t *before_trees,
            sc_array_t           *quadrants)
    {
      return p8est_inflate(communicator,
                           connectivity,
                           first_of_rank,
                           before_trees,
                           quadrants,
                           nullptr,
                           nullptr);
    }

    /// Refines cells until no two that touch differ by more than a level, as
    /// deal.II does.
    inline void
    balance(p4est_t *forest)
    {
      p4est_balance(forest, P4EST_CONNECT_FULL, nullptr);
    }

    inline void
    balance(p8est_t *forest)
    {
      p8est_balance(forest, P8EST_CONNECT_FULL, nullptr);
    }

    inline p4est_qcoord_t
    coordinate(const p4est_quadrant_t &quadrant, const unsigned int d)
    {
      return d == 0 ? quadrant.x : quadrant.y;
    }

    inline p4est_qcoord_t
    coordinate(const p8est_quadrant_t &quadrant, const unsigned int d)
    {
      return d == 0 ? quadrant.x : d == 1 ? quadrant.y : quadrant.z;
    }
  } // namespace Compat
} // namespace Thalweg

#endif
