// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/function_signed_distance.h>

#include <gtest/gtest.h>

#include "setup.h"

using namespace ParticleTest;
using Thalweg::WallKind;

namespace
{
  template <int dim>
  Point<dim>
  middle()
  {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = 0.5;
    return p;
  }

  /// The greatest error of the particles within 0.4 of the centre after a
  /// turn by one radian.
  template <int dim>
  double
  rotation_error(const Thalweg::Mesh<dim> &mesh,
                 const std::string        &integrator,
                 const double              substep)
  {
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2);
    const auto before = all_positions(population);

    Thalweg::ConvectionParameters parameters;
    parameters.integrator             = integrator;
    parameters.substep_courant_number = substep;
    const Thalweg::StreamlineConvection<dim> convection(mesh, parameters, {});
    const auto velocity = nodal<dim>(mesh, rotation<dim>(middle<dim>()));
    const auto report =
      convection.move(population, velocity, 1.).sum(MPI_COMM_WORLD);
    EXPECT_EQ(report.n_lost, 0u);
    EXPECT_LE(inconsistency(population), 1e-12);

    double worst = 0;
    for (const auto &[id, after] : all_positions(population))
      if (const auto &p = before.at(id); p.distance(middle<dim>()) < 0.4)
        worst = std::max(worst, after.distance(rotated(p, middle<dim>(), 1.)));
    return worst;
  }

  template <int dim>
  void
  check_order_of_schemes(const Thalweg::Mesh<dim> &mesh)
  {
    const double rk2_coarse = rotation_error(mesh, "rk2", 0.5);
    const double rk2_fine   = rotation_error(mesh, "rk2", 0.125);
    EXPECT_GE(std::log(rk2_coarse / rk2_fine) / std::log(4.), 1.9);
    const double rk4_coarse = rotation_error(mesh, "rk4", 0.5);
    const double rk4_fine   = rotation_error(mesh, "rk4", 0.125);
    EXPECT_GE(std::log(rk4_coarse / rk4_fine) / std::log(4.), 3.8);
    EXPECT_LE(rk4_fine, 1e-6);
  }

  template <int dim>
  void
  rotate_on_refined_mesh()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    Point<dim> corner = middle<dim>();
    corner[0]         = 0.2;
    refine_around(mesh, corner, 0.35);
    refine_around(mesh, corner, 0.2);
    EXPECT_TRUE(mesh.graph().all_axis_parallel());
    check_order_of_schemes(mesh);
  }

  template <int dim>
  void
  rotate_on_distorted_mesh()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    Point<dim> corner = middle<dim>();
    corner[0]         = 0.2;
    refine_around(mesh, corner, 0.35);
    distort(mesh, 0.06);
    EXPECT_FALSE(mesh.graph().all_axis_parallel());
    check_order_of_schemes(mesh);
  }

  /// Constant velocity, periodic in x, ten times through the domain.
  template <int dim>
  void
  move_uniformly(const bool refined)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 5);
    make_periodic(mesh);
    if (refined)
      refine_around(mesh, middle<dim>(), 0.3);

    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 3, 0.7);
    const auto                               before = all_positions(population);
    const Thalweg::StreamlineConvection<dim> convection(mesh, {}, {});

    Tensor<1, dim> v;
    v[0]                = -2.;
    const auto velocity = nodal<dim>(mesh, [&](const auto &) { return v; });
    const auto report =
      convection.move(population, velocity, 5.).sum(MPI_COMM_WORLD);

    EXPECT_EQ(report.n_lost + report.n_left(), 0u);
    const auto after = all_positions(population);
    ASSERT_EQ(after.size(), before.size());
    for (const auto &[id, p] : after)
      EXPECT_LE(p.distance(before.at(id)), 1e-9);
    EXPECT_LE(inconsistency(population), 1e-12);
  }
} // namespace


TEST(StreamlineConvectionMpi, RotationOnHangingNodesHasTheOrderOfTheScheme)
{
  rotate_on_refined_mesh<2>();
  rotate_on_refined_mesh<3>();
}


TEST(StreamlineConvectionMpi, RotationOnDistortedCellsHasTheOrderOfTheScheme)
{
  rotate_on_distorted_mesh<2>();
  rotate_on_distorted_mesh<3>();
}


TEST(StreamlineConvectionMpi, UniformFlowThroughPeriodicBoundariesReturns)
{
  move_uniformly<2>(false);
  move_uniformly<2>(true);
  move_uniformly<3>(true);
}


TEST(StreamlineConvectionMpi, UniformDiagonalFlowIsExact)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 8);
  refine_around(mesh, Point<2>(0.4, 0.4), 0.2);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 2);
  const auto before = all_positions(population);

  const Thalweg::StreamlineConvection<2> convection(
    mesh, {}, {{0, WallKind::open}, {1, WallKind::open}, {3, WallKind::open}});
  const Tensor<1, 2> v({0.4, 0.4});
  const auto         velocity = nodal<2>(mesh, [&](const auto &) { return v; });
  const auto         report =
    convection.move(population, velocity, 1.).sum(MPI_COMM_WORLD);

  const auto after = all_positions(population);
  EXPECT_EQ(report.n_lost, 0u);
  EXPECT_EQ(after.size() + report.n_left(), before.size());
  unsigned int n_inside = 0;
  for (const auto &[id, p] : before)
    if (const auto target = p + v; target[0] < 1 && target[1] < 1)
      {
        ++n_inside;
        ASSERT_EQ(after.count(id), 1u);
        EXPECT_LE(after.at(id).distance(target), 1e-9);
      }
  EXPECT_EQ(after.size(), n_inside);
}


TEST(StreamlineConvectionMpi, ParticlesLeaveThroughOpenBoundariesOnly)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 6);
  Thalweg::Population<2> population(mesh);
  Thalweg::seed(population,
                Thalweg::SeedingParameters(),
                dealii::Functions::ZeroFunction<2>(2),
                dealii::Functions::SignedDistance::Plane<2>(
                  Point<2>(0., 0.5), Tensor<1, 2>({0., 1.})));
  const Thalweg::StreamlineConvection<2> convection(mesh,
                                                    {},
                                                    {{1, WallKind::open}});
  const auto velocity = nodal<2>(mesh, [](const auto &) {
    return Tensor<1, 2>({1., 0.});
  });
  auto report = convection.move(population, velocity, 0.5).sum(MPI_COMM_WORLD);

  // 18 columns of 18 particles; half of them go, half of these are below
  EXPECT_EQ(report.n_moved, 324u);
  EXPECT_EQ(report.left.size(), 1u);
  EXPECT_EQ(report.left[1][0], 81u);
  EXPECT_EQ(report.left[1][1], 81u);
  EXPECT_EQ(population.n_global_particles(), 162u);

  // against the wall on the other side nobody leaves
  const auto back = nodal<2>(mesh, [](const auto &) {
    return Tensor<1, 2>({-1., 0.25});
  });
  report          = convection.move(population, back, 2.).sum(MPI_COMM_WORLD);
  EXPECT_EQ(report.n_left() + report.n_lost, 0u);
  for (const auto &[id, p] : all_positions(population))
    EXPECT_NEAR(p[0], 0., 1e-12);
  EXPECT_EQ(population.n_global_particles(), 162u);
}


TEST(StreamlineConvectionMpi, ParticlesSlideAroundAnObstacle)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  // a box of 6 x 6 cells without the four in its middle
  dealii::Triangulation<2> box;
  dealii::GridGenerator::subdivided_hyper_cube(box, 6);
  std::set<dealii::Triangulation<2>::active_cell_iterator> obstacle;
  for (const auto &cell : box.active_cell_iterators())
    if (cell->center().distance(middle<2>()) < 0.2)
      obstacle.insert(cell);
  dealii::GridGenerator::create_triangulation_with_removed_cells(
    box, obstacle, mesh.triangulation());
  mesh.update();
  refine_around(mesh, middle<2>(), 0.4);

  for (const double courant : {0.5, 2., 5., 20.})
    {
      Thalweg::Population<2> population(mesh);
      seed_plain(population, 3);
      const auto n_before = population.n_global_particles();
      const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
      const auto velocity = nodal<2>(mesh, [](const Point<2> &p) {
        return Tensor<1, 2>({1. + std::sin(9. * p[1]), std::cos(7. * p[0])});
      });
      for (unsigned int step = 0; step < 5; ++step)
        {
          const auto report =
            convection.move(population, velocity, courant / 24.)
              .sum(MPI_COMM_WORLD);
          EXPECT_EQ(report.n_lost + report.n_left(), 0u);
        }
      EXPECT_EQ(population.n_global_particles(), n_before);
      EXPECT_LE(inconsistency(population), 1e-12);
      for (const auto &[id, p] : all_positions(population))
        EXPECT_GE(std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)),
                  1. / 6. - 1e-12);
    }
}


TEST(StreamlineConvectionMpi, UndefinedVelocityIsCountedAsLost)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 2);
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  const auto velocity = nodal<2>(mesh, [](const Point<2> &p) {
    return Tensor<1, 2>(
      {p.norm() < 0.1 ? std::numeric_limits<double>::quiet_NaN() : 0., 0.});
  });
  const auto report =
    convection.move(population, velocity, 0.1).sum(MPI_COMM_WORLD);
  EXPECT_EQ(report.n_lost, 4u);
  EXPECT_EQ(report.first_lost.id, 0u);
  EXPECT_EQ(report.first_lost.place, (std::array<double, 3>{{.125, .125, 0.}}));
  EXPECT_EQ(population.n_global_particles(), 60u);
}


TEST(StreamlineConvectionMpi, OneThrownOutOfTheDomainIsCountedAsLost)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 2);
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  for (auto &particle : population.particles())
    if (particle.id() == 37)
      particle.place() = {{nowhere, nowhere}, {nowhere, nowhere}};
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  const auto velocity = nodal<2>(mesh, [](const Point<2> &) {
    return Tensor<1, 2>({1., 0.});
  });
  const auto report =
    convection.move(population, velocity, 0.1).sum(MPI_COMM_WORLD);
  EXPECT_EQ(report.n_lost, 1u);
  EXPECT_EQ(report.first_lost.id, 37u);
  EXPECT_EQ(population.n_global_particles(), 63u);
  EXPECT_EQ(
    convection.move(population, velocity, 0.1).sum(MPI_COMM_WORLD).n_lost, 0u);
}


TEST(StreamlineConvectionMpi, PositionsDoNotDependOnTheNumberOfRanks)
{
  // The same on one rank alone, in its own communicator, for comparison.
  std::map<unsigned int, Point<2>> result[2];
  const MPI_Comm communicators[2] = {MPI_COMM_WORLD, MPI_COMM_SELF};
  for (unsigned int i = 0; i < 2; ++i)
    {
      Thalweg::Mesh<2> mesh(communicators[i]);
      make_box(mesh, 6);
      make_periodic(mesh);
      refine_around(mesh, Point<2>(0.3, 0.6), 0.3);
      distort(mesh, 0.05);
      Thalweg::Population<2> population(mesh);
      seed_plain(population, 3, 0.5);
      const Thalweg::StreamlineConvection<2> convection(mesh,
                                                        {},
                                                        {{3, WallKind::open}});
      const auto velocity = nodal<2>(mesh, [](const Point<2> &p) {
        return Tensor<1, 2>(
          {1.5 + std::sin(6. * p[1]), p[1] * std::sin(5. * p[0])});
      });
      for (unsigned int step = 0; step < 3; ++step)
        convection.move(population, velocity, 0.5);
      result[i] = i == 0 ? all_positions(population) : positions(population);
    }
  ASSERT_EQ(result[0].size(), result[1].size());
  for (const auto &[id, p] : result[0])
    {
      ASSERT_EQ(result[1].count(id), 1u);
      EXPECT_LE(p.distance(result[1].at(id)), 1e-12);
    }
}


TEST(StreamlineConvectionMpi, TraceBackInvertsTheMove)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 6);
  refine_around(mesh, Point<2>(0.5, 0.6), 0.3);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 2, 0.5);
  const auto before = all_positions(population);

  Thalweg::ConvectionParameters parameters;
  parameters.integrator             = "rk4";
  parameters.substep_courant_number = 0.1;
  const Thalweg::StreamlineConvection<2> convection(
    mesh, parameters, {{0, WallKind::open}, {1, WallKind::open}});
  const auto velocity = nodal<2>(mesh, [](const Point<2> &p) {
    return Tensor<1, 2>({1., 0.5 * p[1] * (1. - p[1])});
  });
  const auto level_set =
    nodal_scalar<2>(mesh, [](const auto &p) { return p[0] - 0.25 * p[1]; });
  convection.move(population, velocity, 0.4);

  std::vector<unsigned int> cells, ids;
  std::vector<Point<2>>     points;
  for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
    for (const auto &particle : population.in_cell(c))
      {
        cells.push_back(c);
        points.push_back(particle.reference());
        ids.push_back(particle.id());
      }
  // and one that came in through the boundary in this time
  const bool has_corner = mesh.graph().n_owned_cells() > 0 &&
                          mesh.graph().cell(0).vertices[0].norm() < 1e-12;
  if (has_corner)
    {
      cells.push_back(0);
      points.push_back(middle<2>());
    }
  const auto feet =
    convection.trace_back(cells, points, velocity, level_set, 0.4);
  ASSERT_EQ(feet.size(), cells.size());
  // up to the jumps of this field at hanging nodes
  for (unsigned int i = 0; i < ids.size(); ++i)
    {
      EXPECT_TRUE(feet[i].found);
      EXPECT_EQ(feet[i].boundary, dealii::numbers::invalid_boundary_id);
      const auto &p = before.at(ids[i]);
      EXPECT_LE(feet[i].position.distance(p), 2e-4);
      EXPECT_NEAR(feet[i].velocity[0], 1., 1e-10);
      EXPECT_NEAR(feet[i].level_set, p[0] - 0.25 * p[1], 2e-4);
    }
  if (has_corner)
    {
      EXPECT_EQ(feet.back().boundary, 0u);
      EXPECT_NEAR(feet.back().position[0], 0., 1e-12);
    }
}
