// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_cut_in_space_h
#define thalweg_interface_cut_in_space_h

#include <thalweg/fields/q1_simplices.h>
#include <thalweg/interface/simplex_cut.h>

namespace Thalweg
{
  namespace SimplexCut
  {
    /// A piece of a cell on one side of the interface.
    template <int dim>
    struct Piece
    {
      unsigned int simplex; ///< in the cell's Division
      /// The middle of the piece, in that simplex's barycentric coordinates.
      std::array<double, dim + 1> middle;
      double                      measure;  ///< m^dim
      double                      phi;      ///< in the middle
      bool                        negative; ///< its side
    };

    /**
     * @brief Calls @p visit(piece, simplex, part) for pieces that fill a cell
     * of any shape, each on one side of the interface; @p part is the piece in
     * the simplex's barycentric coordinates 1 to dim.
     * @param shape the cell
     * @param phi the level set at its vertices
     */
    template <int dim, typename Visitor>
    void
    cut_in_space(const Q1::SimplexShape<dim>          &shape,
                 const std::array<double, (1 << dim)> &phi,
                 const Visitor                        &visit)
    {
      const auto &division  = Q1::Division<dim>::instance();
      const auto  at_points = division.extend(phi);
      // Cut in barycentric coordinates, those of the corners 1 to dim.
      Simplex<dim> unit;
      for (unsigned int d = 0; d < dim; ++d)
        unit.corners[d + 1][d] = 1.;
      const double whole = measure(unit);
      for (unsigned int s = 0; s < shape.n_simplices; ++s)
        {
          const auto simplex = shape.simplex(s);
          for (unsigned int c = 0; c < dim + 1; ++c)
            unit.phi[c] = at_points[division.corners[s][c]];
          cut(unit, [&](const Simplex<dim> &part) {
            Piece<dim> piece{s,
                             {{1.}},
                             simplex.measure * measure(part) / whole,
                             0.,
                             is_negative(part)};
            for (unsigned int c = 0; c < dim + 1; ++c)
              {
                piece.phi += part.phi[c] / (dim + 1);
                for (unsigned int d = 0; d < dim; ++d)
                  piece.middle[d + 1] += part.corners[c][d] / (dim + 1);
              }
            for (unsigned int d = 0; d < dim; ++d)
              piece.middle[0] -= piece.middle[d + 1];
            visit(piece, simplex, part);
          });
        }
    }
  } // namespace SimplexCut
} // namespace Thalweg

#endif
