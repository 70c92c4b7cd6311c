// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_faces.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fields/nodal_moments.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/curvature.h>
#include <thalweg/linear_algebra/plane_fit.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Thalweg
{
  namespace
  {
    /// The curvature of the interface at the foot of a point at the distance
    /// @p phi from it, where the gradient of the level set is @p b and its
    /// second derivatives are @p H.
    template <int dim>
    double
    curvature_at_foot(const dealii::Tensor<1, dim> &b,
                      const dealii::Tensor<2, dim> &H,
                      const double                  phi)
    {
      const dealii::Tensor<1, dim> n = b / b.norm();
      dealii::Tensor<2, dim>       P;
      for (unsigned int d = 0; d < dim; ++d)
        P[d][d] = 1.;
      P -= outer_product(n, n);
      const dealii::Tensor<2, dim> S    = P * H * P / b.norm();
      const double                 mean = trace(S);
      // of two principal curvatures; 0 in 2D
      const double product = .5 * (mean * mean - trace(S * S));
      // Beyond a centre of curvature there is no foot.
      const double stretch = 1. - phi * mean + phi * phi * product;
      return stretch > .5 ? (mean - 2. * phi * product) / stretch : mean;
    }
  } // namespace



  /// Sums over the gradients around a node, each with its offset r.
  template <int dim>
  struct Curvature<dim>::Moments
  {
    static constexpr unsigned int n         = dim + 1;
    static constexpr unsigned int n_moments = n * (n + 1) / 2;
    /// b_i b_j of the lower triangle and b_i g_d, where b = (1, r).
    static constexpr unsigned int size = n_moments + dim * n;

    std::array<double, size> sums{};

    void
    add(const dealii::Tensor<1, dim> &offset,
        const dealii::Tensor<1, dim> &gradient)
    {
      std::array<double, n> row;
      row[0] = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        row[d + 1] = offset[d];
      unsigned int k = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          sums[k++] += row[i] * row[j];
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int i = 0; i < n; ++i)
          sums[k++] += row[i] * gradient[d];
    }

    /// The curvature at the foot of the node, and the square of the gradient,
    /// which says how much it tells: 0 if there is nothing.
    std::pair<double, double>
    value(const double phi) const
    {
      dealii::Tensor<2, n> matrix;
      unsigned int         k = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          matrix[i][j] = matrix[j][i] = sums[k++];
      const PlaneFit<n> fit(matrix);
      if (!(sums[0] > 0.) || !fit.is_determined())
        return {0., 0.};
      dealii::Tensor<1, dim> b;
      dealii::Tensor<2, dim> H;
      for (unsigned int d = 0; d < dim; ++d)
        {
          dealii::Tensor<1, n> load;
          for (unsigned int i = 0; i < n; ++i)
            load[i] = sums[k++];
          const auto unknowns = fit.solve(load).unknowns;
          b[d]                = unknowns[0];
          for (unsigned int e = 0; e < dim; ++e)
            {
              H[d][e] += .5 * unknowns[e + 1];
              H[e][d] += .5 * unknowns[e + 1];
            }
        }
      if (b.norm_square() == 0.)
        return {0., 0.};
      return {curvature_at_foot<dim>(b, H, phi), b.norm_square()};
    }
  };



  template <int dim>
  Curvature<dim>::Curvature(
    const NodeSpace<dim>                               &space,
    const std::map<dealii::types::boundary_id, double> &angles)
    : space(space)
    , angles(angles)
  {
    // Those up to an edge away: the nodes around them know their distance, too.
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      reach.push_back(graph.cell(c).edges().second);
  }



  template <int dim>
  bool
  Curvature<dim>::is_near(const unsigned int cell, const Vector &distance) const
  {
    const auto &nodes = space.nodes(cell);
    return std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int n) {
      return std::abs(distance.local_element(n)) < reach[cell];
    });
  }



  template <int dim>
  void
  Curvature<dim>::add(const unsigned int            cell,
                      const int                     face_no,
                      const dealii::Point<dim>     &position,
                      const dealii::Tensor<1, dim> &gradient,
                      std::vector<Moments>         &nodal) const
  {
    const auto &nodes    = space.nodes(cell);
    const auto &vertices = space.mesh().graph().cell(cell).vertices;
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        const auto masters = space.hanging_masters(nodes[v]);
        const bool is_on_face =
          face_no < 0 || ((v >> (face_no / 2)) & 1u) == face_no % 2u;
        if (masters.first == masters.second && is_on_face)
          nodal[nodes[v]].add(position - vertices[v], gradient);
      }
  }



  template <int dim>
  void
  Curvature<dim>::add_cell(const unsigned int    cell,
                           const Vector         &distance,
                           std::vector<Moments> &nodal) const
  {
    const auto            &geometry = space.mesh().graph().cell(cell);
    const auto             phi      = gather<dim>(distance, space.nodes(cell));
    const auto             middle   = Q1::middle<dim>(geometry);
    dealii::Tensor<1, dim> gradient;
    for (unsigned int v = 0; v < phi.size(); ++v)
      gradient += phi[v] * middle.gradients[v];
    add(cell, -1, Q1::center<dim>(geometry), gradient, nodal);
  }



  template <int dim>
  void
  Curvature<dim>::add_walls(const unsigned int    cell,
                            const Vector         &distance,
                            std::vector<Moments> &nodal) const
  {
    const CellGraph<dim> &graph    = space.mesh().graph();
    const auto           &geometry = graph.cell(cell);
    for (unsigned int f = 0; f < graph.n_faces; ++f)
      {
        if (geometry.faces[f].behind != CellGraph<dim>::Behind::boundary)
          continue;
        const auto angle = angles.find(geometry.faces[f].boundary_id);
        bool       meets = false;
        for (unsigned int v = 0; v < space.nodes(cell).size(); ++v)
          meets =
            meets || (((v >> (f / 2)) & 1u) == f % 2 &&
                      std::abs(distance.local_element(space.nodes(cell)[v])) <
                        reach[cell]);
        if (angle == angles.end() || !meets)
          continue;

        dealii::Point<dim> xi;
        for (unsigned int d = 0; d < dim; ++d)
          xi[d] = d == f / 2 ? f % 2 : .5;
        const auto             point = Q1::evaluate<dim>(geometry,
                                             Q1::values<dim>(xi),
                                             Q1::reference_gradients<dim>(xi));
        const auto             phi   = gather<dim>(distance, space.nodes(cell));
        dealii::Tensor<1, dim> along;
        for (unsigned int v = 0; v < phi.size(); ++v)
          along += phi[v] * point.gradients[v];
        auto normal = weighted_normal<dim>(geometry, f, xi);
        normal /= normal.norm();
        along -= (along * normal) * normal;
        add(cell,
            f,
            Q1::position<dim>(geometry.vertices, xi),
            along - along.norm() / std::tan(angle->second) * normal,
            nodal);
      }
  }



  template <int dim>
  template <typename Weight>
  void
  Curvature<dim>::find_means(const Vector      &quantity,
                             const Weight      &weight,
                             Vector            &mean,
                             std::vector<bool> &is_known) const
  {
    Vector count;
    space.initialize_scalar(mean);
    space.initialize_scalar(count);
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        double of_cell[2]{};
        for (const unsigned int node : space.nodes(c))
          {
            const double w = weight(c, node);
            of_cell[0] += w * quantity.local_element(node);
            of_cell[1] += w;
          }
        if (of_cell[1] > 0.)
          for (const unsigned int node : space.nodes(c))
            {
              mean.local_element(node) += of_cell[0];
              count.local_element(node) += of_cell[1];
            }
      }
    space.fold(mean, 1);
    space.fold(count, 1);
    is_known.assign(mean.locally_owned_size(), false);
    for (unsigned int n = 0; n < is_known.size(); ++n)
      if (count.local_element(n) > 0.)
        {
          is_known[n] = true;
          mean.local_element(n) /= count.local_element(n);
        }
  }



  template <int dim>
  void
  Curvature<dim>::take_means(const Vector &distance,
                             Vector       &weight,
                             Vector       &curvature) const
  {
    Vector            mean;
    std::vector<bool> is_known;
    find_means(
      curvature,
      [&](const unsigned int cell, const unsigned int node) {
        return weight.local_element(node) *
               std::max(0.,
                        1. -
                          std::abs(distance.local_element(node)) / reach[cell]);
      },
      mean,
      is_known);
    for (unsigned int n = 0; n < is_known.size(); ++n)
      {
        weight.local_element(n)    = is_known[n];
        curvature.local_element(n) = mean.local_element(n);
      }
    space.interpolate(weight, 1);
    space.interpolate(curvature, 1);
  }



  template <int dim>
  void
  Curvature<dim>::filter(const Vector &distance,
                         Vector       &weight,
                         Vector       &curvature) const
  {
    take_means(distance, weight, curvature);
    take_means(distance, weight, curvature);
    Vector once_more(curvature), weight_once_more(weight);
    space.interpolate(once_more, 1);
    space.interpolate(weight_once_more, 1);
    take_means(distance, weight_once_more, once_more);
    curvature.zero_out_ghost_values();
    curvature.sadd(3., -2., once_more);
    space.interpolate(curvature, 1);
  }



  template <int dim>
  void
  Curvature<dim>::spread(const double factor,
                         Vector      &weight,
                         Vector      &quantity) const
  {
    Vector            mean;
    std::vector<bool> is_known;
    find_means(
      quantity,
      [&](const unsigned int, const unsigned int node) {
        return weight.local_element(node);
      },
      mean,
      is_known);
    for (unsigned int n = 0; n < is_known.size(); ++n)
      if (weight.local_element(n) == 0. && is_known[n])
        {
          weight.local_element(n)   = 1.;
          quantity.local_element(n) = factor * mean.local_element(n);
        }
    space.interpolate(weight, 1);
    space.interpolate(quantity, 1);
  }



  template <int dim>
  void
  Curvature<dim>::find(const Vector &distance,
                       Vector       &curvature,
                       Vector       &weight) const
  {
    std::vector<Moments> nodal(space.dependences().n_nodes());
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      if (is_near(c, distance))
        {
          add_cell(c, distance, nodal);
          add_walls(c, distance, nodal);
        }
    join_moments(space, nodal);

    space.initialize_scalar(weight);
    space.initialize_scalar(curvature);
    for (unsigned int n = 0; n < curvature.locally_owned_size(); ++n)
      std::tie(curvature.local_element(n), weight.local_element(n)) =
        nodal[n].value(distance.local_element(n));
    space.interpolate(weight, 1);
    space.interpolate(curvature, 1);
    filter(distance, weight, curvature);
  }



  THALWEG_INSTANTIATE(Curvature)
} // namespace Thalweg
