// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_division_h
#define thalweg_mesh_geometries_division_h

#include <deal.II/grid/tria.h>

#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /**
     * @brief Fills @p target with quadrilaterals or hexahedra, one for each
     * corner of each cell of @p source, between the corner and the middles of
     * edges, faces and the cell.
     *
     * So a triangle becomes three quadrilaterals, a tetrahedron four hexahedra
     * and a wedge six. Boundary and material ids are kept.
     *
     * @param what names the mesh at the beginning of a message
     * @throws dealii::ExcMessage for pyramids, at whose tip four edges meet
     */
    template <int dim>
    void
    divide_into_cubes(const dealii::Triangulation<dim> &source,
                      dealii::Triangulation<dim>       &target,
                      const std::string                &what);
  } // namespace Geometries
} // namespace Thalweg

#endif
