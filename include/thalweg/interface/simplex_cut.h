// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_simplex_cut_h
#define thalweg_interface_simplex_cut_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Thalweg
{
  /**
   * @brief Pure functions for a reference cell [0,1]^dim that a level set
   * cuts.
   *
   * The cell is divided into congruent simplices around its centre (4
   * triangles, or 24 tetrahedra, four over each face), on each
   * of which the level set is linear between its values at the corners, the
   * averages at the faces' centres (3D) and the average at the centre. The
   * division is the same seen from both sides of a face, so the interface is
   * continuous; a plane is represented exactly.
   */
  namespace SimplexCut
  {
    /// A simplex in reference coordinates with the level set at its corners.
    template <int dim>
    struct Simplex
    {
      std::array<dealii::Point<dim>, dim + 1> corners;
      std::array<double, dim + 1>             phi;
    };

    /// Number of simplices that a cell is divided into.
    template <int dim>
    constexpr unsigned int n_simplices = dim == 2 ? 4 : 24;

    /// The division of the cell with these vertices and the values @p phi
    /// there.
    template <int dim>
    std::array<Simplex<dim>, n_simplices<dim>>
    divide(const std::array<dealii::Point<dim>, (1 << dim)> &vertices,
           const std::array<double, (1 << dim)>             &phi);

    /// The division of the reference cell with the values @p phi at its
    /// vertices.
    template <int dim>
    std::array<Simplex<dim>, n_simplices<dim>>
    divide(const std::array<double, (1 << dim)> &phi);

    /// The measure of a simplex.
    template <int dim>
    double
    measure(const Simplex<dim> &simplex);

    /// The constant gradient of the level set in a simplex.
    template <int dim>
    dealii::Tensor<1, dim>
    gradient(const Simplex<dim> &simplex);

    /**
     * @brief Calls @p visit(piece) for pieces that fill @p simplex and lie
     * each on one side of the interface.
     *
     * An edge with values of different signs is cut where the level set
     * vanishes, which leaves two simplices; and so on until none is left.
     */
    template <int dim, typename Visitor>
    void
    cut(const Simplex<dim> &simplex, const Visitor &visit)
    {
      for (unsigned int i = 0; i < dim + 1; ++i)
        for (unsigned int j = 0; j < dim + 1; ++j)
          if (simplex.phi[i] < 0 && simplex.phi[j] > 0)
            {
              const double t =
                simplex.phi[i] / (simplex.phi[i] - simplex.phi[j]);
              const dealii::Point<dim> zero =
                simplex.corners[i] +
                t * (simplex.corners[j] - simplex.corners[i]);
              for (const unsigned int replaced : {i, j})
                {
                  Simplex<dim> piece      = simplex;
                  piece.corners[replaced] = zero;
                  piece.phi[replaced]     = 0.;
                  cut(piece, visit);
                }
              return;
            }
      visit(simplex);
    }

    /// Whether a piece that cut() delivered lies where the level set is
    /// negative.
    template <int dim>
    bool
    is_negative(const Simplex<dim> &piece)
    {
      double sum = 0;
      for (const double value : piece.phi)
        sum += value;
      return sum < 0;
    }

    /// The part of a cell, between 0 and 1, where the level set with the
    /// values @p phi at the vertices is negative.
    template <int dim>
    double
    negative_fraction(const std::array<double, (1 << dim)> &phi);

    /// A point of a quadrature for one piece.
    template <int dim>
    struct QuadraturePoint
    {
      dealii::Point<dim> xi;
      double             weight;
    };

    /// Points per piece: exact for polynomials of degree dim.
    template <int dim>
    constexpr unsigned int n_points = dim == 2 ? 3 : 5;

    /// A quadrature on a piece whose weights add up to its measure.
    template <int dim>
    std::array<QuadraturePoint<dim>, n_points<dim>>
    quadrature(const Simplex<dim> &piece);
  } // namespace SimplexCut
} // namespace Thalweg

#endif
