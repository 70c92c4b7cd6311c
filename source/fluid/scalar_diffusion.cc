// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fluid/scalar_diffusion.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace Thalweg
{
  namespace
  {
    const double gamma_of_stages = 1. - std::sqrt(.5);

    constexpr unsigned int most_iterations = 10000;
  } // namespace



  template <int dim>
  ScalarDiffusion<dim>::ScalarDiffusion(const NodeSpace<dim>  &space,
                                        ScalarConditions<dim> &conditions,
                                        dealii::Function<dim> *source,
                                        const double           tolerance)
    : space(space)
    , conditions(conditions)
    , source(source)
    , tolerance(tolerance)
    , matrix(space)
    , is_given(space.n_owned_nodes(), false)
  {
    for (Vector *vector :
         {&load, &exchange, &source_load, &residual, &increment, &before})
      space.initialize_scalar(*vector);
    faces = boundary_faces<dim>(space.mesh().graph(),
                                [&](const dealii::types::boundary_id id) {
                                  const ScalarBoundary kind =
                                    conditions.at(id).kind;
                                  return kind == ScalarBoundary::flux ||
                                         kind == ScalarBoundary::exchange;
                                });
    collect_given_nodes();
  }



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
  void
  ScalarDiffusion<dim>::update(
    const PhaseField<dim>                        &phase,
    const typename ScalarOperator<dim>::Material &capacity,
    const typename ScalarOperator<dim>::Material &conductivity)
  {
    matrix.update(phase, capacity, conductivity);
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
  ScalarDiffusion<dim>::clear_given(Vector &scalar) const
  {
    for (const GivenNode &node : given_nodes)
      scalar.local_element(node.node) = 0.;
  }



  template <int dim>
  double
  ScalarDiffusion<dim>::content(const Vector &scalar) const
  {
    double sum = 0.;
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      sum += capacity().local_element(n) * scalar.local_element(n);
    return dealii::Utilities::MPI::sum(
      sum, space.mesh().triangulation().get_communicator());
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
  ScalarDiffusion<dim>::find_gain(const Vector &scalar)
  {
    matrix.diffuse(residual, scalar);
    for (unsigned int n = 0; n < is_given.size(); ++n)
      residual.local_element(n) +=
        load.local_element(n) -
        exchange.local_element(n) * scalar.local_element(n);
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::make_stage(Vector                    &scalar,
                                   const double               time,
                                   const double               tau,
                                   const std::vector<double> &given,
                                   const double               weight,
                                   ScalarSupply              &supply)
  {
    before.zero_out_ghost_values();
    before.copy_locally_owned_data_from(scalar);
    find_load(time);
    set_given(scalar, given);

    find_gain(scalar);
    double scale = 0.;
    for (unsigned int n = 0; n < is_given.size(); ++n)
      {
        if (is_given[n] || space.is_dependent(n))
          residual.local_element(n) = 0.;
        const double amount =
          capacity().local_element(n) / tau * scalar.local_element(n);
        scale += amount * amount;
      }
    scale = std::sqrt(dealii::Utilities::MPI::sum(
      scale, space.mesh().triangulation().get_communicator()));
    matrix.set_step(tau, exchange, is_given);
    increment               = 0.;
    const double norm       = residual.l2_norm();
    const double round_off  = std::numeric_limits<double>::epsilon() * scale;
    unsigned int iterations = 0;
    if (norm > round_off || std::isnan(norm))
      iterations = solve_cg(matrix,
                            increment,
                            residual,
                            matrix.jacobi(),
                            std::max(tolerance * norm, round_off),
                            most_iterations,
                            "scalar")
                     .iterations;
    scalar.zero_out_ghost_values();
    scalar.add(1., increment);
    space.interpolate(scalar, 1);

    increment.copy_locally_owned_data_from(scalar);
    increment.add(-1., before);
    increment *= 1. / tau;
    count(scalar, increment, weight, supply);
    return iterations;
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
  unsigned int
  ScalarDiffusion<dim>::advance(Vector       &scalar,
                                const double  time,
                                const double  dt,
                                ScalarSupply &supply)
  {
    const double              gamma = gamma_of_stages;
    const std::vector<double> end   = given_values(time + dt);
    std::vector<double>       given; // on the way there
    for (unsigned int i = 0; i < end.size(); ++i)
      {
        const double start = scalar.local_element(given_nodes[i].node);
        given.push_back(start + gamma * (end[i] - start));
      }
    Vector       stage(scalar);
    unsigned int iterations = make_stage(
      stage, time + gamma * dt, gamma * dt, given, (1. - gamma) * dt, supply);
    scalar.zero_out_ghost_values();
    stage.zero_out_ghost_values();
    // s + (1 - gamma) dt k
    const double part = (1. - gamma) / gamma;
    for (unsigned int n = 0; n < scalar.locally_owned_size(); ++n)
      scalar.local_element(n) +=
        part * (stage.local_element(n) - scalar.local_element(n));
    space.interpolate(scalar, 1);
    iterations +=
      make_stage(scalar, time + dt, gamma * dt, end, gamma * dt, supply);
    return iterations;
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



  THALWEG_INSTANTIATE(ScalarDiffusion)
} // namespace Thalweg
