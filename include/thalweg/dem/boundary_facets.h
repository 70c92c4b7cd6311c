// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_boundary_facets_h
#define thalweg_dem_boundary_facets_h

#include <thalweg/dem/wall_geometry.h>
#include <thalweg/mesh/mesh.h>

#include <vector>

namespace Thalweg
{
  /// A part of a mesh's boundary: a facet, whose wall is not set, and where it
  /// belongs.
  struct BoundaryFacet
  {
    Facet                      facet;
    dealii::types::boundary_id boundary;
  };

  /**
   * @brief The boundary of a mesh as facets, the same on all ranks, in an order
   * that does not depend on them. Collective.
   *
   * Rectangles along the axes, and in two dimensions sides along these, are
   * joined, so that a box has six whatever its cells. Other sides of four
   * corners are two triangles. In two dimensions facets stand upright on the
   * plane.
   */
  template <int dim>
  std::vector<BoundaryFacet>
  boundary_facets(const Mesh<dim> &mesh);

  /// A polygon with its normal towards @p inside of it.
  Facet
  make_polygon(const std::vector<Vec3> &corners, const Vec3 &inside);
} // namespace Thalweg

#endif
