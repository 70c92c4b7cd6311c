// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/fixed_nodes.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

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



    /// Whether two directions are those of one smooth wall.
    template <int dim>
    bool
    is_smooth(const dealii::Tensor<1, dim> &first,
              const dealii::Tensor<1, dim> &second)
    {
      return first * second >=
             smooth_wall_cosine * first.norm() * second.norm();
    }



    /// Adds a face to its wall, or as another part of the wall behind a sharp
    /// edge.
    template <int dim>
    void
    add_face(const typename NodeDemand<dim>::Wall        &face,
             std::vector<typename NodeDemand<dim>::Wall> &walls)
    {
      for (auto &wall : walls)
        if (wall.boundary == face.boundary &&
            is_smooth(wall.normal, face.normal))
          {
            wall.normal += face.normal;
            wall.along += face.along;
            return;
          }
      walls.push_back(face);
    }



    /// Whether two walls meet in a sharp edge that sticks out into the fluid:
    /// the second one goes back behind the first.
    template <int dim>
    bool
    is_salient(const typename NodeDemand<dim>::Wall &first,
               const typename NodeDemand<dim>::Wall &second)
    {
      return !is_smooth(first.normal, second.normal) &&
             first.normal * second.along > 0.;
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
                       const dealii::Tensor<1, dim>    &normal,
                       const dealii::Tensor<1, dim>    &along)
  {
    if (precedence(kind_of_face) >= precedence(kind))
      {
        kind     = kind_of_face;
        boundary = id;
      }
    if (kind_of_face == BoundaryKind::slip)
      add_face<dim>({id, normal, along}, walls);
  }



  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  NodeDemand<dim>::fixed_directions() const
  {
    std::vector<dealii::Tensor<1, dim>> directions;
    for (const Wall &wall : walls)
      if (std::none_of(walls.begin(), walls.end(), [&](const Wall &other) {
            return is_salient<dim>(wall, other);
          }))
        add_direction(directions, wall.normal / wall.normal.norm());
    return directions;
  }



  template <int dim>
  bool
  NodeDemand<dim>::is_free() const
  {
    return kind == BoundaryKind::open ||
           (kind == BoundaryKind::slip && fixed_directions().empty());
  }



  template <int dim>
  void
  FixedNodes<dim>::add(const unsigned int node, const NodeDemand<dim> &demand)
  {
    if (demand.is_free())
      return;
    Node entry{node, demand.position, demand.kind, demand.boundary, {}};
    if (demand.kind == BoundaryKind::slip)
      entry.directions = demand.fixed_directions();
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
