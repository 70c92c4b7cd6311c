// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_medium_h
#define thalweg_methods_medium_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/materials/fluids.h>

namespace Thalweg
{
  /// What a method of a flow offers, on each mesh anew, under "medium": where
  /// which fluid is, and the boundaries around them.
  template <int dim>
  struct Medium
  {
    const NodeSpace<dim>     &space;
    const Fluids             &fluids;
    const PhaseField<dim>    &phase;
    const BoundaryNodes<dim> &boundary;
  };
} // namespace Thalweg

#endif
