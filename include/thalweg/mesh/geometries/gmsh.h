#ifndef thalweg_mesh_geometries_gmsh_h
#define thalweg_mesh_geometries_gmsh_h

#include <deal.II/base/tensor.h>

#include <istream>
#include <map>
#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /**
     * @brief The names that Gmsh gives to physical groups of one dimension, in
     * the section $PhysicalNames of a msh file of any version in ASCII.
     * @param dimension of the groups: one less than that of the mesh for its
     *   boundaries
     * @param what names the mesh at the beginning of a message
     * @return the groups' numbers, nothing if the file has no such section
     * @throws dealii::ExcMessage if two groups have one name, or the section
     *   cannot be read
     */
    std::map<std::string, unsigned int>
    physical_names(std::istream      &file,
                   const unsigned int dimension,
                   const std::string &what);

    /**
     * @brief A msh file of version 2 or 4.1 in ASCII as text, with all nodes
     * moved near the origin if they are far from it compared with their extent.
     *
     * deal.II multiplies coordinates when it reads cells, and cannot tell
     * apart small ones far away. Other files are left as they are.
     * @param offset becomes what has to be added to coordinates, m
     */
    std::string
    near_origin(std::istream &file, dealii::Tensor<1, 3> &offset);
  } // namespace Geometries
} // namespace Thalweg

#endif
