// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/flux_balance.h>
#include <thalweg/mesh/boundary_name.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// What rounding and curved sides leave of a balance, as a part of all
    /// that moves at the boundary.
    constexpr double relative_tolerance = 1e-6;

    /// The degree of the polynomials that curved sides are.
    constexpr unsigned int mapping_degree = 4;



    /// What flows out of a part of the boundary.
    struct Flux
    {
      double out   = 0.; ///< m^dim/s; less than zero where it comes in
      double speed = 0.; ///< int |u|
      double error = 0.; ///< of the quadrature
    };



    template <int dim>
    Flux
    integrate(const dealii::FEFaceValues<dim> &values,
              const dealii::Function<dim>     &velocity)
    {
      Flux                   flux;
      dealii::Vector<double> u(dim);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          velocity.vector_value(values.quadrature_point(q), u);
          for (unsigned int d = 0; d < dim; ++d)
            flux.out += u[d] * values.normal_vector(q)[d] * values.JxW(q);
          flux.speed += u.l2_norm() * values.JxW(q);
        }
      return flux;
    }



    /// The fluxes through all boundaries with given velocities. Collective.
    template <int dim>
    std::map<dealii::types::boundary_id, Flux>
    fluxes(const BoundaryConditions<dim> &conditions,
           const Mesh<dim>               &mesh,
           const double                   time)
    {
      const dealii::MappingQ<dim>   mapping(mapping_degree);
      const dealii::FE_Nothing<dim> nothing;
      const auto                    flags = dealii::update_quadrature_points |
                         dealii::update_normal_vectors |
                         dealii::update_JxW_values;
      dealii::FEFaceValues<dim>                  coarse(mapping,
                                       nothing,
                                       dealii::QGaussLobatto<dim - 1>(4),
                                       flags);
      dealii::FEFaceValues<dim>                  fine(mapping,
                                     nothing,
                                     dealii::QGauss<dim - 1>(3),
                                     flags);
      const CellGraph<dim>                      &graph = mesh.graph();
      std::map<dealii::types::boundary_id, Flux> result;
      for (const auto &[id, condition] : conditions.all())
        if (condition.kind == BoundaryKind::velocity)
          {
            Flux        &sum    = result[id];
            const double before = condition.function->get_time();
            condition.function->set_time(time);
            for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
              for (unsigned int f = 0; f < graph.n_faces; ++f)
                if (graph.at_boundary(c, f) &&
                    graph.iterator(c)->face(f)->boundary_id() == id)
                  {
                    coarse.reinit(graph.iterator(c), f);
                    fine.reinit(graph.iterator(c), f);
                    const Flux rough = integrate(coarse, *condition.function);
                    const Flux exact = integrate(fine, *condition.function);
                    sum.out += exact.out;
                    sum.speed += exact.speed;
                    sum.error += std::abs(exact.out - rough.out);
                  }
            condition.function->set_time(before);
            for (double *value : {&sum.out, &sum.speed, &sum.error})
              *value = dealii::Utilities::MPI::sum(
                *value, mesh.triangulation().get_communicator());
          }
      return result;
    }



    template <int dim>
    [[noreturn]] void
    refuse(const Mesh<dim>                                  &mesh,
           const std::map<dealii::types::boundary_id, Flux> &fluxes,
           const double                                      time)
    {
      const std::string  unit = dim == 2 ? " m^2/s" : " m^3/s";
      double             in = 0., out = 0.;
      std::ostringstream list, message;
      list.precision(10);
      message.precision(10);
      for (const auto &[id, flux] : fluxes)
        {
          in += std::max(0., -flux.out);
          out += std::max(0., flux.out);
          list << (list.str().empty() ? "" : ", ") << std::abs(flux.out)
               << (flux.out < 0. ? " in" : " out") << " through '"
               << boundary_name(mesh.boundary_names(), id) << "'";
        }
      message << "At t = " << time << " s the given velocities let " << in
              << unit << " in and " << out << unit << " out (" << list.str()
              << "), but no boundary is open, and fluids are incompressible. "
                 "Name a boundary in 'Boundary conditions/Open', or make the "
                 "velocities balance.";
      throw dealii::ExcMessage(message.str());
    }
  } // namespace



  template <int dim>
  void
  check_flux_balance(const BoundaryConditions<dim> &conditions,
                     const Mesh<dim>               &mesh,
                     const double                   time)
  {
    if (conditions.has_open_boundary())
      return;
    const auto through = fluxes(conditions, mesh, time);
    Flux       sum;
    for (const auto &[id, flux] : through)
      {
        sum.out += flux.out;
        sum.speed += flux.speed;
        sum.error += flux.error;
      }
    // Both rules are exact for polynomials of degree five. Where a velocity
    // jumps within a face, the error is at most 1.4 times their difference.
    if (std::abs(sum.out) > relative_tolerance * sum.speed + 2. * sum.error)
      refuse(mesh, through, time);
  }



  template void
  check_flux_balance(const BoundaryConditions<2> &,
                     const Mesh<2> &,
                     const double);
  template void
  check_flux_balance(const BoundaryConditions<3> &,
                     const Mesh<3> &,
                     const double);
} // namespace Thalweg
