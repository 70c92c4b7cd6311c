// SPDX-License-Identifier: LGPL-2.1-or-later
/**
 * @file
 * Measures how many particle-substeps a second the streamline convection
 * does on each process, everything included: reading the particles, walking,
 * and storing them by cell. Two rates are reported: by the clock on the wall,
 * with all processes at once, and by the processor's time, which other programs
 * on the machine disturb little.
 *
 * The fields are those of StreamlineConvection ("steady") and those of
 * PathConvection with degree 1 or 2 ("path 1", "path 2"), which change during
 * the step and have an acceleration.
 *
 * Usage: `contrib/benchmarks/convection [cells a direction in 2D] [in 3D]`
 */
#include <thalweg/core/mpi_session.h>
#include <thalweg/particles/path_convection.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/particles/streamline_convection.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace
{
  /// By the degree of the fields, 0 for the steady one.
  constexpr const char *field_names[] = {"steady", "path 1", "path 2"};

  /// A divergence-free cellular flow, tangential to the walls of the box.
  template <int dim>
  void
  cellular_flow(const dealii::Point<dim> &p, double *u)
  {
    constexpr double pi = dealii::numbers::PI;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = 0;
    u[0] += std::sin(pi * p[0]) * std::cos(pi * p[1]);
    u[1] -= std::cos(pi * p[0]) * std::sin(pi * p[1]);
    if (dim == 3)
      {
        u[1] += std::sin(pi * p[1]) * std::cos(pi * p[dim - 1]);
        u[dim - 1] -= std::cos(pi * p[1]) * std::sin(pi * p[dim - 1]);
      }
  }

  template <int dim>
  Thalweg::CellVelocity<dim>
  steady_flow(const Thalweg::Mesh<dim> &mesh)
  {
    Thalweg::CellVelocity<dim> velocity(mesh.graph().n_cells());
    for (unsigned int i = 0; i < velocity.size(); ++i)
      for (unsigned int v = 0; v < (1 << dim); ++v)
        cellular_flow<dim>(mesh.graph().cell(i).vertices[v],
                           velocity[i].data() + dim * v);
    return velocity;
  }

  /// The same flow, for acceleration too; only for axis-parallel cells.
  template <int dim>
  Thalweg::PathFields<dim>
  path_flow(const Thalweg::Mesh<dim> &mesh, const unsigned int degree)
  {
    Thalweg::PathFields<dim> fields;
    fields.degree = degree;
    fields.resize(mesh.graph().n_cells());
    double *u = fields.begin_velocity.data();
    for (unsigned int i = 0; i < mesh.graph().n_cells(); ++i)
      for (unsigned int j = 0; j < fields.n_nodes_per_cell(); ++j, u += dim)
        {
          dealii::Point<dim> p     = mesh.graph().cell(i).vertices[0];
          unsigned int       index = j;
          for (unsigned int d = 0; d < dim; ++d, index /= degree + 1)
            p[d] +=
              mesh.graph().cell(i).extent[d] * (index % (degree + 1)) / degree;
          cellular_flow<dim>(p, u);
        }
    fields.end_velocity       = fields.begin_velocity;
    fields.begin_acceleration = fields.begin_velocity;
    fields.end_acceleration   = fields.begin_velocity;
    return fields;
  }

  template <int dim>
  void
  refine_locally(Thalweg::Mesh<dim> &mesh)
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() &&
          std::abs(cell->center().norm() - 0.7) < 0.15)
        cell->set_refine_flag();
    mesh.triangulation().execute_coarsening_and_refinement();
    mesh.update();
  }

  template <int dim>
  void
  run(const unsigned int n_cells,
      const unsigned int degree,
      const bool         is_adapted,
      const std::string &integrator,
      const double       courant)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_cube(mesh.triangulation(), n_cells);
    mesh.update();
    if (is_adapted)
      refine_locally(mesh);

    Thalweg::Population<dim> population(mesh);
    Thalweg::seed(population,
                  Thalweg::SeedingParameters(),
                  dealii::Functions::ZeroFunction<dim>(dim),
                  dealii::Functions::ConstantFunction<dim>(1.));
    Thalweg::ConvectionParameters parameters;
    parameters.integrator = integrator;
    const Thalweg::StreamlineConvection<dim> convection(mesh, parameters, {});
    const Thalweg::PathConvection<dim>       paths(mesh, parameters, {});
    Thalweg::CellVelocity<dim>               velocity;
    Thalweg::PathFields<dim>                 fields;
    if (degree == 0)
      velocity = steady_flow<dim>(mesh);
    else
      fields = path_flow<dim>(mesh, degree);

    const unsigned int n_steps    = courant < 5 ? 10 : 4;
    const double       dt         = courant / n_cells;
    std::uint64_t      n_substeps = 0, n_crossed = 0, n_moved = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    const std::clock_t begin      = std::clock();
    const auto         wall_begin = std::chrono::steady_clock::now();
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const auto report =
          (degree == 0 ? convection.move(population, velocity, dt)
                       : paths.move(population, fields, dt))
            .sum(MPI_COMM_WORLD);
        n_substeps += report.n_substeps;
        n_crossed += report.n_cells_crossed;
        n_moved += report.n_moved;
      }
    const double processor_seconds =
      dealii::Utilities::MPI::sum(static_cast<double>(std::clock() - begin) /
                                    CLOCKS_PER_SEC,
                                  MPI_COMM_WORLD);
    const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - wall_begin;
    const double wall_seconds =
      dealii::Utilities::MPI::sum(wall.count(), MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::printf(
        "%dD  %-7s %-8s %-4s %8.1f %10.0f %9.2f %9.2f %8.2f %8.2f %8.1f\n",
        dim,
        field_names[degree],
        is_adapted ? "adapted" : "uniform",
        integrator.c_str(),
        courant,
        static_cast<double>(n_moved) / n_steps,
        static_cast<double>(n_substeps) / n_moved,
        static_cast<double>(n_crossed) / n_moved,
        1e-6 * n_substeps / wall_seconds,
        1e-6 * n_substeps / processor_seconds,
        1e9 * wall_seconds / n_moved);
  }
} // namespace


int
main(int argc, char **argv)
{
  const Thalweg::MpiSession mpi;
  const unsigned int        n_2d = argc > 1 ? std::atoi(argv[1]) : 128;
  const unsigned int        n_3d = argc > 2 ? std::atoi(argv[2]) : 24;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::printf("                                                       per "
                "particle  1e6 substeps/s  ns of wall\n"
                "    field   mesh     rk    Courant  particles  substeps   "
                "crossed     wall      CPU  a particle\n");
  for (const double courant : {0.5, 2., 10.})
    for (const std::string integrator : {"rk2", "rk4"})
      for (const bool is_adapted : {false, true})
        for (const unsigned int degree : {0, 1, 2})
          {
            run<2>(n_2d, degree, is_adapted, integrator, courant);
            run<3>(n_3d, degree, is_adapted, integrator, courant);
          }
}
