// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_overlap_h
#define thalweg_mesh_geometries_overlap_h

#include <deal.II/grid/tria.h>

#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /**
     * @brief Refuses a coarse mesh in which a cell lies in another one, wholly
     * or with a corner, whatever they have in common otherwise.
     * @param what names the mesh at the beginning of a message
     * @throws dealii::ExcMessage that says which cells, and where
     */
    template <int dim>
    void
    check_overlap(const dealii::Triangulation<dim> &mesh,
                  const std::string                &what);
  } // namespace Geometries
} // namespace Thalweg

#endif
