// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_tools_h
#define thalweg_mesh_geometries_tools_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /// Tools that several geometries share.
  namespace Geometries
  {
    /// The names of a box's sides: left, right, bottom, top, front, back are
    /// 0 to 5, in the order of the lower and upper side of x, y and z.
    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    box_sides();

    /// @throws dealii::ExcMessage unless @p upper is beyond @p lower in all
    /// directions; @p what begins the message, as in "The box"
    template <int dim>
    void
    check_corners(const dealii::Point<dim> &lower,
                  const dealii::Point<dim> &upper,
                  const std::string        &what);

    /// The number of cells of a box that is divided into so many in each
    /// direction.
    double
    n_cells(const std::vector<unsigned int> &repetitions);

    /**
     * @brief Numbers the boundary faces: those on a side of the box from
     * @p lower to @p upper as in box_sides(), all others 2 dim.
     */
    template <int dim>
    void
    color_box(dealii::Triangulation<dim> &triangulation,
              const dealii::Point<dim>   &lower,
              const dealii::Point<dim>   &upper);

    /**
     * @brief The sizes of the intervals of a grid line from @p lower to
     * @p upper that has nodes at all @p fixed positions and is divided as
     * evenly as they allow, into steps near @p size.
     *
     * Fixed positions outside, or closer to an earlier one than a millionth
     * of @p size, do not count.
     */
    std::vector<double>
    divide(const double        lower,
           const double        upper,
           std::vector<double> fixed,
           const double        size);

    /// The ids at the boundary of @p triangulation, each named by its number.
    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    numbered_boundaries(const dealii::Triangulation<dim> &triangulation);

    /**
     * @brief Copies the coarse mesh @p source with its ids and manifolds to
     * @p target.
     *
     * @param what names the mesh at the beginning of a message, as in
     *   "The mesh file 'a.msh'"
     * @throws dealii::ExcMessage if @p source has cells other than
     *   quadrilaterals and hexahedra, inverted cells, or is refined
     */
    template <int dim>
    void
    copy_coarse_mesh(const dealii::Triangulation<dim> &source,
                     dealii::Triangulation<dim>       &target,
                     const std::string                &what);

    /**
     * @brief Refuses the points of a mesh of two dimensions that do not lie in a
     * plane of constant z.
     * @param what names the mesh at the beginning of a message
     * @throws dealii::ExcMessage that says in which plane it lies
     */
    void
    check_plane(const std::vector<dealii::Point<3>> &points,
                const std::string                   &what);

    /**
     * @brief Turns cells inside out whose volume is negative.
     *
     * deal.II does so for what it reads, but computes the volumes from products
     * of coordinates, which are wrong for small cells far from the origin; here
     * they are counted from a point of the mesh.
     */
    template <int dim>
    void
    orient_cells(dealii::Triangulation<dim> &mesh);

    /// Throws a message that cell number @p cell of the mesh @p what is
    /// inverted.
    [[noreturn]] void
    refuse_cell(const std::string &what, const std::string &cell);

    /// Throws a message that cells of the mesh @p what are neither
    /// quadrilaterals nor hexahedra.
    [[noreturn]] void
    refuse_shapes(const std::string &what, const unsigned int dim);
  } // namespace Geometries
} // namespace Thalweg

#endif
