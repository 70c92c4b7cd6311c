// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_flow_scene_h
#define tests_support_flow_scene_h

#include <thalweg/fields/interpolation.h>
#include <thalweg/fluid/flow_operators.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include "scene.h"

/// The nodal values of a function, ghosted and consistent.
template <int dim>
Thalweg::Vector
nodal_scalar(const Thalweg::LagrangeSpace<dim>                       &space,
             const std::function<double(const dealii::Point<dim> &)> &function)
{
  Thalweg::Vector vector;
  space.initialize(vector, 1);
  Thalweg::for_each_owned_node<dim>(
    space, [&](const unsigned int node, const dealii::Point<dim> &position) {
      vector.local_element(node) = function(position);
    });
  space.interpolate(vector, 1);
  return vector;
}



/// The same of a velocity.
template <int dim>
Thalweg::Vector
nodal_velocity(
  const Thalweg::LagrangeSpace<dim> &space,
  const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)>
    &function)
{
  Thalweg::Vector vector;
  space.initialize(vector, dim);
  Thalweg::for_each_owned_node<dim>(
    space, [&](const unsigned int node, const dealii::Point<dim> &position) {
      const auto value = function(position);
      for (unsigned int d = 0; d < dim; ++d)
        vector.local_element(dim * node + d) = value[d];
    });
  space.interpolate(vector, dim);
  return vector;
}



/// The mean square difference of a scalar or a velocity in a space of its
/// own from a function, by a quadrature of high order.
template <int dim, typename Function>
double
mean_square_error(const dealii::DoFHandler<dim> &dofs,
                  const dealii::Mapping<dim>    &mapping,
                  const Thalweg::Vector         &vector,
                  const Function                &function)
{
  const unsigned int                  n = dofs.get_fe().n_components();
  const dealii::QGauss<dim>           quadrature(4);
  dealii::FEValues<dim>               values(mapping,
                               dofs.get_fe(),
                               quadrature,
                               dealii::update_values |
                                 dealii::update_JxW_values |
                                 dealii::update_quadrature_points);
  std::vector<dealii::Vector<double>> computed(quadrature.size(),
                                               dealii::Vector<double>(n));
  double                              sum = 0, volume = 0;
  for (const auto &cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        values.reinit(cell);
        values.get_function_values(vector, computed);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const auto wanted = function(values.quadrature_point(q));
            for (unsigned int c = 0; c < n; ++c)
              {
                double difference = computed[q][c];
                if constexpr (std::is_arithmetic_v<
                                std::decay_t<decltype(wanted)>>)
                  difference -= wanted;
                else
                  difference -= wanted[c];
                sum += difference * difference * values.JxW(q);
              }
            volume += values.JxW(q);
          }
      }
  return std::sqrt(sum_of_all(sum) / sum_of_all(volume));
}



/// A scene with a single fluid's flow in spaces of its own.
template <int dim>
struct FlowScene : public Scene<dim>
{
  using typename Scene<dim>::Scalar;
  using typename Scene<dim>::Field;
  using typename Scene<dim>::MeshChange;
  using Vector = Thalweg::Vector;

  FlowScene(const std::string &settings,
            const unsigned int velocity_degree,
            const unsigned int pressure_degree,
            const MeshChange  &change      = {},
            const bool         lumped_mass = false)
    : Scene<dim>(settings, change)
    , mapping(2)
    , V(this->mesh, velocity_degree, mapping)
    , P(this->mesh, pressure_degree, mapping)
    , flow_boundary(V, P, *this->conditions)
    , operators(V, P, flow_boundary, lumped_mass)
  {}

  /// Nodal values, ghosted and consistent.
  Vector
  flow_velocity(const Field &function) const
  {
    return nodal_velocity<dim>(V, function);
  }

  Vector
  flow_pressure(const Scalar &function) const
  {
    return nodal_scalar<dim>(P, function);
  }

  /// Zeros.
  Vector
  empty_velocity() const
  {
    Vector vector;
    V.initialize(vector, dim);
    return vector;
  }

  Vector
  empty_pressure() const
  {
    Vector vector;
    P.initialize(vector, 1);
    return vector;
  }

  /// Calls @p visit(node, position) for all owned nodes of a space that
  /// depend on no others.
  template <typename Visitor>
  static void
  for_each_free_node(const Thalweg::LagrangeSpace<dim> &space,
                     const Visitor                     &visit)
  {
    Thalweg::for_each_owned_node<dim>(space,
                                      [&](const unsigned int        node,
                                          const dealii::Point<dim> &position) {
                                        if (!space.is_dependent(node))
                                          visit(node, position);
                                      });
  }

  /// Of a folded vector of forces, the sum of a component over the nodes for
  /// which @p filter holds.
  template <typename Filter>
  double
  sum_where(const Vector      &force,
            const unsigned int component,
            const Filter      &filter) const
  {
    double sum = 0;
    for_each_free_node(V, [&](const unsigned int n, const auto &p) {
      if (filter(p))
        sum += force.local_element(dim * n + component);
    });
    return sum_of_all(sum);
  }

  dealii::MappingQ<dim>       mapping;
  Thalweg::LagrangeSpace<dim> V, P;
  Thalweg::FlowBoundary<dim>  flow_boundary;
  Thalweg::FlowOperators<dim> operators;
};



/// A tensor without any pattern.
template <int dim>
dealii::Tensor<2, dim>
some_matrix()
{
  dealii::Tensor<2, dim> matrix;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int e = 0; e < dim; ++e)
      matrix[d][e] = std::sin(1. + 2. * d + 5. * e);
  return matrix;
}

/// A velocity without any pattern, the same on any number of ranks.
template <int dim>
dealii::Tensor<1, dim>
wild(const dealii::Point<dim> &p)
{
  dealii::Tensor<1, dim> u;
  for (unsigned int d = 0; d < dim; ++d)
    u[d] = std::sin(37. * p[0] + 61. * p[1] + 17. * p[dim - 1] + d);
  return u;
}

/// All pairs of degrees that the method admits.
inline const std::vector<std::pair<unsigned int, unsigned int>> &
degree_pairs()
{
  static const std::vector<std::pair<unsigned int, unsigned int>> pairs{{1, 1},
                                                                        {2, 1},
                                                                        {2, 2}};
  return pairs;
}

#endif
