// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/boundary_faces.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fields/q1_simplices.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

namespace Thalweg
{
  template <int dim>
  dealii::Tensor<1, dim>
  weighted_normal(const typename CellGraph<dim>::Cell &cell,
                  const unsigned int                   face_no,
                  const dealii::Point<dim>            &xi)
  {
    // Nanson's formula: n dA = det(J) J^{-T} n_ref dA_ref
    const auto point = Q1::evaluate<dim>(cell,
                                         Q1::values<dim>(xi),
                                         Q1::reference_gradients<dim>(xi));
    return point.determinant *
           (point.covariant *
            dealii::GeometryInfo<dim>::unit_normal_vector[face_no]);
  }



  namespace
  {
    /// The points of a quadrature on a face, in the cell's coordinates, and
    /// the outward normals times the weights.
    template <int dim>
    struct FacePoints
    {
      std::vector<dealii::Point<dim>>     reference;
      std::vector<dealii::Tensor<1, dim>> normals;
    };



    template <int dim>
    FacePoints<dim>
    gauss_points(const typename CellGraph<dim>::Cell &cell,
                 const unsigned int                   f)
    {
      const dealii::QGauss<dim - 1> gauss(2);
      FacePoints<dim>               points;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          dealii::Point<dim> xi;
          xi[f / 2] = f % 2;
          for (unsigned int d = 0, e = 0; d < dim; ++d)
            if (d != f / 2)
              xi[d] = gauss.point(q)[e++];
          points.reference.push_back(xi);
          points.normals.push_back(gauss.weight(q) *
                                   weighted_normal<dim>(cell, f, xi));
        }
      return points;
    }



    /// The middles of the triangles that Q1::Division makes of the faces of
    /// a hexahedron. A bilinear function has the same value in the middle as
    /// one that is linear in the triangle.
    FacePoints<3>
    triangle_points(const CellGraph<3>::Cell &cell, const unsigned int f)
    {
      const auto   &corners = Q1::Division<3>::instance().face_vertices[f];
      const auto   &x       = cell.vertices;
      FacePoints<3> points;
      for (unsigned int e = 0; e < 4; ++e)
        {
          const unsigned int   a = corners[e], b = corners[(e + 1) % 4];
          dealii::Tensor<1, 3> to_center;
          dealii::Point<3>     xi(.5, .5, .5);
          for (unsigned int c = 0; c < 4; ++c)
            to_center += .25 * (x[corners[c]] - x[a]);
          for (unsigned int d = 0; d < 3; ++d)
            if (((a >> d) & 1u) == ((b >> d) & 1u))
              xi[d] = (a >> d) & 1u ? 5. / 6. : 1. / 6.;
          xi[f / 2] = f % 2;
          points.reference.push_back(xi);
          points.normals.push_back((f % 2 ? .5 : -.5) *
                                   cross_product_3d(x[b] - x[a], to_center));
        }
      return points;
    }



    template <int dim>
    FacePoints<dim>
    face_points(const typename CellGraph<dim>::Cell &cell, const unsigned int f)
    {
      if constexpr (dim == 3)
        if (!Q1::is_parallelepiped<3>(cell))
          return triangle_points(cell, f);
      return gauss_points<dim>(cell, f);
    }
  } // namespace



  template <int dim>
  dealii::Tensor<1, dim>
  BoundaryFace<dim>::area() const
  {
    dealii::Tensor<1, dim> sum;
    for (const auto &part : normals_times_weight)
      sum += part;
    return sum;
  }



  template <int dim>
  std::vector<BoundaryFace<dim>>
  boundary_faces(
    const CellGraph<dim>                                        &graph,
    const std::function<bool(const dealii::types::boundary_id)> &wanted)
  {
    std::vector<BoundaryFace<dim>> faces;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        {
          const auto &behind = graph.cell(c).faces[f];
          if (behind.behind != CellGraph<dim>::Behind::boundary ||
              !wanted(behind.boundary_id))
            continue;
          auto points = face_points<dim>(graph.cell(c), f);
          faces.push_back({c,
                           f,
                           behind.boundary_id,
                           std::move(points.reference),
                           std::move(points.normals)});
        }
    return faces;
  }



  template struct BoundaryFace<2>;
  template dealii::Tensor<1, 2>
  weighted_normal<2>(const CellGraph<2>::Cell &,
                     const unsigned int,
                     const dealii::Point<2> &);
  template std::vector<BoundaryFace<2>>
  boundary_faces<2>(
    const CellGraph<2> &,
    const std::function<bool(const dealii::types::boundary_id)> &);
  template struct BoundaryFace<3>;
  template dealii::Tensor<1, 3>
  weighted_normal<3>(const CellGraph<3>::Cell &,
                     const unsigned int,
                     const dealii::Point<3> &);
  template std::vector<BoundaryFace<3>>
  boundary_faces<3>(
    const CellGraph<3> &,
    const std::function<bool(const dealii::types::boundary_id)> &);
} // namespace Thalweg
