// SPDX-License-Identifier: LGPL-2.1-or-later
// What boundaries give a scalar.
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fluid/scalar_diffusion.h>

#include <deal.II/lac/vector.h>

namespace Thalweg
{
  template <int dim>
  void
  ScalarDiffusion<dim>::collect_given_nodes()
  {
    std::map<unsigned int, GivenNode> nodes;
    for (const auto &[id, condition] : conditions.all())
      {
        if (condition.kind != ScalarBoundary::value)
          continue;
        Vector measure;
        space.initialize_scalar(measure);
        const auto is_this = [id = id](const dealii::types::boundary_id other) {
          return other == id;
        };
        for (const BoundaryFace<dim> &face :
             boundary_faces<dim>(space.mesh().graph(), is_this))
          for (unsigned int q = 0; q < face.reference_points.size(); ++q)
            {
              const double area  = face.normals_times_weight[q].norm();
              const auto   shape = Q1::values<dim>(face.reference_points[q]);
              for (unsigned int v = 0; v < shape.size(); ++v)
                measure.local_element(space.nodes(face.cell)[v]) +=
                  shape[v] * area;
            }
        space.fold(measure, 1);
        for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
          if (measure.local_element(n) > 0. && !space.is_dependent(n))
            {
              nodes[n].measures[id] = measure.local_element(n);
              is_given[n]           = true;
            }
      }
    for (auto &[n, node] : nodes)
      given_nodes.push_back({n, space.position(n), std::move(node.measures)});
  }



  template <int dim>
  std::vector<double>
  ScalarDiffusion<dim>::given_values(const double time) const
  {
    conditions.set_time(time);
    std::vector<double> values;
    for (const GivenNode &node : given_nodes)
      values.push_back(conditions.at(node.measures.begin()->first)
                         .function->value(node.position));
    return values;
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::set_given(Vector                    &scalar,
                                  const std::vector<double> &values) const
  {
    scalar.zero_out_ghost_values();
    for (unsigned int i = 0; i < values.size(); ++i)
      scalar.local_element(given_nodes[i].node) = values[i];
    space.interpolate(scalar, 1);
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::set_given(Vector &scalar, const double time) const
  {
    set_given(scalar, given_values(time));
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::set_given_heat(Vector &heat, const double time) const
  {
    set_given(heat, heats_of(given_values(time)));
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::clear_given(Vector &scalar) const
  {
    for (const GivenNode &node : given_nodes)
      scalar.local_element(node.node) = 0.;
  }



  template <int dim>
  template <typename Visitor>
  void
  ScalarDiffusion<dim>::for_each_supply(const Visitor &visit) const
  {
    dealii::Vector<double> outside(2);
    for (const BoundaryFace<dim> &face : faces)
      {
        const auto &condition   = conditions.at(face.id);
        const bool  is_exchange = condition.kind == ScalarBoundary::exchange;
        const auto &cell        = space.mesh().graph().cell(face.cell);
        const auto &nodes       = space.nodes(face.cell);
        for (unsigned int q = 0; q < face.reference_points.size(); ++q)
          {
            const auto  &xi     = face.reference_points[q];
            const auto   x      = Q1::position<dim>(cell.vertices, xi);
            const double area   = face.normals_times_weight[q].norm();
            const auto   shape  = Q1::values<dim>(xi);
            double       amount = 0., rate = 0.;
            if (is_exchange)
              {
                condition.function->vector_value(x, outside);
                rate   = area * outside[0];
                amount = rate * outside[1];
              }
            else
              amount = area * condition.function->value(x);
            for (unsigned int v = 0; v < shape.size(); ++v)
              visit(nodes[v], shape[v] * amount, shape[v] * rate);
          }
      }
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::find_load(const double time)
  {
    conditions.set_time(time);
    for (Vector *vector : {&load, &exchange, &source_load})
      {
        vector->zero_out_ghost_values();
        *vector = 0.;
      }
    for_each_supply(
      [this](const unsigned int node, const double amount, const double rate) {
        load.local_element(node) += amount;
        exchange.local_element(node) += rate;
      });
    space.fold(load, 1);
    space.fold(exchange, 1);
    load.zero_out_ghost_values();
    exchange.zero_out_ghost_values();
    if (source == nullptr)
      return;
    source->set_time(time);
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      if (!space.is_dependent(n))
        source_load.local_element(n) =
          matrix.measure().local_element(n) * source->value(space.position(n));
    load.add(1., source_load);
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::count(const Vector &scalar,
                              const Vector &rate,
                              const double  weight,
                              ScalarSupply &supply)
  {
    for_each_supply([&](const unsigned int node,
                        const double       amount,
                        const double       exchange_rate) {
      supply.through +=
        weight * (amount - exchange_rate * scalar.local_element(node));
    });
    for (unsigned int n = 0; n < source_load.locally_owned_size(); ++n)
      supply.source += weight * source_load.local_element(n);
    // Where the value is given comes in what it takes to hold it.
    find_gain(scalar);
    for (const GivenNode &given : given_nodes)
      supply.through += weight * (capacity().local_element(given.node) *
                                    rate.local_element(given.node) -
                                  residual.local_element(given.node));
  }



  template <int dim>
  BoundaryFluxes
  ScalarDiffusion<dim>::fluxes(const Vector &scalar, const double time)
  {
    BoundaryFluxes found;
    find_load(time);
    find_gain(scalar);
    for (const GivenNode &given : given_nodes)
      {
        double all = 0.;
        for (const auto &[id, measure] : given.measures)
          all += measure;
        for (const auto &[id, measure] : given.measures)
          found[id].emplace_back(residual.local_element(given.node) / all,
                                 measure);
      }
    return found;
  }



#define THALWEG_INSTANTIATE_BOUNDARY(dim)                                      \
  template void                ScalarDiffusion<dim>::collect_given_nodes();    \
  template std::vector<double> ScalarDiffusion<dim>::given_values(             \
    const double) const;                                                       \
  template void ScalarDiffusion<dim>::set_given(Vector &,                      \
                                                const std::vector<double> &)   \
    const;                                                                     \
  template void ScalarDiffusion<dim>::set_given(Vector &, const double) const; \
  template void ScalarDiffusion<dim>::set_given_heat(Vector &, const double)   \
    const;                                                                     \
  template void           ScalarDiffusion<dim>::clear_given(Vector &) const;   \
  template void           ScalarDiffusion<dim>::find_load(const double);       \
  template void           ScalarDiffusion<dim>::count(const Vector &,          \
                                            const Vector &,          \
                                            const double,            \
                                            ScalarSupply &);         \
  template BoundaryFluxes ScalarDiffusion<dim>::fluxes(const Vector &,         \
                                                       const double);
  THALWEG_INSTANTIATE_BOUNDARY(2)
  THALWEG_INSTANTIATE_BOUNDARY(3)
#undef THALWEG_INSTANTIATE_BOUNDARY
} // namespace Thalweg
