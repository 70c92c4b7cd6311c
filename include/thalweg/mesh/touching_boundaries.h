// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_touching_boundaries_h
#define thalweg_mesh_touching_boundaries_h

#include <thalweg/mesh/mesh_plan.h>

#include <deal.II/grid/tria.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief What to tell users about boundary faces of a coarse mesh that lie
   * on each other from opposite sides, as those of two blocks whose nodes were
   * not merged: how many, of which boundaries, and where.
   * @param names of the boundaries
   * @return nothing if there are none; periodic faces do not count
   */
  template <int dim>
  std::string
  touching_boundaries(const dealii::Triangulation<dim> &coarse,
                      const BoundaryNames              &names);

  /**
   * @brief Refuses a coarse mesh with nodes that are there twice, or that lie
   * on the side of a cell whose node they are not.
   *
   * Boundary faces that lie on each other are a thin wall if they all have
   * boundary ids other than zero, which they have if nobody gave them one.
   * @param what names the mesh at the beginning of a message
   * @throws dealii::ExcMessage
   */
  template <int dim>
  void
  refuse_doubled_nodes(const dealii::Triangulation<dim> &coarse,
                       const std::string                &what);
} // namespace Thalweg

#endif
