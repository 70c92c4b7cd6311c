// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_postprocess_own_flow_h
#define tests_postprocess_own_flow_h

#include <thalweg/core/compat.h>
#include <thalweg/fields/flow_fields.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <functional>

#include "fixture.h"

/// A flow in spaces of its own, interpolated from functions, on the mesh of
/// a scene.
template <int dim>
class OwnFlow
{
public:
  using Point  = dealii::Point<dim>;
  using Tensor = dealii::Tensor<1, dim>;

  OwnFlow(const Thalweg::Mesh<dim>                   &mesh,
          const unsigned int                          pressure_degree,
          const std::function<Tensor(const Point &)> &velocity_function,
          const std::function<double(const Point &)> &pressure_function,
          const double                                density   = 1.,
          const double                                viscosity = 1.)
    : mapping(2)
    , fe_velocity(dealii::FE_Q<dim>(2), dim)
    , fe_pressure(pressure_degree)
    , velocity_dofs(mesh.triangulation())
    , pressure_dofs(mesh.triangulation())
    , fields{mapping,
             velocity_dofs,
             pressure_dofs,
             velocity,
             pressure,
             &reaction,
             &traction,
             density,
             viscosity,
             0.}
  {
    velocity_dofs.distribute_dofs(fe_velocity);
    pressure_dofs.distribute_dofs(fe_pressure);
    for (auto *const vector : {&velocity, &reaction})
      initialize(velocity_dofs, *vector);
    initialize(pressure_dofs, pressure);
    set_velocity(velocity_function);
    interpolate(pressure_dofs,
                dealii::ScalarFunctionFromFunctionObject<dim>(
                  pressure_function),
                pressure);
  }

  void
  set_velocity(const std::function<Tensor(const Point &)> &function)
  {
    interpolate(velocity_dofs, VelocityFunction(function), velocity);
  }

  /// Without it there is no traction.
  void
  set_traction(const std::function<Tensor(const Point &)> &function)
  {
    initialize(velocity_dofs, traction);
    interpolate(velocity_dofs, VelocityFunction(function), traction);
  }

  /// Sets the reaction to minus the integral of div(sigma . phi_i), which is
  /// what the stresses do to the boundary nodes; for a velocity that is
  /// linear and a pressure with the gradient @p pressure_gradient.
  void
  set_reaction(const Tensor &pressure_gradient)
  {
    const dealii::QGauss<dim>                quadrature(7);
    dealii::FEValues<dim>                    v(mapping,
                            fe_velocity,
                            quadrature,
                            dealii::update_values | dealii::update_gradients |
                              dealii::update_JxW_values);
    dealii::FEValues<dim>                    p(mapping,
                            fe_pressure,
                            quadrature,
                            dealii::update_values);
    const dealii::FEValuesExtractors::Vector extractor(0);
    std::vector<double>                      pressures(v.n_quadrature_points);
    std::vector<dealii::Tensor<2, dim>>      gradients(v.n_quadrature_points);
    std::vector<dealii::types::global_dof_index> indices(
      fe_velocity.dofs_per_cell);
    const auto hanging = hanging_nodes(velocity_dofs);
    reaction.zero_out_ghost_values();
    reaction = 0.;
    for (const auto &cell : velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          v.reinit(cell);
          p.reinit(Thalweg::Compat::on_dof_handler(cell, pressure_dofs));
          p.get_function_values(pressure, pressures);
          v[extractor].get_function_gradients(velocity, gradients);
          cell->get_dof_indices(indices);
          dealii::Vector<double> local(indices.size());
          for (unsigned int q = 0; q < v.n_quadrature_points; ++q)
            {
              dealii::Tensor<2, dim> stress =
                fields.viscosity * (gradients[q] + transpose(gradients[q]));
              for (unsigned int d = 0; d < dim; ++d)
                stress[d][d] -= pressures[q];
              for (unsigned int i = 0; i < indices.size(); ++i)
                local(i) +=
                  (v[extractor].value(i, q) * pressure_gradient -
                   scalar_product(stress, v[extractor].gradient(i, q))) *
                  v.JxW(q);
            }
          hanging.distribute_local_to_global(local, indices, reaction);
        }
    reaction.compress(dealii::VectorOperation::add);
    reaction.update_ghost_values();
  }

private:
  class VelocityFunction : public dealii::Function<dim>
  {
  public:
    explicit VelocityFunction(
      const std::function<Tensor(const Point &)> &function)
      : dealii::Function<dim>(dim)
      , function(function)
    {}

    double
    value(const Point &p, const unsigned int component) const override
    {
      return function(p)[component];
    }

  private:
    const std::function<Tensor(const Point &)> &function;
  };

  dealii::MappingQ<dim>   mapping;
  dealii::FESystem<dim>   fe_velocity;
  dealii::FE_Q<dim>       fe_pressure;
  dealii::DoFHandler<dim> velocity_dofs, pressure_dofs;
  Thalweg::Vector         velocity, pressure, reaction, traction;

  static dealii::IndexSet
  relevant(const dealii::DoFHandler<dim> &dofs)
  {
    dealii::IndexSet set;
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, set);
    return set;
  }

  static dealii::AffineConstraints<double>
  hanging_nodes(const dealii::DoFHandler<dim> &dofs)
  {
    dealii::AffineConstraints<double> hanging(relevant(dofs));
    dealii::DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();
    return hanging;
  }

  static void
  initialize(const dealii::DoFHandler<dim> &dofs, Thalweg::Vector &vector)
  {
    vector.reinit(dofs.locally_owned_dofs(),
                  relevant(dofs),
                  dofs.get_communicator());
  }

  void
  interpolate(const dealii::DoFHandler<dim> &dofs,
              const dealii::Function<dim>   &function,
              Thalweg::Vector               &vector) const
  {
    const auto hanging = hanging_nodes(dofs);
    vector.zero_out_ghost_values();
    dealii::VectorTools::interpolate(mapping, dofs, function, vector);
    hanging.distribute(vector);
    vector.update_ghost_values();
  }

public:
  const Thalweg::FlowFields<dim> fields;
};

#endif
