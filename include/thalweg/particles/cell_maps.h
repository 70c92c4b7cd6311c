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

    /// The map of any cell, as a polynomial; in m.
    static Polynomial
    shape_of(const typename CellGraph<dim>::Cell &cell);

    /// The derivative of the map of a cell; not if all are axis-parallel.
    dealii::Tensor<2, dim>
    jacobian(const unsigned int cell, const Coordinates &reference) const
    {
      return CellPolynomial::gradient<dim>(shape[cell], reference);
    }

    /// The position of a point of a cell, in m.
    Coordinates
    to_space(const unsigned int cell, const Coordinates &reference) const
    {
      const auto &geometry = graph.cell(cell);
      if (!geometry.axis_parallel)
        return CellPolynomial::evaluate(shape[cell], reference);
      Coordinates position;
      for (unsigned int d = 0; d < dim; ++d)
        position[d] =
          geometry.vertices[0][d] + reference[d] * geometry.extent[d];
      return position;
    }

    /// The coordinates of a position in a cell; returns false if there are
    /// none, far outside a general cell.
    bool
    to_reference(const unsigned int cell,
                 const Coordinates &position,
                 Coordinates       &reference) const
    {
      const auto &geometry = graph.cell(cell);
      if (!geometry.axis_parallel)
        return find_reference(cell, position, reference);
      for (unsigned int d = 0; d < dim; ++d)
        reference[d] =
          (position[d] - geometry.vertices[0][d]) * geometry.inverse_extent[d];
      return true;
    }

    /// Which of the cells behind a hanging face is nearest to a position.
    unsigned int
    nearest_child(const std::array<int, CellGraph<dim>::n_face_children> &,
                  const Coordinates &position) const;

  private:
    bool
    find_reference(const unsigned int cell,
                   const Coordinates &position,
                   Coordinates       &reference) const;

    const CellGraph<dim>   &graph;
    std::vector<Polynomial> shape;
  };
} // namespace Thalweg

#endif
