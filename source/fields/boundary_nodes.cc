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



    /// What the boundary faces around a node ask of its velocity.
    template <int dim>
    struct Demand
    {
      dealii::Point<dim> position;
      /// The most demanding kind of condition, in the order of precedence().
      BoundaryKind kind = BoundaryKind::open;
      /// The boundary of that kind.
      dealii::types::boundary_id boundary;
      /// Weighted normals of slip walls with their boundaries; one for each
      /// smooth part of a wall.
      std::vector<std::pair<dealii::types::boundary_id, dealii::Tensor<1, dim>>>
        walls;

      /// Adds the normal of a face to those of its wall, or as another part
      /// of the wall behind a sharp edge.
      void
      add_wall(const dealii::types::boundary_id id,
               const dealii::Tensor<1, dim>    &normal)
      {
        for (auto &[wall, mean] : walls)
          if (wall == id &&
              mean * normal >= smooth_wall_cosine * mean.norm() * normal.norm())
            {
              mean += normal;
              return;
            }
        walls.emplace_back(id, normal);
      }

      /// The fixed directions of a node at slip walls only.
      std::vector<dealii::Tensor<1, dim>>
      directions() const
      {
        std::vector<dealii::Tensor<1, dim>> result;
        for (const auto &[wall, normal] : walls)
          add_direction(result, normal / normal.norm());
        return result;
      }
    };



    /// Where boundaries meet, the condition with the greater number holds.
    int
    precedence(const BoundaryKind kind)
    {
      switch (kind)
        {
          case BoundaryKind::open:
            return 0;
          case BoundaryKind::slip:
            return 1;
          case BoundaryKind::no_slip:
            return 2;
          default:
            return 3;
        }
    }



    /// Calls @p visit(cell, face number, boundary id) for the faces of owned
    /// and ghost cells at boundaries that are not periodic.
    template <int dim, typename Visitor>
    void
    for_each_boundary_face(const CellGraph<dim> &graph, const Visitor &visit)
    {
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (const unsigned int f : graph.iterator(c)->face_indices())
          if (graph.iterator(c)->at_boundary(f) &&
              !graph.iterator(c)->has_periodic_neighbor(f))
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

    std::map<unsigned int, Demand<dim>>  demands;
    std::map<unsigned int, PressureNode> pressures;
    const auto                           add_face = [&](const unsigned int               c,
                              const unsigned int               f,
                              const dealii::types::boundary_id id) {
      const BoundaryKind kind = conditions_.at(id).kind;
      for (unsigned int i = 0; i < graph.n_face_children; ++i)
        {
          const unsigned int v = Geometry::face_to_cell_vertices(f, i);
          const unsigned int node = space.nodes(c)[v];
          const auto        &x = graph.cell(c).vertices[v];
          auto              &demand = demands[node];
          demand.position           = x;
          if (precedence(kind) >= precedence(demand.kind))
            {
              demand.kind     = kind;
              demand.boundary = id;
            }
          if (kind == BoundaryKind::open)
            pressures[node] = {node, x, id};
          if (kind == BoundaryKind::slip)
            demand.add_wall(id,
                            weighted_normal<dim>(
                              graph.cell(c), f, Geometry::unit_cell_vertex(v)));
        }
    };
    for_each_boundary_face(graph, add_face);

    const unsigned int n_owned = space.scalar_layout()->locally_owned_size();
    for (const auto &[node, demand] : demands)
      if (node < n_owned && !space.is_dependent(node) &&
          demand.kind != BoundaryKind::open)
        fixed.push_back({node,
                         demand.position,
                         demand.kind == BoundaryKind::velocity
                           ? demand.boundary
                           : dealii::numbers::invalid_boundary_id,
                         demand.kind == BoundaryKind::slip
                           ? demand.directions()
                           : std::vector<dealii::Tensor<1, dim>>()});
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
            condition.function->vector_value(
              Q1::position<dim>(graph.cell(face.cell).vertices,
                                face.reference_points[q]),
              value);
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
