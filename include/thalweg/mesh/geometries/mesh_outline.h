// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_mesh_outline_h
#define thalweg_mesh_geometries_mesh_outline_h

#include <thalweg/mesh/geometries/words.h>

#include <deal.II/base/point.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace Thalweg
{
  namespace Geometries
  {
    /// Shapes of elements, with the numbers that Gmsh gives them.
    enum class Shape
    {
      line          = 1,
      triangle      = 2,
      quadrilateral = 3,
      tetrahedron   = 4,
      hexahedron    = 5,
      point         = 15
    };

    unsigned int
    n_nodes(const Shape shape);

    unsigned int
    dimension_of(const Shape shape);

    /**
     * @brief What a mesh file says, before anything is made of it: its nodes,
     * and which of them belong to which element.
     *
     * deal.II trusts in files. What it is given to read is looked through
     * beforehand, and refused in one sentence with the line.
     */
    struct MeshOutline
    {
      struct Element
      {
        Shape        shape;
        int          tag    = 0; ///< boundary or material id
        std::int64_t number = 0; ///< in the file
        unsigned int line   = 0; ///< of the file
        /// Indices of points: around a quadrilateral; of a hexahedron around
        /// one face and then the opposite one.
        std::vector<unsigned int> nodes;
      };

      std::vector<dealii::Point<3>> points;
      std::vector<Element>          elements;

      /// Adds a node. @param words where it stands
      /// @throws dealii::ExcMessage if there is another of this number
      void
      add_point(const Words            &words,
                const std::int64_t      number,
                const dealii::Point<3> &point);

      /// Reads the numbers of @p element 's nodes and adds it.
      /// @throws dealii::ExcMessage if a node is not there, or twice
      void
      add_element(Words &words, Element element);

      /// The index of a node. @throws dealii::ExcMessage if it is not there
      unsigned int
      index(const Words &words, const std::int64_t number) const;

      /// Whether all elements of @p dimension are quadrilaterals or hexahedra.
      bool
      has_only_cubes(const unsigned int dimension) const;

      /// The first plane quadrilateral that is not convex, its number among the
      /// elements of two dimensions and its place; empty: there is none.
      std::string
      first_twisted() const;

      /// The nodes of the elements of @p dimension, some more than once.
      std::vector<dealii::Point<3>>
      points_of_cells(const unsigned int dimension) const;

    private:
      std::unordered_map<std::int64_t, unsigned int> indices;
    };

    /**
     * @brief Refuses outlines of which no mesh of @p dim dimensions follows:
     * elements that are there twice, sides where more than two cells meet,
     * boundary elements that are no side of a cell.
     * @param refusal the beginning of messages
     * @throws dealii::ExcMessage
     */
    void
    check_outline(const MeshOutline &outline,
                  const unsigned int dim,
                  const std::string &refusal);

    /// The outline of a file in the legacy format of VTK, in UCD, or in UNV.
    /// @throws dealii::ExcMessage for files that cannot be understood
    MeshOutline
    outline_of_vtk(const std::string &text, const std::string &refusal);
    MeshOutline
    outline_of_ucd(const std::string &text, const std::string &refusal);
    MeshOutline
    outline_of_unv(const std::string &text, const std::string &refusal);

    /// The outline of a mesh of @p dim dimensions in the format of libMesh, of
    /// BAMG, or of Tecplot, of which only the cells of zones of finite elements
    /// are looked at, with points that are all the same.
    /// @throws dealii::ExcMessage for files that cannot be understood
    MeshOutline
    outline_of_xda(const std::string &text,
                   const unsigned int dim,
                   const std::string &refusal);
    MeshOutline
    outline_of_dbmesh(const std::string &text, const std::string &refusal);
    MeshOutline
    outline_of_tecplot(const std::string &text,
                       const unsigned int dim,
                       const std::string &refusal);

    /// The nodes and elements of a file of Abaqus for a mesh of @p dim
    /// dimensions. Its sets and surfaces are not looked at.
    /// @throws dealii::ExcMessage for files that cannot be understood
    MeshOutline
    outline_of_abaqus(const std::string &text,
                      const unsigned int dim,
                      const std::string &refusal);
  } // namespace Geometries
} // namespace Thalweg

#endif
