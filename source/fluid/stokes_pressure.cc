// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/core/registry.h>
#include <thalweg/fluid/stokes_pressure.h>

#include <deal.II/base/quadrature_lib.h>

namespace Thalweg
{
  namespace
  {
    /// The part of @p vector along a face with @p normal.
    template <int dim>
    dealii::Tensor<1, dim>
    tangential(const dealii::Tensor<1, dim> &vector,
               const dealii::Tensor<1, dim> &normal)
    {
      return vector - (vector * normal) * normal;
    }
  } // namespace



  template <int dim>
  StokesPressure<dim>::StokesPressure(const FlowOperators<dim> &operators,
                                      const FlowBoundary<dim>  &boundary,
                                      const double kinematic_viscosity)
    : operators(operators)
    , nu(kinematic_viscosity)
    , friction(operators, boundary, kinematic_viscosity)
  {
    using namespace dealii;
    const auto           &V     = operators.velocity_space;
    const auto           &P     = operators.pressure_space;
    const auto           &graph = V.mesh().graph();
    const QGauss<dim - 1> gauss(V.degree() + 1);
    FEFaceValues<dim>     velocity(V.mapping(),
                               V.scalar().get_fe(),
                               gauss,
                               update_values | update_gradients |
                                 update_normal_vectors | update_JxW_values);
    FEFaceValues<dim>     pressure(V.mapping(),
                               P.scalar().get_fe(),
                               gauss,
                               update_gradients);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int f = 0; f < graph.n_faces; ++f)
        {
          if (!graph.at_boundary(c, f))
            continue;
          const auto &cell = graph.iterator(c);
          velocity.reinit(Compat::on_dof_handler(cell, V.scalar()), f);
          pressure.reinit(Compat::on_dof_handler(cell, P.scalar()), f);
          Face face{c, {}, {}};
          if (is_sticking_face(graph, boundary.conditions(), c, f))
            add_friction(velocity, pressure, f, face);
          add_velocity(velocity, pressure, face);
          faces.push_back(std::move(face));
        }
  }



  template <int dim>
  void
  StokesPressure<dim>::add_velocity(const dealii::FEFaceValues<dim> &velocity,
                                    const dealii::FEFaceValues<dim> &pressure,
                                    Face                            &face) const
  {
    const auto        &row   = operators.velocity_space.lexicographic();
    const auto        &place = operators.pressure_space.lexicographic();
    const unsigned int n = row.size(), m = place.size();
    face.of_velocity.resize(m * n * dim, 0.);
    for (const unsigned int q : velocity.quadrature_point_indices())
      for (unsigned int i = 0; i < m; ++i)
        {
          const auto normal = velocity.normal_vector(q);
          const auto along  = tangential(pressure.shape_grad(i, q), normal);
          for (unsigned int j = 0; j < n; ++j)
            {
              const double slope = velocity.shape_grad(j, q) * along;
              for (unsigned int d = 0; d < dim; ++d)
                face.of_velocity[(place[i] * n + row[j]) * dim + d] -=
                  velocity.JxW(q) * slope * normal[d];
            }
        }
  }



  template <int dim>
  void
  StokesPressure<dim>::add_friction(const dealii::FEFaceValues<dim> &velocity,
                                    const dealii::FEFaceValues<dim> &pressure,
                                    const unsigned int               face_no,
                                    Face                            &face) const
  {
    const auto        &fe    = operators.velocity_space.scalar().get_fe();
    const auto        &place = operators.pressure_space.lexicographic();
    const unsigned int n = fe.n_dofs_per_face(), m = place.size();
    face.of_friction.resize(m * n * dim, 0.);
    for (const unsigned int q : velocity.quadrature_point_indices())
      for (unsigned int i = 0; i < m; ++i)
        {
          const auto along =
            tangential(pressure.shape_grad(i, q), velocity.normal_vector(q));
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int d = 0; d < dim; ++d)
              face.of_friction[(place[i] * n + k) * dim + d] +=
                velocity.JxW(q) * along[d] *
                velocity.shape_value(fe.face_to_cell_index(k, face_no), q);
        }
  }



  template <int dim>
  void
  StokesPressure<dim>::add(const Vector &velocity,
                           const Vector &g,
                           Vector       &result)
  {
    const auto        &V = operators.velocity_space;
    const auto        &P = operators.pressure_space;
    const unsigned int n = V.n_nodes_per_cell(), m = P.n_nodes_per_cell();
    const double      *stress = friction.find(velocity, g).data();
    for (const Face &face : faces)
      {
        const double      *of_velocity = face.of_velocity.data();
        const double      *of_friction = face.of_friction.data();
        const unsigned int n_stress    = face.of_friction.size() / m;
        for (unsigned int i = 0; i < m; ++i)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int d = 0; d < dim; ++d)
                sum += nu * *of_velocity++ *
                       velocity.local_element(dim * V.nodes(face.cell)[j] + d);
            for (unsigned int k = 0; k < n_stress; ++k)
              sum += *of_friction++ * stress[k];
            result.local_element(P.nodes(face.cell)[i]) += sum;
          }
        stress += n_stress;
      }
  }



  THALWEG_INSTANTIATE(StokesPressure)
} // namespace Thalweg
