// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_q1_simplices_h
#define thalweg_fields_q1_simplices_h

#include <thalweg/fields/q1_cell.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace Q1
  {
    /// Whether the map of a cell is affine, to round-off.
    template <int dim>
    inline bool
    is_parallelepiped(const typename CellGraph<dim>::Cell &cell)
    {
      if (cell.axis_parallel)
        return true;
      const auto            &x = cell.vertices;
      dealii::Tensor<1, dim> edges[dim];
      double                 size = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          edges[d] = x[1u << d] - x[0];
          size     = std::max(size, edges[d].norm_square());
        }
      const double round_off =
        1e-10 * std::sqrt(size) + coordinate_round_off(x[0]);
      for (unsigned int v = 3; v < x.size(); ++v)
        {
          dealii::Tensor<1, dim> difference = x[v] - x[0];
          for (unsigned int d = 0; d < dim; ++d)
            if ((v >> d) & 1u)
              difference -= edges[d];
          if (difference.norm() > round_off)
            return false;
        }
      return true;
    }



    /**
     * @brief How a cell is divided into simplices around its centre: 4
     * triangles, or 24 tetrahedra, four over each face.
     *
     * Their corners are the cell's vertices, in 3D the means of the vertices
     * of each face, and the mean of all. The division is the same seen from
     * both sides of a face, also of one that is not plane, and the simplices
     * have the cell's measure together: the volume below a fan of triangles is
     * linear in its apex, and the middle of a bilinear face is that of its two
     * diagonals, whose fans have the face's volume in the mean.
     */
    template <int dim>
    struct Division
    {
      static constexpr unsigned int n_vertices  = 1 << dim;
      static constexpr unsigned int n_simplices = dim == 2 ? 4 : 24;
      /// The vertices, the middles of the faces in 3D, the centre.
      static constexpr unsigned int n_points = dim == 2 ? 5 : 15;

      Division();

      /// The one and only; no function of it changes it.
      static const Division &
      instance()
      {
        static const Division division;
        return division;
      }

      /// What is given at the vertices, at all points.
      template <typename T>
      std::array<T, n_points>
      extend(const std::array<T, n_vertices> &at_vertices) const
      {
        std::array<T, n_points> values;
        values[n_points - 1] = 0. * at_vertices[0];
        for (unsigned int v = 0; v < n_vertices; ++v)
          {
            values[v] = at_vertices[v];
            values[n_points - 1] += at_vertices[v] / (1. * n_vertices);
          }
        if constexpr (dim == 3)
          for (unsigned int f = 0; f < 6; ++f)
            {
              values[8 + f] = 0. * at_vertices[0];
              for (const unsigned int v : face_vertices[f])
                values[8 + f] += at_vertices[v] / 4.;
            }
        return values;
      }

      /// The corners of the simplices among the points.
      std::array<std::array<unsigned int, dim + 1>, n_simplices> corners;
      /// The sign of det(x_k - x_0) in a right-handed cell.
      std::array<double, n_simplices> orientation;
      /// In circular order; in 3D only.
      std::array<std::array<unsigned int, 4>, 6> face_vertices;
      /// The shape functions of the vertices at the points.
      std::array<std::array<double, n_vertices>, n_points> shape;
      /// The faces that each point lies on, bit by bit.
      std::array<unsigned int, n_points> faces;
    };



    /**
     * @brief The shape functions of a cell that is no parallelepiped: linear
     * in each simplex of its Division, means at the points between vertices.
     *
     * They are Q1 on edges and reproduce linear functions, and so does every
     * integral of them that a level set cuts, which those of the isoparametric
     * functions do not: there is no quadrature for these on both sides of a
     * plane.
     */
    template <int dim>
    class SimplexShape
    {
    public:
      static constexpr unsigned int n_vertices  = 1 << dim;
      static constexpr unsigned int n_simplices = Division<dim>::n_simplices;

      explicit SimplexShape(
        const std::array<dealii::Point<dim>, n_vertices> &vertices)
        : division(Division<dim>::instance())
      {
        std::array<dealii::Tensor<1, dim>, n_vertices> edges;
        for (unsigned int v = 0; v < n_vertices; ++v)
          edges[v] = vertices[v] - vertices[0];
        points = division.extend(edges);
      }

      /// A simplex: its measure, and the gradients of its barycentric
      /// coordinates.
      struct Simplex
      {
        double                                      measure;
        std::array<dealii::Tensor<1, dim>, dim + 1> gradients;
      };

      Simplex
      simplex(const unsigned int s) const
      {
        const auto            &corners = division.corners[s];
        dealii::Tensor<2, dim> edges;
        for (unsigned int d = 0; d < dim; ++d)
          edges[d] = points[corners[d + 1]] - points[corners[0]];
        Simplex result;
        result.measure =
          division.orientation[s] * determinant(edges) / (dim == 2 ? 2. : 6.);
        const dealii::Tensor<2, dim> inverse = invert(edges);
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            {
              result.gradients[d + 1][e] = inverse[e][d];
              result.gradients[0][e] -= inverse[e][d];
            }
        return result;
      }

      /// The gradients of the vertices' shape functions in simplex @p s.
      std::array<dealii::Tensor<1, dim>, n_vertices>
      gradients(const unsigned int s, const Simplex &simplex) const
      {
        std::array<dealii::Tensor<1, dim>, n_vertices> result;
        for (unsigned int c = 0; c < dim + 1; ++c)
          for (unsigned int v = 0; v < n_vertices; ++v)
            result[v] +=
              division.shape[division.corners[s][c]][v] * simplex.gradients[c];
        return result;
      }

      /// Their values at a point of simplex @p s with these barycentric
      /// coordinates.
      std::array<double, n_vertices>
      values(const unsigned int                 s,
             const std::array<double, dim + 1> &barycentric) const
      {
        std::array<double, n_vertices> result{};
        for (unsigned int c = 0; c < dim + 1; ++c)
          for (unsigned int v = 0; v < n_vertices; ++v)
            result[v] +=
              division.shape[division.corners[s][c]][v] * barycentric[c];
        return result;
      }

      /// Calls @p visit(values in the middle of a simplex, gradients,
      /// measure), which is a quadrature for linear functions.
      template <typename Visitor>
      void
      for_each(const Visitor &visit) const
      {
        std::array<double, dim + 1> middle;
        middle.fill(1. / (dim + 1));
        for (unsigned int s = 0; s < n_simplices; ++s)
          {
            const Simplex at = simplex(s);
            visit(values(s, middle), gradients(s, at), at.measure);
          }
      }

    private:
      const Division<dim> &division;
      /// Relative to the first vertex.
      std::array<dealii::Tensor<1, dim>, Division<dim>::n_points> points;
    };



    template <int dim>
    Division<dim>::Division()
      : face_vertices{}
    {
      constexpr unsigned int                         circle[4] = {0, 1, 3, 2};
      std::array<dealii::Tensor<1, dim>, n_vertices> unit;
      for (unsigned int v = 0; v < n_vertices; ++v)
        for (unsigned int d = 0; d < dim; ++d)
          unit[v][d] = (v >> d) & 1u;
      if constexpr (dim == 2)
        for (unsigned int e = 0; e < 4; ++e)
          corners[e] = {{circle[e], circle[(e + 1) % 4], n_points - 1}};
      else
        for (unsigned int f = 0; f < 6; ++f)
          {
            const unsigned int normal = f / 2, side = f % 2;
            for (unsigned int c = 0; c < 4; ++c)
              face_vertices[f][c] = (side << normal) +
                                    ((circle[c] & 1u) << ((normal + 1) % 3)) +
                                    ((circle[c] >> 1) << ((normal + 2) % 3));
            for (unsigned int e = 0; e < 4; ++e)
              corners[4 * f + e] = {{face_vertices[f][e],
                                     face_vertices[f][(e + 1) % 4],
                                     8 + f,
                                     n_points - 1}};
          }

      const auto points = extend(unit);
      for (unsigned int s = 0; s < n_simplices; ++s)
        {
          dealii::Tensor<2, dim> edges;
          for (unsigned int d = 0; d < dim; ++d)
            edges[d] = points[corners[s][d + 1]] - points[corners[s][0]];
          orientation[s] = determinant(edges) > 0 ? 1. : -1.;
        }
      for (unsigned int p = 0; p < n_points; ++p)
        {
          faces[p] = 0;
          for (unsigned int d = 0; d < dim; ++d)
            if (points[p][d] == 0. || points[p][d] == 1.)
              faces[p] |= 1u << (2 * d + (points[p][d] == 1. ? 1 : 0));
        }
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          std::array<double, n_vertices> one{};
          one[v]            = 1.;
          const auto values = extend(one);
          for (unsigned int p = 0; p < n_points; ++p)
            shape[p][v] = values[p];
        }
    }
  } // namespace Q1
} // namespace Thalweg

#endif
