// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fluid/boundary_reaction.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Thalweg
{
  template <int dim>
  BoundaryReaction<dim>::BoundaryReaction(const FlowOperators<dim> &operators,
                                          const FlowBoundary<dim>  &boundary,
                                          const double kinematic_viscosity)
    : operators(operators)
    , boundary(boundary)
    , nu(kinematic_viscosity)
  {
    const auto &space = operators.velocity_space;
    space.initialize(velocity, dim);
    space.initialize(acceleration, dim);
    space.initialize(area, dim);
    collect_boundary_cells();
    collect_faces();
  }



  template <int dim>
  void
  BoundaryReaction<dim>::collect_boundary_cells()
  {
    const auto &space = operators.velocity_space;
    // Cells of other ranks add to nodes of this one, too.
    Vector is_fixed;
    space.initialize(is_fixed, 1);
    for (const auto &node : boundary.fixed().all())
      is_fixed.local_element(node.node) = 1.;
    space.interpolate(is_fixed, 1);
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      {
        bool any = false;
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          any = any || is_fixed.local_element(space.nodes(c)[i]) > 0.;
        if (any)
          boundary_cells.push_back(c);
      }
  }



  template <int dim>
  void
  BoundaryReaction<dim>::collect_faces()
  {
    using namespace dealii;
    const auto           &V   = operators.velocity_space;
    const auto           &P   = operators.pressure_space;
    const auto           &row = V.lexicographic(), &place = P.lexicographic();
    const unsigned int    n = row.size(), m = place.size();
    const QGauss<dim - 1> gauss(V.degree() + 1);
    FEFaceValues<dim>     velocity(V.mapping(),
                               V.scalar().get_fe(),
                               gauss,
                               update_values | update_normal_vectors |
                                 update_JxW_values);
    FEFaceValues<dim>     pressure(V.mapping(),
                               P.scalar().get_fe(),
                               gauss,
                               update_values);
    for_each_sticking_face(
      V.mesh().graph(),
      boundary.conditions(),
      [&](const unsigned int c, const unsigned int f) {
        const auto &cell = V.mesh().graph().iterator(c);
        velocity.reinit(Compat::on_dof_handler(cell, V.scalar()), f);
        pressure.reinit(Compat::on_dof_handler(cell, P.scalar()), f);
        Face face{c, {n * m, Tensor<1, dim>()}};
        for (unsigned int q = 0; q < gauss.size(); ++q)
          for (unsigned int i = 0; i < n; ++i)
            {
              const double w = velocity.shape_value(i, q) * velocity.JxW(q);
              for (unsigned int d = 0; d < dim; ++d)
                area.local_element(dim * V.nodes(c)[row[i]] + d) += w;
              for (unsigned int j = 0; j < m; ++j)
                face.pressure[row[i] * m + place[j]] +=
                  w * pressure.shape_value(j, q) * velocity.normal_vector(q);
            }
        faces.push_back(std::move(face));
      });
    V.fold(area, dim);
  }



  template <int dim>
  void
  BoundaryReaction<dim>::add_convection(const double factor,
                                        Vector      &force) const
  {
    using namespace dealii;
    const auto        &space = operators.velocity_space;
    const auto        &row   = space.lexicographic();
    const unsigned int n     = row.size();
    const QGauss<dim>  gauss(space.degree() + 2);
    FEValues<dim>      values(space.mapping(),
                         space.scalar().get_fe(),
                         gauss,
                         update_values | update_gradients | update_JxW_values);
    for (const unsigned int c : boundary_cells)
      {
        values.reinit(Compat::on_dof_handler(space.mesh().graph().iterator(c),
                                             space.scalar()));
        const unsigned int *const nodes = space.nodes(c);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            Tensor<1, dim> u;
            Tensor<2, dim> gradient;
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double nodal =
                    velocity.local_element(dim * nodes[row[i]] + d);
                  u[d] += nodal * values.shape_value(i, q);
                  gradient[d] += nodal * values.shape_grad(i, q);
                }
            const Tensor<1, dim> convection =
              (factor * values.JxW(q)) * (gradient * u);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int d = 0; d < dim; ++d)
                force.local_element(dim * nodes[row[i]] + d) +=
                  values.shape_value(i, q) * convection[d];
          }
      }
  }



  template <int dim>
  void
  BoundaryReaction<dim>::find(const Vector &begin_velocity,
                              const Vector &end_velocity,
                              const Vector &pressure,
                              const Vector &body_force,
                              const double  dt,
                              const double  density,
                              Vector       &reaction)
  {
    const auto &space = operators.velocity_space;
    velocity.zero_out_ghost_values();
    velocity = 0.;
    velocity.add(.5, begin_velocity);
    velocity.add(.5, end_velocity);
    space.interpolate(velocity, dim);
    acceleration.zero_out_ghost_values();
    acceleration = 0.;
    acceleration.add(1. / dt, end_velocity);
    acceleration.add(-1. / dt, begin_velocity);
    acceleration.add(-1., body_force);
    space.interpolate(acceleration, dim);

    reaction.zero_out_ghost_values();
    reaction = 0.;
    operators.mass.add_product(acceleration, reaction, dim, -density);
    operators.stiffness.add_product(velocity, reaction, dim, -density * nu);
    operators.add_pressure_force(pressure, reaction, -density);
    add_convection(-density, reaction);
    space.fold(reaction, dim);

    // What remains at free nodes is the error of the time integration.
    Vector free = reaction;
    boundary.project(free);
    reaction.add(-1., free);
    space.interpolate(reaction, dim);
  }



  template <int dim>
  void
  BoundaryReaction<dim>::find_traction(const Vector &reaction,
                                       const Vector &pressure,
                                       const double  density,
                                       Vector       &traction) const
  {
    const auto        &V = operators.velocity_space;
    const auto        &P = operators.pressure_space;
    const unsigned int n = V.n_nodes_per_cell(), m = P.n_nodes_per_cell();
    traction.zero_out_ghost_values();
    traction = 0.;
    for (const Face &face : faces)
      for (unsigned int i = 0; i < n; ++i)
        {
          dealii::Tensor<1, dim> force;
          for (unsigned int j = 0; j < m; ++j)
            force += pressure.local_element(P.nodes(face.cell)[j]) *
                     face.pressure[i * m + j];
          for (unsigned int d = 0; d < dim; ++d)
            traction.local_element(dim * V.nodes(face.cell)[i] + d) -=
              density * force[d];
        }
    V.fold(traction, dim);
    for (unsigned int i = 0; i < dim * V.n_owned_nodes(); ++i)
      if (area.local_element(i) > 0.)
        traction.local_element(i) =
          (traction.local_element(i) + reaction.local_element(i)) /
          area.local_element(i);
      else
        traction.local_element(i) = 0.;
    V.interpolate(traction, dim);
  }



  THALWEG_INSTANTIATE(BoundaryReaction)
} // namespace Thalweg
