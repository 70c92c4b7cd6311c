// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_q1_cell_h
#define thalweg_fields_q1_cell_h

#include <thalweg/mesh/cell_graph.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Thalweg
{
  /**
   * @brief Shape functions of Q1 on the reference cell and their gradients
   * on a cell of the graph, inlined for loops over particles and cells.
   */
  namespace Q1
  {
    /// Values of the 2^dim shape functions at @p xi.
    template <int dim>
    inline std::array<double, (1 << dim)>
    values(const dealii::Point<dim> &xi)
    {
      // Written out, since compilers make of a loop over the directions one
      // that waits for its own results in memory.
      static_assert(dim == 2 || dim == 3);
      const double x[2] = {1. - xi[0], xi[0]}, y[2] = {1. - xi[1], xi[1]};
      const double s[4] = {x[0] * y[0], x[1] * y[0], x[0] * y[1], x[1] * y[1]};
      if constexpr (dim == 2)
        return {{s[0], s[1], s[2], s[3]}};
      else
        {
          const double z[2] = {1. - xi[2], xi[2]};
          return {{s[0] * z[0],
                   s[1] * z[0],
                   s[2] * z[0],
                   s[3] * z[0],
                   s[0] * z[1],
                   s[1] * z[1],
                   s[2] * z[1],
                   s[3] * z[1]}};
        }
    }

    /// The value at @p xi of a field with the given nodal ones, the components
    /// of a node one behind the other.
    template <int dim, int n_components>
    inline std::array<double, n_components>
    value(const std::array<double, n_components *(1 << dim)> &nodal,
          const dealii::Point<dim>                           &xi)
    {
      const auto                       shape = values<dim>(xi);
      std::array<double, n_components> sum{};
      for (unsigned int v = 0; v < shape.size(); ++v)
        for (unsigned int c = 0; c < n_components; ++c)
          sum[c] += shape[v] * nodal[n_components * v + c];
      return sum;
    }

    /// The same of a scalar.
    template <int dim>
    inline double
    value(const std::array<double, (1 << dim)> &nodal,
          const dealii::Point<dim>             &xi)
    {
      return value<dim, 1>(nodal, xi)[0];
    }

    /// The mean of a cell's corners.
    template <int dim>
    inline dealii::Point<dim>
    center(const typename CellGraph<dim>::Cell &cell)
    {
      dealii::Tensor<1, dim> sum;
      for (const auto &vertex : cell.vertices)
        sum += vertex - cell.vertices[0];
      return cell.vertices[0] + sum / static_cast<double>(1 << dim);
    }

    /// The point with the reference coordinates @p xi in the cell with these
    /// corners.
    template <int dim>
    inline dealii::Point<dim>
    position(const std::array<dealii::Point<dim>, (1 << dim)> &vertices,
             const dealii::Point<dim>                         &xi)
    {
      const auto             shape = values<dim>(xi);
      dealii::Tensor<1, dim> x;
      for (unsigned int v = 1; v < shape.size(); ++v)
        x += shape[v] * (vertices[v] - vertices[0]);
      return vertices[0] + x;
    }

    /// Gradients of the shape functions in reference coordinates at @p xi.
    template <int dim>
    inline std::array<dealii::Tensor<1, dim>, (1 << dim)>
    reference_gradients(const dealii::Point<dim> &xi)
    {
      std::array<dealii::Tensor<1, dim>, (1 << dim)> gradients;
      for (unsigned int v = 0; v < (1u << dim); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          {
            double product = (v >> d) & 1u ? 1. : -1.;
            for (unsigned int e = 0; e < dim; ++e)
              if (e != d)
                product *= (v >> e) & 1u ? xi[e] : 1. - xi[e];
            gradients[v][d] = product;
          }
      return gradients;
    }

    /// Shape functions, gradients in real space and the measure's density.
    template <int dim>
    struct Point
    {
      std::array<double, (1 << dim)>                 values;
      std::array<dealii::Tensor<1, dim>, (1 << dim)> gradients;
      /// d x / d xi
      double determinant;
      /// Transforms gradients: grad = covariant * reference gradient.
      dealii::Tensor<2, dim> covariant;
    };

    /// From values and reference gradients at a point to those in @p cell.
    template <int dim>
    inline Point<dim>
    evaluate(const typename CellGraph<dim>::Cell                  &cell,
             const std::array<double, (1 << dim)>                 &shape,
             const std::array<dealii::Tensor<1, dim>, (1 << dim)> &reference)
    {
      Point<dim> point;
      point.values = shape;
      if (cell.axis_parallel)
        {
          point.determinant = cell.measure;
          for (unsigned int d = 0; d < dim; ++d)
            point.covariant[d][d] = cell.inverse_extent[d];
          for (unsigned int v = 0; v < (1u << dim); ++v)
            for (unsigned int d = 0; d < dim; ++d)
              point.gradients[v][d] = reference[v][d] * cell.inverse_extent[d];
        }
      else
        {
          // From edges, which keep their digits far from the origin.
          dealii::Tensor<2, dim> jacobian;
          for (unsigned int e = 0; e < dim; ++e)
            for (unsigned int v = 0; v < (1u << dim); ++v)
              if (((v >> e) & 1u) == 0)
                {
                  const unsigned int end = v + (1u << e);
                  for (unsigned int d = 0; d < dim; ++d)
                    jacobian[d][e] +=
                      (cell.vertices[end][d] - cell.vertices[v][d]) *
                      reference[end][e];
                }
          point.determinant = determinant(jacobian);
          point.covariant   = transpose(invert(jacobian));
          for (unsigned int v = 0; v < (1u << dim); ++v)
            point.gradients[v] = point.covariant * reference[v];
        }
      return point;
    }

    /// The middle of the reference cell, in @p cell.
    template <int dim>
    inline Point<dim>
    middle(const typename CellGraph<dim>::Cell &cell)
    {
      dealii::Point<dim> xi;
      for (unsigned int d = 0; d < dim; ++d)
        xi[d] = .5;
      return evaluate<dim>(cell, values<dim>(xi), reference_gradients<dim>(xi));
    }

    /// The tensor-product Gauss rule with two points a direction, with the
    /// shape functions tabulated.
    template <int dim>
    struct Gauss
    {
      static constexpr unsigned int            n_points = 1 << dim;
      static constexpr double                  weight   = 1. / n_points;
      std::array<dealii::Point<dim>, n_points> points;
      std::array<std::array<double, (1 << dim)>, n_points> values;
      std::array<std::array<dealii::Tensor<1, dim>, (1 << dim)>, n_points>
        gradients;

      Gauss()
      {
        for (unsigned int q = 0; q < n_points; ++q)
          {
            for (unsigned int d = 0; d < dim; ++d)
              points[q][d] =
                .5 + ((q >> d) & 1u ? .5 : -.5) * 0.57735026918962576451;
            values[q]    = Q1::values<dim>(points[q]);
            gradients[q] = Q1::reference_gradients<dim>(points[q]);
          }
      }

      /// Quadrature point @p q in @p cell; weight() times determinant is
      /// its weight.
      Point<dim>
      evaluate(const typename CellGraph<dim>::Cell &cell,
               const unsigned int                   q) const
      {
        return Q1::evaluate<dim>(cell, values[q], gradients[q]);
      }
    };
  } // namespace Q1
} // namespace Thalweg

#endif
