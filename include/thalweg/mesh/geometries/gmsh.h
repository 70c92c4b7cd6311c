// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_gmsh_h
#define thalweg_mesh_geometries_gmsh_h

#include <thalweg/mesh/geometries/mesh_outline.h>

#include <deal.II/base/tensor.h>

#include <map>
#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /// What a msh file says.
    struct GmshFile
    {
      MeshOutline outline;
      /// The numbers of physical groups by their names, for each dimension.
      std::map<unsigned int, std::map<std::string, unsigned int>> names;
    };

    /**
     * @brief Reads a msh file of Gmsh in ASCII, of version 1, 2, 4.0 or 4.1.
     * @param refusal the beginning of messages, as in "The mesh file 'a.msh'
     *   cannot be read"
     * @throws dealii::ExcMessage if something is not as it has to be, or two
     *   physical groups have one name
     */
    GmshFile
    read_gmsh(const std::string &text, const std::string &refusal);

    /**
     * @brief Cells and sides of @p outline as a msh file of version 2.2, for
     * deal.II to read.
     *
     * Nodes are moved near the origin if they are far from it compared with
     * their extent: deal.II multiplies coordinates when it reads cells, and
     * cannot tell apart small ones far away.
     * @param dim dimension of the cells
     * @param offset becomes what has to be added to coordinates, m
     */
    std::string
    gmsh_text(const MeshOutline    &outline,
              const unsigned int    dim,
              dealii::Tensor<1, 3> &offset);
  } // namespace Geometries
} // namespace Thalweg

#endif
