// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_redistance_h
#define thalweg_interface_redistance_h

#include <thalweg/fields/node_space.h>

namespace Thalweg
{
  /**
   * @brief Turns a level set into the signed distance to its own zero
   * contour, within two cells of it; farther away the value is cut off.
   *
   * The contour is the one of the cut cells (SimplexCut): segments in 2D,
   * triangles in 3D. Each node takes the distance to the nearest of these
   * facets in two rings of cells around it. Where the contour ends at a
   * boundary of the domain it is continued beyond it in its own plane, so that
   * a plane that meets a wall at any angle remains a plane; across periodic
   * boundaries it goes on.
   *
   * Why: the pressure's enrichment has the kink of |phi|. If the slope of
   * phi varies along the interface, so does that kink, and a hydrostatic
   * pressure is missed by a part of density times gravity times cell size.
   * The lighter fluid answers with accelerations larger by the ratio of
   * densities.
   */
  template <int dim>
  class Redistance
  {
  public:
    explicit Redistance(const NodeSpace<dim> &space);

    /**
     * @brief Replaces @p phi, keeping its signs at the nodes. Collective.
     * @param phi ghosted, consistent with the constraints; so it is left
     */
    void
    apply(Vector &phi) const;

  private:
    const NodeSpace<dim> &space;
  };
} // namespace Thalweg

#endif
