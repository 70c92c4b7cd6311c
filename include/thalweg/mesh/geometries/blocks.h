// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_blocks_h
#define thalweg_mesh_geometries_blocks_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// Tools for coarse meshes that are put together from blocks of cells.
  namespace Geometries
  {
    /// About how many intervals graded_lengths() returns.
    double
    n_graded(const double length, const double first, const double last);

    /**
     * @brief The lengths of intervals that fill @p length and change from
     * near @p first to near @p last by a constant factor.
     * @return at least one, in m
     */
    std::vector<double>
    graded_lengths(const double length, const double first, const double last);

    /// Where intervals of these @p lengths begin and end, from @p start on.
    std::vector<double>
    positions(const double start, const std::vector<double> &lengths);

    /// The lengths of @p n intervals that fill @p length, each @p growth times
    /// as long as the one before.
    std::vector<double>
    geometric_lengths(const double       length,
                      const double       growth,
                      const unsigned int n);

    /**
     * @brief The positions of @p n intervals that fill zero to @p length,
     * the first being @p first long, each longer than the one before by the
     * same factor (shorter, where @p first is more than the mean).
     * @return n + 1 positions
     */
    std::vector<double>
    geometric_positions(const double       length,
                        const double       first,
                        const unsigned int n);

    /**
     * @brief A plane mesh of quadrilaterals in the making. Blocks that touch
     * share their vertices.
     */
    class PlaneBlocks
    {
    public:
      /// @param tolerance vertices closer than this are one, m
      explicit PlaneBlocks(const double tolerance);

      /// One cell; the corners are anticlockwise, and the first directions
      /// are from @p a to @p b and from @p a to @p d. Lines that face each
      /// other in a cell must point the same way in all cells.
      void
      add_cell(const dealii::Point<2> &a,
               const dealii::Point<2> &b,
               const dealii::Point<2> &c,
               const dealii::Point<2> &d);

      /// The axis-parallel cells between the lines @p x and @p y.
      void
      add_grid(const std::vector<double> &x, const std::vector<double> &y);

      /// Fills @p mesh.
      void
      create(dealii::Triangulation<2> &mesh) const;

    private:
      unsigned int
      vertex(const dealii::Point<2> &point);

      /// A square of the size of the tolerance.
      using Square = std::pair<double, double>;

      double                        tolerance;
      std::vector<dealii::Point<2>> vertices;
      /// The vertices in each square.
      std::multimap<Square, unsigned int> in_square;
      std::vector<dealii::CellData<2>>    cells;
    };

    /// The boundary id of the sides that a plane mesh has beside those of a
    /// box, whose ids are 0 to 5 in box_sides().
    constexpr dealii::types::boundary_id first_own_id = 6;

    /**
     * @brief Makes the plane mesh @p section the coarse mesh @p target: as it
     * is in 2D, in 3D drawn out along z.
     *
     * @param section with boundary ids other than those of front and back
     * @param z in 3D the positions of the layers' faces, m
     * @param what names the mesh at the beginning of a message
     */
    template <int dim>
    void
    extrude(const dealii::Triangulation<2> &section,
            const std::vector<double>      &z,
            dealii::Triangulation<dim>     &target,
            const std::string              &what);

    /// The names of a box's sides without those that @p names replaces.
    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    sides_and(const std::map<std::string, dealii::types::boundary_id> &names,
              const std::vector<std::string> &without = {});

    /// Throws a message unless @p value is positive; @p parameter and
    /// @p geometry say which it is.
    void
    check_positive(const double       value,
                   const std::string &parameter,
                   const std::string &geometry);
  } // namespace Geometries
} // namespace Thalweg

#endif
