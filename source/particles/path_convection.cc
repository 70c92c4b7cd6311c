// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/feet.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/path_convection.h>
#include <thalweg/particles/path_field.h>

#include <deal.II/base/exceptions.h>

#include <cstdlib>
#include <string>

namespace Thalweg
{
  namespace
  {
    [[noreturn]] void
    refuse(const unsigned int degree)
    {
      AssertThrow(false,
                  dealii::ExcMessage("Particles follow fields of degree 1 or "
                                     "2, not " +
                                     std::to_string(degree) + "."));
      std::abort();
    }
  } // namespace


  template <int dim>
  PathConvection<dim>::PathConvection(
    const Mesh<dim>                                      &mesh,
    const ConvectionParameters                           &parameters,
    const std::map<dealii::types::boundary_id, WallKind> &walls)
    : mesh_(mesh)
    , settings(walk_settings(parameters, walls))
  {}


  template <int dim>
  template <unsigned int degree>
  ConvectionReport
  PathConvection<dim>::move_in(Population<dim>       &population,
                               const PathFields<dim> &fields,
                               const double           dt) const
  {
    using Field                            = PathField<dim, degree>;
    const auto                      &graph = mesh_.graph();
    const StreamlineWalk<dim, Field> walk(
      graph, Field(graph, fields, dt, settings.substep, 1.), settings);
    return move_along(population, walk, dt);
  }


  template <int dim>
  template <unsigned int degree>
  std::vector<Foot<dim>>
  PathConvection<dim>::trace_back_in(
    const std::vector<unsigned int>       &cells,
    const std::vector<dealii::Point<dim>> &reference_points,
    const PathFields<dim>                 &fields,
    const double                           dt) const
  {
    using Field                            = PathField<dim, degree>;
    const auto                      &graph = mesh_.graph();
    const StreamlineWalk<dim, Field> walk(
      graph, Field(graph, fields, dt, settings.substep, -1.), settings);
    return find_feet(walk,
                     mesh_.triangulation().get_communicator(),
                     cells,
                     reference_points,
                     dt,
                     [&](const PathWalker<dim> &walker) {
                       Sight<dim> sight;
                       sight.velocity =
                         walk.field().flow_velocity(graph.cell(walker.cell),
                                                    walker.cell,
                                                    walker.reference,
                                                    walker.time);
                       for (unsigned int d = 0; d < dim; ++d)
                         sight.velocity[d] += walker.integral[d];
                       sight.level_set = -1.;
                       return sight;
                     });
  }


  template <int dim>
  ConvectionReport
  PathConvection<dim>::move(Population<dim>       &population,
                            const PathFields<dim> &fields,
                            const double           dt) const
  {
    if (fields.degree == 1)
      return move_in<1>(population, fields, dt);
    if (fields.degree == 2)
      return move_in<2>(population, fields, dt);
    refuse(fields.degree);
  }


  template <int dim>
  std::vector<Foot<dim>>
  PathConvection<dim>::trace_back(
    const std::vector<unsigned int>       &cells,
    const std::vector<dealii::Point<dim>> &reference_points,
    const PathFields<dim>                 &fields,
    const double                           dt) const
  {
    if (fields.degree == 1)
      return trace_back_in<1>(cells, reference_points, fields, dt);
    if (fields.degree == 2)
      return trace_back_in<2>(cells, reference_points, fields, dt);
    refuse(fields.degree);
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::PathConvection)
