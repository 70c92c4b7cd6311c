// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/boundary_nodes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Thalweg
{
  namespace
  {
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
  std::vector<bool>
  BoundaryNodes<dim>::cells_with_given_nodes() const
  {
    Vector given;
    space.initialize_scalar(given);
    for (const auto &entry : fixed.all())
      if (entry.directions.empty())
        given.local_element(entry.node) = 1.;
    space.interpolate(given, 1);
    std::vector<bool> cells(space.mesh().graph().n_owned_cells());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (const unsigned int node : space.nodes(c))
        cells[c] = cells[c] || given.local_element(node) == 1.;
    return cells;
  }



  template <int dim>
  void
  BoundaryNodes<dim>::collect_faces()
  {
    faces = boundary_faces<dim>(space.mesh().graph(),
                                [this](const dealii::types::boundary_id id) {
                                  const BoundaryKind kind =
                                    conditions_.at(id).kind;
                                  return kind == BoundaryKind::open ||
                                         kind == BoundaryKind::velocity;
                                });
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
