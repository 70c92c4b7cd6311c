#include <thalweg/fields/fixed_nodes.h>

#include <deal.II/lac/vector.h>

namespace Thalweg
{
  namespace
  {
    /// Two normals of one boundary whose cosine is larger belong to one
    /// smooth wall.
    constexpr double smooth_wall_cosine = 0.8;



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



    /// Adds the normal of a face to those of its wall, or as another part of
    /// the wall behind a sharp edge.
    template <int dim>
    void
    add_wall(
      const dealii::types::boundary_id id,
      const dealii::Tensor<1, dim>    &normal,
      std::vector<std::pair<dealii::types::boundary_id, dealii::Tensor<1, dim>>>
        &walls)
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
  } // namespace



  template <int dim>
  void
  NodeDemand<dim>::add(const dealii::types::boundary_id id,
                       const BoundaryKind               kind_of_face,
                       const dealii::Tensor<1, dim>    &normal)
  {
    if (precedence(kind_of_face) >= precedence(kind))
      {
        kind     = kind_of_face;
        boundary = id;
      }
    if (kind_of_face == BoundaryKind::slip)
      add_wall<dim>(id, normal, walls);
  }



  template <int dim>
  void
  FixedNodes<dim>::add(const unsigned int node, const NodeDemand<dim> &demand)
  {
    if (demand.kind == BoundaryKind::open)
      return;
    Node entry{node, demand.position, demand.kind, demand.boundary, {}};
    if (demand.kind == BoundaryKind::slip)
      for (const auto &[wall, normal] : demand.walls)
        add_direction(entry.directions, normal / normal.norm());
    nodes.push_back(entry);
  }



  template <int dim>
  void
  FixedNodes<dim>::apply(const BoundaryConditions<dim> &conditions,
                         Vector                        &velocity) const
  {
    project(velocity);
    dealii::Vector<double> value(dim);
    for (const Node &entry : nodes)
      if (entry.kind == BoundaryKind::velocity)
        {
          conditions.at(entry.boundary)
            .function->vector_value(entry.position, value);
          for (unsigned int d = 0; d < dim; ++d)
            velocity.local_element(dim * entry.node + d) = value[d];
        }
  }



  template <int dim>
  void
  FixedNodes<dim>::project(Vector &velocity) const
  {
    for (const Node &entry : nodes)
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



  template struct NodeDemand<2>;
  template struct NodeDemand<3>;
  THALWEG_INSTANTIATE(FixedNodes)
} // namespace Thalweg
