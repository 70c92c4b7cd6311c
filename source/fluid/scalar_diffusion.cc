// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fluid/scalar_diffusion.h>

#include <deal.II/base/geometry_info.h>
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



  double
  ScalarSupply::total() const
  {
    double sum = source;
    for (const auto &[id, amount] : through)
      sum += amount;
    return sum;
  }



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
    for (BoundaryFace<dim> &face : boundary_faces<dim>(space.mesh().graph()))
      {
        const ScalarBoundary kind = conditions.at(face.id).kind;
        if (kind == ScalarBoundary::flux || kind == ScalarBoundary::exchange)
          faces.push_back(std::move(face));
      }
    collect_given_nodes();
  }



  template <int dim>
  void
  ScalarDiffusion<dim>::collect_given_nodes()
  {
    using Geometry                          = dealii::GeometryInfo<dim>;
    const auto                       &graph = space.mesh().graph();
    const auto                        all   = boundary_faces<dim>(graph);
    std::map<unsigned int, GivenNode> nodes;
    for (const auto &[id, condition] : conditions.all())
      {
        if (condition.kind != ScalarBoundary::value)
          continue;
        Vector measure;
        space.initialize_scalar(measure);
        for (const BoundaryFace<dim> &face : all)
          if (face.id == id)
            for (unsigned int q = 0; q < face.reference_points.size(); ++q)
              {
                const auto shape = Q1::values<dim>(face.reference_points[q]);
                for (unsigned int i = 0; i < graph.n_face_children; ++i)
                  {
                    const unsigned int v =
                      Geometry::face_to_cell_vertices(face.face_no, i);
                    measure.local_element(space.nodes(face.cell)[v]) +=
                      shape[v] * face.normals_times_weight[q].norm();
                  }
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
  void
  ScalarDiffusion<dim>::set_given(Vector &scalar, const double time) const
  {
    conditions.set_time(time);
    scalar.zero_out_ghost_values();
    for (const GivenNode &node : given_nodes)
      scalar.local_element(node.node) =
        conditions.at(node.measures.begin()->first)
          .function->value(node.position);
    space.interpolate(scalar, 1);
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
              visit(nodes[v], face.id, shape[v] * amount, shape[v] * rate);
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
    for_each_supply([this](const unsigned int node,
                           const dealii::types::boundary_id,
                           const double amount,
                           const double rate) {
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
    scalar.zero_out_ghost_values();
    for (unsigned int i = 0; i < given.size(); ++i)
      scalar.local_element(given_nodes[i].node) = given[i];
    space.interpolate(scalar, 1);

    matrix.diffuse(residual, scalar);
    double scale = 0.;
    for (unsigned int n = 0; n < is_given.size(); ++n)
      {
        double &entry = residual.local_element(n);
        entry += load.local_element(n) -
                 exchange.local_element(n) * scalar.local_element(n);
        if (is_given[n] || space.is_dependent(n))
          entry = 0.;
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
    for_each_supply([&](const unsigned int               node,
                        const dealii::types::boundary_id id,
                        const double                     amount,
                        const double                     exchange_rate) {
      supply.through[id] +=
        weight * (amount - exchange_rate * scalar.local_element(node));
    });
    for (unsigned int n = 0; n < source_load.locally_owned_size(); ++n)
      supply.source += weight * source_load.local_element(n);
    // Where the value is given comes in what it takes to hold it.
    matrix.diffuse(residual, scalar);
    for (const GivenNode &given : given_nodes)
      {
        const unsigned int n = given.node;
        const double       reaction =
          capacity().local_element(n) * rate.local_element(n) -
          residual.local_element(n) - load.local_element(n) +
          exchange.local_element(n) * scalar.local_element(n);
        double all = 0.;
        for (const auto &[id, measure] : given.measures)
          all += measure;
        for (const auto &[id, measure] : given.measures)
          supply.through[id] += weight * reaction * measure / all;
      }
  }



  template <int dim>
  unsigned int
  ScalarDiffusion<dim>::advance(Vector       &scalar,
                                const double  time,
                                const double  dt,
                                ScalarSupply &supply)
  {
    const double        gamma = gamma_of_stages;
    std::vector<double> start, end, given(given_nodes.size());
    conditions.set_time(time + dt);
    for (const GivenNode &node : given_nodes)
      {
        start.push_back(scalar.local_element(node.node));
        end.push_back(conditions.at(node.measures.begin()->first)
                        .function->value(node.position));
      }
    const auto on_the_way = [&](const double part) {
      for (unsigned int i = 0; i < given.size(); ++i)
        given[i] = start[i] + part * (end[i] - start[i]);
    };

    Vector stage(scalar);
    on_the_way(gamma);
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
  std::map<dealii::types::boundary_id, std::vector<std::pair<double, double>>>
  ScalarDiffusion<dim>::fluxes(const Vector &scalar, const double time)
  {
    std::map<dealii::types::boundary_id, std::vector<std::pair<double, double>>>
      found;
    find_load(time);
    matrix.diffuse(residual, scalar);
    for (const GivenNode &given : given_nodes)
      {
        const unsigned int n   = given.node;
        double             all = 0.;
        for (const auto &[id, measure] : given.measures)
          all += measure;
        const double out = residual.local_element(n) + load.local_element(n) -
                           exchange.local_element(n) * scalar.local_element(n);
        for (const auto &[id, measure] : given.measures)
          found[id].emplace_back(out / all, measure);
      }
    return found;
  }



  THALWEG_INSTANTIATE(ScalarDiffusion)
} // namespace Thalweg
