// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_simplices.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Thalweg
{
  namespace
  {
    /// The outward normal of a face times the density of its measure.
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



    /// Calls @p visit(cell, face number, boundary id) for the faces of owned
    /// and ghost cells at boundaries that are not periodic.
    template <int dim, typename Visitor>
    void
    for_each_boundary_face(const CellGraph<dim> &graph, const Visitor &visit)
    {
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (const unsigned int f : graph.iterator(c)->face_indices())
          if (graph.at_boundary(c, f))
            visit(c, f, graph.iterator(c)->face(f)->boundary_id());
    }
  } // namespace



  template <int dim>
  BoundaryNodes<dim>::BoundaryNodes(const NodeSpace<dim>          &space,
                                    const BoundaryConditions<dim> &conditions)
    : space(space)
    , conditions_(conditions)
  {
    collect_nodes();
    collect_faces();
  }



  template <int dim>
  void
  BoundaryNodes<dim>::collect_nodes()
  {
    using Geometry              = dealii::GeometryInfo<dim>;
    const CellGraph<dim> &graph = space.mesh().graph();

    std::map<unsigned int, NodeDemand<dim>> demands;
    std::map<unsigned int, PressureNode>    pressures;
    const auto                              add_face = [&](const unsigned int               c,
                              const unsigned int               f,
                              const dealii::types::boundary_id id) {
      const BoundaryKind kind = conditions_.at(id).kind;
      const auto         center = graph.iterator(c)->face(f)->center();
      for (unsigned int i = 0; i < graph.n_face_children; ++i)
        {
          const unsigned int v = Geometry::face_to_cell_vertices(f, i);
          const unsigned int node = space.nodes(c)[v];
          const auto        &x = graph.cell(c).vertices[v];
          demands[node].position = x;
          const auto normal =
            weighted_normal<dim>(graph.cell(c),
                                 f,
                                 Geometry::unit_cell_vertex(v));
          demands[node].add(id, kind, normal, center - x);
          if (kind == BoundaryKind::open)
            {
              const auto sum = pressures[node].normal + normal;
              pressures[node] = {node, x, id, sum};
            }
        }
    };
    for_each_boundary_face(graph, add_face);

    const unsigned int n_owned = space.scalar_layout().locally_owned_size();
    for (const auto &[node, demand] : demands)
      if (node < n_owned && !space.is_dependent(node))
        {
          fixed.add(node, demand);
          if (demand.kind == BoundaryKind::slip)
            slip.add(node, demand);
        }
    for (const auto &[node, entry] : pressures)
      if (!space.is_dependent(node))
        {
          open_nodes.push_back(entry);
          auto &normal = open_nodes.back().normal;
          // Those of cells that touch each other there alone may cancel.
          if (normal.norm() > 0)
            normal /= normal.norm();
        }
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BoundaryNodes<dim>::Face::area() const
  {
    dealii::Tensor<1, dim> sum;
    for (const auto &part : normals_times_weight)
      sum += part;
    return sum;
  }



  template <int dim>
  void
  BoundaryNodes<dim>::collect_faces()
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        {
          const auto &behind = graph.cell(c).faces[f];
          if (behind.behind != CellGraph<dim>::Behind::boundary)
            continue;
          const BoundaryKind kind = conditions_.at(behind.boundary_id).kind;
          if (kind != BoundaryKind::open && kind != BoundaryKind::velocity)
            continue;
          auto points = face_points<dim>(graph.cell(c), f);
          faces.push_back({c,
                           f,
                           behind.boundary_id,
                           std::move(points.reference),
                           std::move(points.normals)});
        }
  }



  template <int dim>
  void
  BoundaryNodes<dim>::add_flux(const Vector &field,
                               const double  factor,
                               Vector       &scalar) const
  {
    for (const Face &face : faces)
      {
        if (conditions_.at(face.id).kind != BoundaryKind::velocity)
          continue;
        const auto &nodes = space.nodes(face.cell);
        for (unsigned int q = 0; q < face.reference_points.size(); ++q)
          {
            const auto shape = Q1::values<dim>(face.reference_points[q]);
            double     flux  = 0;
            for (unsigned int v = 0; v < shape.size(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                flux += shape[v] * field.local_element(dim * nodes[v] + d) *
                        face.normals_times_weight[q][d];
            for (unsigned int v = 0; v < shape.size(); ++v)
              scalar.local_element(nodes[v]) += factor * shape[v] * flux;
          }
      }
  }



  THALWEG_INSTANTIATE(BoundaryNodes)
} // namespace Thalweg
