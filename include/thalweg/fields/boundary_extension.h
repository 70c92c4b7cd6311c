// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_boundary_extension_h
#define thalweg_fields_boundary_extension_h

#include <thalweg/fields/flow_boundary.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Carries a vector field from the interior to the nodes where the
   * velocity is given or zero: each gets the mean of the free nodes of the
   * cells around it.
   */
  template <int dim>
  class BoundaryExtension
  {
  public:
    /// @param space must outlive the object
    /// @param boundary whose nodes are meant; slip walls are not
    BoundaryExtension(const LagrangeSpace<dim> &space,
                      const FlowBoundary<dim>  &boundary);

    /**
     * @brief Extends a field. Collective.
     * @param field with dim components at free nodes; those at the boundary
     *   do not count
     * @param extension out: the values at the boundary's nodes, zero at all
     *   others and where a boundary node has no free node beside it; ghosted
     */
    void
    extend(const Vector &field, Vector &extension) const;

  private:
    const LagrangeSpace<dim> &space;
    /// Owned nodes that get values, and one over the number of free nodes.
    std::vector<unsigned int> nodes;
    std::vector<double>       shares;
    /// 1 at nodes whose value is free, less where they depend on others.
    Vector         is_free;
    mutable Vector work;
  };
} // namespace Thalweg

#endif
