// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_interface_quadrature_h
#define thalweg_interface_interface_quadrature_h

#include <thalweg/interface/simplex_cut.h>

#include <utility>
#include <vector>

namespace Thalweg
{
  /// Quadrature on the side of a simplex, by the weights of its corners: exact
  /// for polynomials of degree 5 in 2D, 4 in 3D.
  template <int dim>
  const std::vector<std::pair<std::array<double, dim>, double>> &
  side_quadrature();

  template <>
  const std::vector<std::pair<std::array<double, 2>, double>> &
  side_quadrature<2>();

  template <>
  const std::vector<std::pair<std::array<double, 3>, double>> &
  side_quadrature<3>();

  /**
   * @brief Calls @p visit(point, vector) for a quadrature of the side of a
   * piece of fluid 0 that lies on the interface, if it has one.
   *
   * With the gradient g of the barycentric coordinate of the opposite corner
   * the vector of a side is -dim times the simplex's measure times g; here in
   * the coordinates of the piece.
   */
  template <int dim, typename Visitor>
  void
  for_each_interface_point(const SimplexCut::Simplex<dim> &piece,
                           const Visitor                  &visit)
  {
    unsigned int opposite = 0, n_zeros = 0;
    for (unsigned int c = 0; c < dim + 1; ++c)
      if (piece.phi[c] == 0.)
        ++n_zeros;
      else
        opposite = c;
    if (n_zeros != dim || !(piece.phi[opposite] < 0.))
      return;
    SimplexCut::Simplex<dim> coordinate = piece;
    coordinate.phi.fill(0.);
    coordinate.phi[opposite] = 1.;
    const auto side          = (-1. * dim * SimplexCut::measure(piece)) *
                      SimplexCut::gradient(coordinate);
    for (const auto &[weights, weight] : side_quadrature<dim>())
      {
        dealii::Point<dim> point;
        for (unsigned int c = 0, i = 0; c < dim + 1; ++c)
          if (c != opposite)
            point += weights[i++] * dealii::Tensor<1, dim>(piece.corners[c]);
        visit(point, weight * side);
      }
  }
} // namespace Thalweg

#endif
