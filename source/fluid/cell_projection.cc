// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/fluid/cell_projection.h>
#include <thalweg/fluid/pressure_system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim>
  class CellProjection<dim>::Preconditioner
  {
  public:
    explicit Preconditioner(const CellProjection<dim> &projection)
      : projection(projection)
    {
      projection.space.initialize_scalar(load);
      projection.space.initialize_scalar(smooth);
    }

    void
    vmult(Vector &y, const Vector &x) const
    {
      constexpr double share = 1. / n_vertices;
      const auto      &space = projection.space;
      load                   = 0.;
      for (unsigned int c = 0; c < x.locally_owned_size(); ++c)
        for (const unsigned int node : space.nodes(c))
          load.local_element(node) += share * x.local_element(c);
      space.fold(load, 1);
      projection.pressure.precondition(smooth, load);
      for (unsigned int c = 0; c < x.locally_owned_size(); ++c)
        {
          double sum = 0;
          for (const unsigned int node : space.nodes(c))
            sum += smooth.local_element(node);
          y.local_element(c) =
            share * sum +
            projection.inverse_diagonal.local_element(c) * x.local_element(c);
        }
    }

  private:
    const CellProjection<dim> &projection;
    mutable Vector             load, smooth;
  };



  template <int dim>
  CellProjection<dim>::CellProjection(const NodeSpace<dim>      &space,
                                      const BoundaryNodes<dim>  &boundary,
                                      const NodalMass<dim>      &mass,
                                      const PressureSystem<dim> &pressure)
    : space(space)
    , boundary(boundary)
    , mass(mass)
    , pressure(pressure)
  {
    const CellGraph<dim>  &graph = space.mesh().graph();
    const Q1Integrals<dim> integrals;
    gradients.resize(graph.n_owned_cells());
    for (unsigned int c = 0; c < gradients.size(); ++c)
      gradients[c] = integrals.gradient_integrals(graph.cell(c));
    const auto &triangulation = space.mesh().triangulation();
    outflow.reinit(triangulation.global_active_cell_index_partitioner().lock());
    multiplier.reinit(outflow);
    inverse_diagonal.reinit(outflow);
    for (Vector *vector : {&preconditioned, &direction, &image})
      vector->reinit(outflow);
    space.initialize_velocity(change);
    find_rigid_cells();
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        const auto &cell = graph.cell(c);
        domain_measure += cell.measure;
        edge_round_off =
          std::max(edge_round_off,
                   coordinate_round_off(cell.vertices[0]) / cell.edges().first);
      }
    const MPI_Comm communicator = outflow.get_mpi_communicator();
    domain_measure = dealii::Utilities::MPI::sum(domain_measure, communicator);
    edge_round_off = dealii::Utilities::MPI::max(edge_round_off, communicator);
  }



  template <int dim>
  void
  CellProjection<dim>::find_rigid_cells()
  {
    Vector free;
    space.initialize_scalar(free);
    for (unsigned int d = 0; d < dim; ++d)
      {
        change = 0.;
        for (unsigned int n = 0; n < free.locally_owned_size(); ++n)
          change.local_element(dim * n + d) = 1.;
        boundary.project(change);
        for (unsigned int n = 0; n < free.locally_owned_size(); ++n)
          for (unsigned int e = 0; e < dim; ++e)
            free.local_element(n) +=
              std::abs(change.local_element(dim * n + e));
      }
    space.interpolate(free, 1);
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        double sum = 0;
        for (const unsigned int node : space.nodes(c))
          sum += free.local_element(node);
        if (sum == 0)
          rigid_cells.push_back(c);
      }
  }



  template <int dim>
  void
  CellProjection<dim>::find_outflow(const Vector &velocity, Vector &y) const
  {
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        const auto &nodes = space.nodes(c);
        double      sum   = 0;
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            sum +=
              gradients[c][v][d] * velocity.local_element(dim * nodes[v] + d);
        y.local_element(c) = sum;
      }
  }



  template <int dim>
  void
  CellProjection<dim>::find_change(const Vector &x) const
  {
    change = 0.;
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        const auto &nodes = space.nodes(c);
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            change.local_element(dim * nodes[v] + d) +=
              gradients[c][v][d] * x.local_element(c);
      }
    space.fold(change, dim);
    mass.invert(change);
  }



  template <int dim>
  void
  CellProjection<dim>::vmult(Vector &y, const Vector &x) const
  {
    find_change(x);
    find_outflow(change, y);
  }



  template <int dim>
  void
  CellProjection<dim>::find_diagonal()
  {
    // Where a node depends on others they take its share with their masses;
    // for the diagonal it counts with the mass of its cell alone.
    Vector inverse_mass(mass.inverse_lumped());
    space.interpolate(inverse_mass, 1);
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        double sum = 0;
        for (unsigned int v = 0; v < n_vertices; ++v)
          sum += gradients[c][v].norm_square() *
                 inverse_mass.local_element(space.nodes(c)[v]);
        inverse_diagonal.local_element(c) = 1. / sum;
      }
  }



  template <int dim>
  void
  CellProjection<dim>::balance(Vector &y) const
  {
    for (const unsigned int c : rigid_cells)
      y.local_element(c) = 0.;
    if (boundary.conditions().has_open_boundary())
      return;
    const CellGraph<dim> &graph = space.mesh().graph();
    double                sum   = 0;
    for (unsigned int c = 0; c < gradients.size(); ++c)
      sum += y.local_element(c);
    sum = dealii::Utilities::MPI::sum(sum, y.get_mpi_communicator());
    for (unsigned int c = 0; c < gradients.size(); ++c)
      y.local_element(c) -= sum / domain_measure * graph.cell(c).measure;
  }



  template <int dim>
  double
  CellProjection<dim>::round_off(const Vector &velocity) const
  {
    double sum = 0;
    for (unsigned int c = 0; c < gradients.size(); ++c)
      {
        const auto &nodes = space.nodes(c);
        double      flux  = 0;
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            flux += std::abs(gradients[c][v][d] *
                             velocity.local_element(dim * nodes[v] + d));
        sum += flux * flux;
      }
    sum = dealii::Utilities::MPI::sum(sum, outflow.get_mpi_communicator());
    return (10. * std::numeric_limits<double>::epsilon() + edge_round_off) *
           std::sqrt(sum);
  }



  template <int dim>
  typename CellProjection<dim>::Iterations
  CellProjection<dim>::iterate(const double       tolerance,
                               const double       smallest_residual,
                               const unsigned int maximum)
  {
    const Preconditioner preconditioner(*this);
    Iterations           result;
    SolveReport         &report  = result.report;
    double               product = 0, energy = 0;
    multiplier           = 0.;
    report.residual      = outflow.l2_norm();
    const double initial = report.residual;
    double       least   = initial;
    result.has_converged = report.residual <= smallest_residual;
    while (!result.has_converged && report.iterations < maximum &&
           report.residual <= incompatible * initial)
      {
        preconditioner.vmult(preconditioned, outflow);
        const double old_product = product;
        product                  = outflow * preconditioned;
        direction.sadd(report.iterations == 0 ? 0. : product / old_product,
                       1.,
                       preconditioned);
        vmult(image, direction);
        const double step = product / (direction * image);
        multiplier.add(step, direction);
        outflow.add(-step, image);
        energy += step * product;
        report.residual = outflow.l2_norm();
        ++report.iterations;
        if (report.residual < least)
          {
            least       = report.residual;
            result.best = report.iterations;
          }
        result.has_converged =
          step * product <= tolerance * tolerance * energy ||
          report.residual <= smallest_residual;
      }
    return result;
  }



  template <int dim>
  SolveReport
  CellProjection<dim>::solve(const Vector      &velocity,
                             const double       tolerance,
                             const unsigned int maximum)
  {
    const double smallest_residual = round_off(velocity);
    find_outflow(velocity, outflow);
    balance(outflow);
    const Iterations all = iterate(tolerance, smallest_residual, maximum);
    if (all.has_converged)
      return all.report;
    if (all.report.iterations == maximum)
      throw StepFailure(
        "The linear solver for the divergence did not converge: after " +
        std::to_string(maximum) +
        " iterations the velocity still changes by more than 'Divergence "
        "tolerance' of its whole change.");
    find_outflow(velocity, outflow);
    balance(outflow);
    SolveReport report = iterate(0., smallest_residual, all.best).report;
    report.iterations += all.report.iterations;
    return report;
  }



  template <int dim>
  SolveReport
  CellProjection<dim>::project(Vector            &velocity,
                               const double       tolerance,
                               const unsigned int maximum)
  {
    find_diagonal();
    SolveReport report = solve(velocity, tolerance, maximum);
    if (report.iterations > 0)
      {
        find_change(multiplier);
        velocity.zero_out_ghost_values();
        velocity.add(-1., change);
        boundary.apply(velocity);
        space.interpolate(velocity, dim);
      }
    report.residual *= std::sqrt(outflow.size()) / domain_measure;
    return report;
  }



  THALWEG_INSTANTIATE(CellProjection)
} // namespace Thalweg
