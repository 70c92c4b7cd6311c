#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_cell.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Thalweg
{
  namespace
  {
    /// Two normals of one boundary whose cosine is larger belong to one
    /// smooth wall.
    constexpr double smooth_wall_cosine = 0.8;

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



    /// Adds @p normal to an orthonormal set unless it is contained already.
    template <int dim>
    void
    add_direction(std::vector<dealii::Tensor<1, dim>> &directions,
                  dealii::Tensor<1, dim>               normal)
    {
      for (const auto &direction : directions)
        normal -= (normal * direction) * direction;
      if (normal.norm() >
          std::sqrt(1. - smooth_wall_cosine * smooth_wall_cosine))
        directions.push_back(normal / normal.norm());
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
    const CellGraph<dim> &graph = space.mesh().graph();
    Vector                layout;
    space.initialize_scalar(layout);
    const unsigned int n_owned = layout.locally_owned_size();

    std::map<unsigned int, FixedNode> nodes;
    std::map<unsigned int,
             std::map<dealii::types::boundary_id, dealii::Tensor<1, dim>>>
                                         slip_normals;
    std::map<unsigned int, PressureNode> pressures;
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (const unsigned int f : graph.iterator(c)->face_indices())
        {
          if (!graph.iterator(c)->at_boundary(f) ||
              graph.iterator(c)->has_periodic_neighbor(f))
            continue;
          const auto  id        = graph.iterator(c)->face(f)->boundary_id();
          const auto &condition = conditions_.at(id);
          for (unsigned int v = 0; v < graph.n_face_children; ++v)
            {
              const unsigned int vertex =
                dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v);
              const unsigned int node = space.nodes(c)[vertex];
              const auto        &x    = graph.cell(c).vertices[vertex];
              if (condition.kind == BoundaryKind::open)
                pressures[node] = {node, x, id};
              else if (condition.kind == BoundaryKind::slip)
                {
                  auto normal = weighted_normal<dim>(
                    graph.cell(c),
                    f,
                    dealii::GeometryInfo<dim>::unit_cell_vertex(vertex));
                  auto &mean = slip_normals[node][id];
                  // Sharp edges within one boundary keep both directions.
                  if (mean.norm() > 0 && mean * normal < smooth_wall_cosine *
                                                           mean.norm() *
                                                           normal.norm())
                    {
                      auto &entry = nodes[node];
                      entry.node  = node;
                      if (entry.directions.empty())
                        entry.velocity_boundary =
                          dealii::numbers::invalid_boundary_id;
                      add_direction(entry.directions, normal / normal.norm());
                    }
                  else
                    mean += normal;
                  if (nodes.count(node) == 0)
                    nodes[node] = {node,
                                   x,
                                   dealii::numbers::invalid_boundary_id,
                                   {}};
                  nodes[node].position = x;
                }
            }
        }
    for (auto &[node, normals] : slip_normals)
      for (auto &[id, normal] : normals)
        add_direction(nodes[node].directions, normal / normal.norm());

    // Given velocities and no slip override slip, and no slip gives way to
    // a given velocity.
    for (const BoundaryKind kind :
         {BoundaryKind::no_slip, BoundaryKind::velocity})
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (const unsigned int f : graph.iterator(c)->face_indices())
          if (graph.iterator(c)->at_boundary(f) &&
              !graph.iterator(c)->has_periodic_neighbor(f))
            {
              const auto id = graph.iterator(c)->face(f)->boundary_id();
              if (conditions_.at(id).kind != kind)
                continue;
              for (unsigned int v = 0; v < graph.n_face_children; ++v)
                {
                  const unsigned int vertex =
                    dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v);
                  const unsigned int node = space.nodes(c)[vertex];
                  nodes[node]             = {node,
                                             graph.cell(c).vertices[vertex],
                                 kind == BoundaryKind::velocity
                                               ? id
                                               : dealii::numbers::invalid_boundary_id,
                                             {}};
                }
            }
    for (const auto &[node, entry] : nodes)
      if (node < n_owned && !space.is_dependent(node))
        fixed.push_back(entry);
    for (const auto &[node, entry] : pressures)
      if (!space.is_dependent(node))
        open_nodes.push_back(entry);
  }



  template <int dim>
  void
  BoundaryNodes<dim>::collect_faces()
  {
    const CellGraph<dim>         &graph = space.mesh().graph();
    const dealii::QGauss<dim - 1> gauss(2);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        {
          const auto &behind = graph.cell(c).faces[f];
          if (behind.behind != CellGraph<dim>::Behind::boundary)
            continue;
          const BoundaryKind kind = conditions_.at(behind.boundary_id).kind;
          if (kind != BoundaryKind::open && kind != BoundaryKind::velocity)
            continue;
          Face face{c, f, behind.boundary_id, {}, {}};
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              dealii::Point<dim> xi;
              xi[f / 2] = f % 2;
              for (unsigned int d = 0, e = 0; d < dim; ++d)
                if (d != f / 2)
                  xi[d] = gauss.point(q)[e++];
              face.reference_points.push_back(xi);
              face.normals_times_weight.push_back(
                gauss.weight(q) * weighted_normal<dim>(graph.cell(c), f, xi));
            }
          faces.push_back(face);
        }
  }



  template <int dim>
  void
  BoundaryNodes<dim>::apply(Vector &velocity) const
  {
    project(velocity);
    dealii::Vector<double> value(dim);
    for (const FixedNode &entry : fixed)
      if (entry.velocity_boundary != dealii::numbers::invalid_boundary_id)
        {
          conditions_.at(entry.velocity_boundary)
            .function->vector_value(entry.position, value);
          for (unsigned int d = 0; d < dim; ++d)
            velocity.local_element(dim * entry.node + d) = value[d];
        }
  }



  template <int dim>
  void
  BoundaryNodes<dim>::project(Vector &velocity) const
  {
    for (const FixedNode &entry : fixed)
      if (entry.directions.empty())
        for (unsigned int d = 0; d < dim; ++d)
          velocity.local_element(dim * entry.node + d) = 0.;
      else
        for (const auto &direction : entry.directions)
          {
            double component = 0;
            for (unsigned int d = 0; d < dim; ++d)
              component +=
                direction[d] * velocity.local_element(dim * entry.node + d);
            for (unsigned int d = 0; d < dim; ++d)
              velocity.local_element(dim * entry.node + d) -=
                component * direction[d];
          }
  }



  template <int dim>
  void
  BoundaryNodes<dim>::add_flux(const double factor, Vector &scalar) const
  {
    const CellGraph<dim>  &graph = space.mesh().graph();
    dealii::Vector<double> value(dim);
    for (const Face &face : faces)
      {
        const auto &condition = conditions_.at(face.id);
        if (condition.kind != BoundaryKind::velocity)
          continue;
        for (unsigned int q = 0; q < face.reference_points.size(); ++q)
          {
            const auto shape = Q1::values<dim>(face.reference_points[q]);
            dealii::Point<dim> x;
            for (unsigned int v = 0; v < shape.size(); ++v)
              x += shape[v] *
                   dealii::Tensor<1, dim>(graph.cell(face.cell).vertices[v]);
            condition.function->vector_value(x, value);
            double flux = 0;
            for (unsigned int d = 0; d < dim; ++d)
              flux += value[d] * face.normals_times_weight[q][d];
            for (unsigned int v = 0; v < shape.size(); ++v)
              scalar.local_element(space.nodes(face.cell)[v]) +=
                factor * shape[v] * flux;
          }
      }
  }



  THALWEG_INSTANTIATE(BoundaryNodes)
} // namespace Thalweg
