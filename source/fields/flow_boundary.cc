// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fields/flow_boundary.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Thalweg
{
  namespace
  {
    /// Calls @p visit(boundary id, local node, position, normal, way from the
    /// node to the face's centre) for each
    /// node of each boundary face that is not periodic, of owned and ghost
    /// cells.
    template <int dim, typename Visitor>
    void
    for_each_boundary_node(const LagrangeSpace<dim> &space,
                           const Visitor            &visit)
    {
      const auto                       &fe = space.scalar().get_fe();
      const dealii::Quadrature<dim - 1> nodes(
        fe.get_unit_face_support_points());
      dealii::FEFaceValues<dim> values(space.mapping(),
                                       fe,
                                       nodes,
                                       dealii::update_quadrature_points |
                                         dealii::update_normal_vectors);
      const auto               &graph = space.mesh().graph();
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (const unsigned int f : graph.iterator(c)->face_indices())
          if (graph.at_boundary(c, f))
            {
              values.reinit(Compat::on_dof_handler(graph.iterator(c),
                                                   space.scalar()),
                            f);
              for (unsigned int i = 0; i < nodes.size(); ++i)
                {
                  const unsigned int place =
                    space.lexicographic()[fe.face_to_cell_index(i, f)];
                  visit(graph.iterator(c)->face(f)->boundary_id(),
                        space.nodes(c)[place],
                        values.quadrature_point(i),
                        graph.iterator(c)->face(f)->diameter() *
                          values.normal_vector(i),
                        graph.iterator(c)->face(f)->center() -
                          values.quadrature_point(i));
                }
            }
    }
  } // namespace



  template <int dim>
  FlowBoundary<dim>::FlowBoundary(const LagrangeSpace<dim>      &velocity_space,
                                  const LagrangeSpace<dim>      &pressure_space,
                                  const BoundaryConditions<dim> &conditions)
    : conditions_(conditions)
  {
    collect_velocity(velocity_space);
    collect_pressure(pressure_space);
  }



  template <int dim>
  void
  FlowBoundary<dim>::collect_velocity(const LagrangeSpace<dim> &space)
  {
    using Place = std::pair<unsigned int, dealii::types::boundary_id>;
    std::map<unsigned int, NodeDemand<dim>> demands;
    std::map<Place, dealii::Tensor<1, dim>> sums;
    for_each_boundary_node(space,
                           [&](const dealii::types::boundary_id id,
                               const unsigned int               node,
                               const dealii::Point<dim>        &position,
                               const dealii::Tensor<1, dim>    &normal,
                               const dealii::Tensor<1, dim>    &along) {
                             demands[node].position = position;
                             demands[node].add(id,
                                               conditions_.at(id).kind,
                                               normal,
                                               along);
                             sums[{node, id}] += normal;
                           });
    for (const auto &[node, demand] : demands)
      if (node < space.n_owned_nodes() && !space.is_dependent(node) &&
          !demand.is_free())
        {
          fixed_nodes.add(node, demand);
          if (demand.kind == BoundaryKind::slip)
            slip_nodes.add(node, demand);
          normals.push_back(sums[{node, demand.boundary}]);
        }
  }



  template <int dim>
  void
  FlowBoundary<dim>::collect_pressure(const LagrangeSpace<dim> &space)
  {
    std::map<unsigned int, OpenNode> nodes;
    for_each_boundary_node(space,
                           [&](const dealii::types::boundary_id id,
                               const unsigned int               node,
                               const dealii::Point<dim>        &position,
                               const dealii::Tensor<1, dim> &,
                               const dealii::Tensor<1, dim> &) {
                             if (conditions_.at(id).kind == BoundaryKind::open)
                               nodes[node] = {node, position, id};
                           });
    for (const auto &[node, entry] : nodes)
      if (node < space.n_owned_nodes() && !space.is_dependent(node))
        open.push_back(entry);
  }



  template <int dim>
  void
  FlowBoundary<dim>::project_acceleration(Vector &acceleration) const
  {
    // Fluid that does not pass a boundary of given velocity sticks to it.
    // Normals have lost some digits far from the origin.
    constexpr double       impervious = 1e-6;
    Vector                 projected  = acceleration;
    dealii::Vector<double> value(dim);
    fixed_nodes.project(projected);
    for (unsigned int i = 0; i < normals.size(); ++i)
      {
        const auto &entry = fixed_nodes.all()[i];
        if (entry.kind == BoundaryKind::velocity)
          {
            conditions_.at(entry.boundary)
              .function->vector_value(entry.position, value);
            double flux = 0;
            for (unsigned int d = 0; d < dim; ++d)
              flux += value[d] * normals[i][d];
            if (std::abs(flux) >
                impervious * value.l2_norm() * normals[i].norm())
              continue;
          }
        for (unsigned int d = 0; d < dim; ++d)
          acceleration.local_element(dim * entry.node + d) =
            projected.local_element(dim * entry.node + d);
      }
  }



  template <int dim>
  void
  FlowBoundary<dim>::apply_open(Vector &pressure, const double factor) const
  {
    for (const OpenNode &entry : open)
      pressure.local_element(entry.node) =
        factor * conditions_.at(entry.id).function->value(entry.position);
  }



  template <int dim>
  void
  FlowBoundary<dim>::project_open(Vector &pressure) const
  {
    for (const OpenNode &entry : open)
      pressure.local_element(entry.node) = 0.;
  }



  THALWEG_INSTANTIATE(FlowBoundary)
} // namespace Thalweg
