// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_cell_maps_h
#define thalweg_particles_cell_maps_h

#include <thalweg/mesh/cell_graph.h>
#include <thalweg/particles/cell_polynomial.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief From reference coordinates to positions and back, in the straight
   * cells of a CellGraph, which has to outlive this object.
   */
  template <int dim>
  class CellMaps
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;
    using Coordinates                        = std::array<double, dim>;
    /// Coefficients of 1, x, y, xy, z, ... for each component.
    using Polynomial = std::array<double, dim * n_vertices>;

    explicit CellMaps(const CellGraph<dim> &graph);

    /**
     * A place by its way from a corner of the mesh, in m. So places in
     * neighbouring cells differ by round-off of the cells' size, however far
     * away from the origin they are.
     */
    struct Place
    {
      dealii::Point<dim>     corner;
      dealii::Tensor<1, dim> offset; ///< added where a periodic face is passed
      Coordinates            way;

      /// The way from another corner.
      Coordinates
      way_from(const dealii::Point<dim> &other) const
      {
        Coordinates result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = ((corner[d] - other[d]) + offset[d]) + way[d];
        return result;
      }
    };

    /// The map of any cell, as a polynomial: the way from its first corner,
    /// in m.
    static Polynomial
    shape_of(const typename CellGraph<dim>::Cell &cell);

    /// The coordinates of a place in a general cell, given by the map of
    /// shape_of() and the way from its first corner; returns false if there
    /// are none, far outside.
    static bool
    find_reference(const Polynomial  &shape,
                   const Coordinates &way,
                   Coordinates       &reference);

    /// The derivative of the map of a cell; not if all are axis-parallel.
    dealii::Tensor<2, dim>
    jacobian(const unsigned int cell, const Coordinates &reference) const
    {
      return CellPolynomial::gradient<dim>(shape[cell], reference);
    }

    /// A point of a cell by the way from the cell's first corner.
    Place
    place(const unsigned int cell, const Coordinates &reference) const
    {
      const auto &geometry = graph.cell(cell);
      Place       place{geometry.vertices[0], {}, {}};
      if (geometry.axis_parallel)
        for (unsigned int d = 0; d < dim; ++d)
          place.way[d] = reference[d] * geometry.extent[d];
      else
        place.way = CellPolynomial::evaluate(shape[cell], reference);
      return place;
    }

    /// The position of a point of a cell, in m.
    Coordinates
    to_space(const unsigned int cell, const Coordinates &reference) const
    {
      const Place point = place(cell, reference);
      Coordinates position;
      for (unsigned int d = 0; d < dim; ++d)
        position[d] = point.corner[d] + point.way[d];
      return position;
    }

    /// The coordinates of a place in a cell; returns false if there are none,
    /// far outside a general cell.
    bool
    to_reference(const unsigned int cell,
                 const Place       &place,
                 Coordinates       &reference) const
    {
      const auto       &geometry = graph.cell(cell);
      const Coordinates way      = place.way_from(geometry.vertices[0]);
      if (!geometry.axis_parallel)
        return find_reference(shape[cell], way, reference);
      for (unsigned int d = 0; d < dim; ++d)
        reference[d] = way[d] * geometry.inverse_extent[d];
      return true;
    }

    /// Which of the cells behind a hanging face is nearest to a position.
    unsigned int
    nearest_child(const std::array<int, CellGraph<dim>::n_face_children> &,
                  const Place &place) const;

  private:
    const CellGraph<dim>   &graph;
    std::vector<Polynomial> shape;
  };
} // namespace Thalweg

#endif
