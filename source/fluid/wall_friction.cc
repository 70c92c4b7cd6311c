// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/core/registry.h>
#include <thalweg/fluid/wall_friction.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Faces make a corner where their normals are farther from the mean one
    /// than 30 degrees.
    constexpr double smooth_cosine = .866;
  } // namespace



  template <int dim>
  WallFriction<dim>::WallFriction(const FlowOperators<dim> &operators,
                                  const FlowBoundary<dim>  &boundary,
                                  const double              kinematic_viscosity)
    : operators(operators)
    , nu(kinematic_viscosity)
  {
    const auto &V = operators.velocity_space;
    V.initialize(area, dim);
    V.initialize(is_corner, 1);
    V.initialize(missing, dim);
    collect_faces(boundary);
    find_corners(boundary);
    on_faces.resize(dim * V.scalar().get_fe().n_dofs_per_face() *
                    faces_.size());
  }



  template <int dim>
  void
  WallFriction<dim>::collect_faces(const FlowBoundary<dim> &boundary)
  {
    using namespace dealii;
    const auto &V   = operators.velocity_space;
    const auto &fe  = V.scalar().get_fe();
    const auto &row = V.lexicographic();

    const Quadrature<dim - 1> nodes(fe.get_unit_face_support_points());
    FEFaceValues<dim>         values(V.mapping(),
                             fe,
                             nodes,
                             update_gradients | update_normal_vectors);
    for_each_sticking_face(
      V.mesh().graph(),
      boundary.conditions(),
      [&](const unsigned int c, const unsigned int f) {
        values.reinit(Compat::on_dof_handler(V.mesh().graph().iterator(c),
                                             V.scalar()),
                      f);
        Face face{c, f, {}, std::vector<double>(nodes.size() * row.size())};
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            face.nodes.push_back(V.nodes(c)[row[fe.face_to_cell_index(k, f)]]);
            for (unsigned int j = 0; j < row.size(); ++j)
              face.slopes[k * row.size() + row[j]] =
                values.shape_grad(j, k) * values.normal_vector(k);
          }
        faces_.push_back(std::move(face));
      });
  }



  template <int dim>
  void
  WallFriction<dim>::find_corners(const FlowBoundary<dim> &boundary)
  {
    using namespace dealii;
    const auto           &V  = operators.velocity_space;
    const auto           &fe = V.scalar().get_fe();
    const QGauss<dim - 1> gauss(V.degree() + 1);
    FEFaceValues<dim>     values(V.mapping(),
                             fe,
                             gauss,
                             update_values | update_normal_vectors |
                               update_JxW_values);
    Vector                normals;
    V.initialize(normals, dim);
    for (const Face &face : faces_)
      {
        values.reinit(Compat::on_dof_handler(
                        V.mesh().graph().iterator(face.cell), V.scalar()),
                      face.face_no);
        for (unsigned int k = 0; k < face.nodes.size(); ++k)
          for (const unsigned int q : values.quadrature_point_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double part =
                  values.shape_value(fe.face_to_cell_index(k, face.face_no),
                                     q) *
                  values.JxW(q);
                area.local_element(dim * face.nodes[k] + d) += part;
                normals.local_element(dim * face.nodes[k] + d) +=
                  part * values.normal_vector(q)[d];
              }
      }
    V.fold(area, dim);
    V.fold(normals, dim);
    mark_other_faces(boundary);
    for (unsigned int n = 0; n < V.n_owned_nodes(); ++n)
      {
        Tensor<1, dim> sum;
        for (unsigned int d = 0; d < dim; ++d)
          sum[d] = normals.local_element(dim * n + d);
        if (sum.norm() < smooth_cosine * area.local_element(dim * n))
          is_corner.local_element(n) = 1.;
      }
    V.interpolate(is_corner, 1);
  }



  template <int dim>
  void
  WallFriction<dim>::mark_other_faces(const FlowBoundary<dim> &boundary)
  {
    const auto &V     = operators.velocity_space;
    const auto &fe    = V.scalar().get_fe();
    const auto &graph = V.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        if (graph.at_boundary(c, f) &&
            !is_sticking_face(graph, boundary.conditions(), c, f))
          for (unsigned int k = 0; k < fe.n_dofs_per_face(); ++k)
            is_corner.local_element(
              V.nodes(c)[V.lexicographic()[fe.face_to_cell_index(k, f)]]) = 1.;
    V.fold(is_corner, 1);
  }



  template <int dim>
  void
  WallFriction<dim>::find_missing(const Vector &velocity, const Vector &g)
  {
    const auto &V = operators.velocity_space;
    missing.zero_out_ghost_values();
    missing = 0.;
    operators.mass.add_product(g, missing, dim, 1.);
    operators.stiffness.add_product(velocity, missing, dim, nu);
    operators.add_boundary_gradient(velocity, missing, -nu);
    V.fold(missing, dim);
    for (unsigned int i = 0; i < dim * V.n_owned_nodes(); ++i)
      missing.local_element(i) =
        area.local_element(i) > 0.
          ? missing.local_element(i) / area.local_element(i)
          : 0.;
    V.interpolate(missing, dim);
  }



  template <int dim>
  void
  WallFriction<dim>::find_on_face(const Face   &face,
                                  const Vector &velocity,
                                  double       *values) const
  {
    const auto            &V = operators.velocity_space;
    const unsigned int     n = V.n_nodes_per_cell(), n_face = face.nodes.size();
    dealii::Tensor<1, dim> sum;
    unsigned int           count = 0;
    for (const unsigned int node : face.nodes)
      if (is_corner.local_element(node) == 0.)
        {
          ++count;
          for (unsigned int d = 0; d < dim; ++d)
            sum[d] += missing.local_element(dim * node + d);
        }
    for (unsigned int k = 0; k < n_face; ++k)
      for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int node  = face.nodes[k];
          double            &value = values[dim * k + d];
          value                    = is_corner.local_element(node) == 0.
                                       ? missing.local_element(dim * node + d)
                                       : sum[d] / std::max(1u, count);
          for (unsigned int j = 0; j < n; ++j)
            value += nu * face.slopes[k * n + j] *
                     velocity.local_element(dim * V.nodes(face.cell)[j] + d);
        }
  }



  template <int dim>
  const std::vector<double> &
  WallFriction<dim>::find(const Vector &velocity, const Vector &g)
  {
    find_missing(velocity, g);
    double *values = on_faces.data();
    for (const Face &face : faces_)
      {
        find_on_face(face, velocity, values);
        values += dim * face.nodes.size();
      }
    return on_faces;
  }



  THALWEG_INSTANTIATE(WallFriction)
} // namespace Thalweg
