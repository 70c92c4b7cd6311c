// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_tests_particles_setup_h
#define thalweg_tests_particles_setup_h

#include <thalweg/particles/population.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/particles/streamline_convection.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <functional>
#include <map>

#include "support/meshes.h"

namespace ParticleTest
{
  using dealii::Point;
  using dealii::Tensor;
  using Meshes::distort;
  using Meshes::refine_around;

  template <int dim>
  using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;

  /// The unit box of n^dim cells with boundary ids by side, at [0,1]^dim.
  template <int dim>
  void
  make_box(Thalweg::Mesh<dim> &mesh, const unsigned int n)
  {
    dealii::GridGenerator::subdivided_hyper_cube(
      mesh.triangulation(), n, 0., 1., true);
    mesh.update();
  }

  /// Joins the sides 0 and 1; before any refinement.
  template <int dim>
  void
  make_periodic(Thalweg::Mesh<dim> &mesh)
  {
    dealii::Triangulation<dim> &tria = mesh.triangulation();
    std::vector<dealii::GridTools::PeriodicFacePair<
      typename dealii::Triangulation<dim>::cell_iterator>>
      pairs;
    dealii::GridTools::collect_periodic_faces(tria, 0, 1, 0, pairs);
    tria.add_periodicity(pairs);
    mesh.update();
  }

  template <int dim>
  Thalweg::CellVelocity<dim>
  nodal(const Thalweg::Mesh<dim> &mesh, const Field<dim> &field)
  {
    Thalweg::CellVelocity<dim> values(mesh.graph().n_cells());
    for (unsigned int i = 0; i < values.size(); ++i)
      for (unsigned int v = 0; v < (1 << dim); ++v)
        {
          const auto value = field(mesh.graph().cell(i).vertices[v]);
          for (unsigned int d = 0; d < dim; ++d)
            values[i][v * dim + d] = value[d];
        }
    return values;
  }

  template <int dim>
  Thalweg::CellField<dim, 1>
  nodal_scalar(const Thalweg::Mesh<dim>                        &mesh,
               const std::function<double(const Point<dim> &)> &field)
  {
    Thalweg::CellField<dim, 1> values(mesh.graph().n_cells());
    for (unsigned int i = 0; i < values.size(); ++i)
      for (unsigned int v = 0; v < (1 << dim); ++v)
        values[i][v] = field(mesh.graph().cell(i).vertices[v]);
    return values;
  }

  /// Seeds with zero velocity and a level set that is positive everywhere.
  template <int dim>
  void
  seed_plain(Thalweg::Population<dim> &population,
             const unsigned int        per_direction,
             const double              jitter = 0)
  {
    Thalweg::SeedingParameters parameters;
    parameters.particles_per_direction = per_direction;
    parameters.jitter                  = jitter;
    Thalweg::seed(population,
                  parameters,
                  dealii::Functions::ZeroFunction<dim>(dim),
                  dealii::Functions::ConstantFunction<dim>(1.));
  }

  /// The positions of all particles of this rank by their ids.
  template <int dim>
  std::map<unsigned int, Point<dim>>
  positions(const Thalweg::Population<dim> &population)
  {
    std::map<unsigned int, Point<dim>> result;
    for (const auto &particle : population.particles())
      result[particle.id()] = particle.position();
    return result;
  }

  /// The same for the particles of all ranks.
  template <int dim>
  std::map<unsigned int, Point<dim>>
  all_positions(const Thalweg::Population<dim> &population)
  {
    std::map<unsigned int, Point<dim>> result;
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                            positions(population)))
      result.insert(of_rank.begin(), of_rank.end());
    return result;
  }

  /// The greatest distance between a particle's position and the one that
  /// its cell and reference coordinates give, and how far the reference
  /// coordinates are outside.
  template <int dim>
  double
  inconsistency(const Thalweg::Population<dim> &population)
  {
    const auto &mesh  = population.mesh();
    double      worst = 0;
    for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
      for (const auto &particle : population.in_cell(c))
        {
          const auto &reference = particle.reference();
          const auto  position =
            mesh.mapping().transform_unit_to_real_cell(mesh.graph().iterator(c),
                                                       reference);
          worst = std::max(worst, position.distance(particle.position()));
          for (unsigned int d = 0; d < dim; ++d)
            worst = std::max({worst, -reference[d], reference[d] - 1.});
        }
    return dealii::Utilities::MPI::max(worst, MPI_COMM_WORLD);
  }

  /// A rotation about the axis through the centre in direction (1,2,3), or
  /// about the centre in 2D, with one radian a second.
  template <int dim>
  Field<dim>
  rotation(const Point<dim> &center)
  {
    return [center](const Point<dim> &p) {
      const Tensor<1, dim> r = p - center;
      if constexpr (dim == 2)
        return Tensor<1, 2>({-r[1], r[0]});
      else
        {
          Tensor<1, 3> axis({1., 2., 3.});
          axis /= axis.norm();
          return dealii::cross_product_3d(axis, r);
        }
    };
  }

  template <int dim>
  Point<dim>
  rotated(const Point<dim> &p, const Point<dim> &center, const double angle)
  {
    const Tensor<1, dim> r = p - center;
    if constexpr (dim == 2)
      return center +
             Tensor<1, 2>({std::cos(angle) * r[0] - std::sin(angle) * r[1],
                           std::sin(angle) * r[0] + std::cos(angle) * r[1]});
    else
      {
        Tensor<1, 3> axis({1., 2., 3.});
        axis /= axis.norm();
        return center + std::cos(angle) * r +
               std::sin(angle) * dealii::cross_product_3d(axis, r) +
               (1. - std::cos(angle)) * (axis * r) * axis;
      }
  }
} // namespace ParticleTest

#endif
