// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/boundary_flux.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// The outward volume in m^dim/s through a point of a face times its
    /// weight.
    template <int dim>
    double
    flux_at(const typename BoundaryNodes<dim>::Face &face,
            const unsigned int                       q,
            const BoundaryConditions<dim>           &conditions,
            const NodeSpace<dim>                    &space,
            const Vector                            &velocity)
    {
      const auto            &condition = conditions.at(face.id);
      const auto            &xi        = face.reference_points[q];
      const auto            &normal    = face.normals_times_weight[q];
      dealii::Tensor<1, dim> v;
      if (condition.kind == BoundaryKind::velocity)
        {
          dealii::Vector<double> value(dim);
          condition.function->vector_value(
            Q1::position<dim>(space.mesh().graph().cell(face.cell).vertices,
                              xi),
            value);
          for (unsigned int d = 0; d < dim; ++d)
            v[d] = value[d];
        }
      else
        {
          const auto shape = Q1::values<dim>(xi);
          for (unsigned int i = 0; i < shape.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              v[d] += shape[i] * velocity.local_element(
                                   dim * space.nodes(face.cell)[i] + d);
        }
      return v * normal;
    }

    /// Scales the fluxes through open boundaries.
    template <int dim>
    void
    balance(const NodeSpace<dim>     &space,
            const BoundaryNodes<dim> &boundary,
            const Inflow<dim>        &inflow,
            std::vector<FaceFlux>    &fluxes)
    {
      // What the faces can be scaled by without turning any of them around.
      constexpr double    most  = .5;
      const auto         &faces = boundary.passable_faces();
      std::vector<double> areas(faces.size());
      std::vector<double> sums(3); // net outflow, passage and area if open
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          const double in = fluxes[i].in[0] + fluxes[i].in[1];
          sums[0] += fluxes[i].out - in;
          if (boundary.conditions().at(faces[i].id).kind != BoundaryKind::open)
            continue;
          areas[i] = faces[i].area().norm();
          sums[1] += fluxes[i].out + in;
          sums[2] += areas[i];
        }
      dealii::Utilities::MPI::sum(
        sums, space.mesh().triangulation().get_communicator(), sums);
      if (sums[2] == 0)
        return;
      const double scale =
        sums[1] > 0 ? std::clamp(-sums[0] / sums[1], -most, most) : 0.;
      const double rest = -sums[0] - scale * sums[1];
      for (unsigned int i = 0; i < faces.size(); ++i)
        if (areas[i] > 0)
          {
            fluxes[i].out *= 1. + scale;
            for (double &volume : fluxes[i].in)
              volume *= 1. - scale;
            const double volume = rest * areas[i] / sums[2];
            if (volume > 0)
              fluxes[i].out += volume;
            else
              fluxes[i]
                .in[inflow.value(faces[i], faces[i].reference_points[0]) < 0
                      ? 0
                      : 1] -= volume;
          }
    }
  } // namespace


  template <int dim>
  double
  Inflow<dim>::value(const typename BoundaryNodes<dim>::Face &face,
                     const dealii::Point<dim>                &xi) const
  {
    return level_sets.at(face.id)(
      Q1::position<dim>(graph.cell(face.cell).vertices, xi));
  }


  template <int dim>
  std::vector<FaceFlux>
  find_fluxes(const NodeSpace<dim>     &space,
              const BoundaryNodes<dim> &boundary,
              const Inflow<dim>        &inflow,
              const Vector             &velocity,
              const double              dt)
  {
    const auto           &faces = boundary.passable_faces();
    std::vector<FaceFlux> fluxes(faces.size());
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int q = 0; q < faces[i].reference_points.size(); ++q)
        {
          const double volume =
            dt *
            flux_at<dim>(faces[i], q, boundary.conditions(), space, velocity);
          if (volume > 0)
            fluxes[i].out += volume;
          else if (volume < 0)
            fluxes[i]
              .in[inflow.value(faces[i], faces[i].reference_points[q]) < 0
                    ? 0
                    : 1] -= volume;
        }
    balance(space, boundary, inflow, fluxes);
    return fluxes;
  }


#define INSTANTIATE(dim)                                                 \
  template class Inflow<dim>;                                            \
  template std::vector<FaceFlux> find_fluxes(const NodeSpace<dim> &,     \
                                             const BoundaryNodes<dim> &, \
                                             const Inflow<dim> &,        \
                                             const Vector &,             \
                                             const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
