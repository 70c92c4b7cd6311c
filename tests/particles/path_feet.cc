// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/population_control.h>

#include <gtest/gtest.h>

#include "particles/path_setup.h"

using namespace ParticleTest;
using Thalweg::WallKind;

namespace
{
  /// Where the particles of this rank are, for a tracer.
  template <int dim>
  struct Places
  {
    std::vector<unsigned int> cells, ids;
    std::vector<Point<dim>>   points;

    explicit Places(const Thalweg::Population<dim> &population)
    {
      const auto &graph = population.mesh().graph();
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (const auto &particle : population.in_cell(c))
          {
            cells.push_back(c);
            points.push_back(particle.reference());
            ids.push_back(particle.id());
          }
    }
  };

  template <int dim>
  void
  return_to_the_foot(const bool distorted)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    refine_around(mesh, middle_of_box<dim>(), 0.3);
    if (distorted)
      distort(mesh, 0.05);
    const Field<dim>         turn = rotation<dim>(middle_of_box<dim>());
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2, 0.5);
    set_velocity<dim>(population, turn);
    const auto before = all_states(population);

    const auto                         fields = path_fields<dim>(mesh,
                                         2,
                                         turn,
                                         times<dim>(2., turn),
                                         times<dim>(-1., turn),
                                         times<dim>(3., turn));
    const Thalweg::PathConvection<dim> convection(mesh,
                                                  substeps("rk4", 0.1),
                                                  {});
    convection.move(population, fields, 0.8);
    const auto        after = all_states(population);
    const Places<dim> places(population);
    const auto        feet =
      convection.trace_back(places.cells, places.points, fields, 0.8);
    ASSERT_EQ(feet.size(), places.cells.size());
    for (unsigned int i = 0; i < feet.size(); ++i)
      {
        const auto &old = before.at(places.ids[i]);
        if (old.position.distance(middle_of_box<dim>()) > 0.4)
          continue;
        EXPECT_TRUE(feet[i].found);
        EXPECT_EQ(feet[i].boundary, dealii::numbers::invalid_boundary_id);
        EXPECT_EQ(feet[i].level_set, -1.);
        EXPECT_LE(feet[i].position.distance(old.position), 2e-6);
        for (unsigned int d = 0; d < dim; ++d)
          EXPECT_NEAR(feet[i].velocity[d],
                      after.at(places.ids[i]).velocity[d],
                      2e-6);
      }
  }
} // namespace


TEST(PathFeetMpi, TraceBackInvertsTheMove)
{
  return_to_the_foot<2>(false);
  return_to_the_foot<2>(true);
  return_to_the_foot<3>(false);
}


TEST(PathFeetMpi, InflowTakesTheVelocityWhereAndWhenItCameIn)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 5);
  refine_around(mesh, Point<2>(0.2, 0.5), 0.2);
  // u(t) = 1 + 2 t for one second; a depends on place and time
  const Field<2> slow = constant<2>(Tensor<1, 2>({1., 0.}));
  const Field<2> fast = constant<2>(Tensor<1, 2>({3., 0.}));
  const Field<2> a0   = [](const Point<2> &p) {
    return Tensor<1, 2>({0., p[0]});
  };
  const Field<2> a1 = [](const Point<2> &p) {
    return Tensor<1, 2>({2., p[0] + 1.});
  };
  const auto fields = path_fields<2>(mesh, 1, slow, fast, a0, a1);
  const Thalweg::PathConvection<2> convection(mesh,
                                              substeps("rk4", 0.5),
                                              {{0, WallKind::open}});
  Thalweg::Population<2>           population(mesh);
  seed_plain(population, 2);
  const Places<2> places(population);
  const auto      feet =
    convection.trace_back(places.cells, places.points, fields, 1.);
  const auto positions_now = positions(population);
  for (unsigned int i = 0; i < feet.size(); ++i)
    {
      const double x = positions_now.at(places.ids[i])[0];
      // x = (t + t^2) from t to 1
      const double t = -0.5 + std::sqrt(0.25 + 2. - x);
      EXPECT_TRUE(feet[i].found);
      EXPECT_EQ(feet[i].boundary, 0u);
      // the way is cut straight at the boundary
      EXPECT_NEAR(feet[i].position[0], 0., 1e-12);
      EXPECT_NEAR(feet[i].velocity[0], 1. + 2. * t + 1. - t * t, 2e-3);
      // int (x(s) + s) ds with x(s) = s + s^2 - t - t^2
      const double gain =
        1. - t * t + (1. - t * t * t) / 3. - (t + t * t) * (1. - t);
      EXPECT_NEAR(feet[i].velocity[1], gain, 2e-3);
    }
}


TEST(PathFeetMpi, PopulationControlTakesAnyTracer)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2> population(mesh);
  const Field<2>         one    = constant<2>(Tensor<1, 2>({1., 0.}));
  const Field<2>         two    = constant<2>(Tensor<1, 2>({2., 0.}));
  const auto             fields = path_fields<2>(mesh, 2, one, one, two, two);
  const Thalweg::PathConvection<2>    convection(mesh, {}, {});
  const Thalweg::PopulationControl<2> control({}, {});
  const auto tracer = [&](const std::vector<unsigned int> &cells,
                          const std::vector<Point<2>>     &points) {
    return convection.trace_back(cells, points, fields, 0.1);
  };
  control.fill_empty_cells(population, tracer);
  EXPECT_EQ(population.n_global_particles(), 64u);
  for (const auto &particle : population.particles())
    {
      EXPECT_NEAR(particle.properties()[0], 1.2, 1e-12);
      EXPECT_EQ(particle.properties()[2], -1.);
    }
}


TEST(PathFeetMpi, NothingDependsOnTheNumberOfRanks)
{
  // The same on one rank alone, in its own communicator, for comparison.
  States<2>      result[2];
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
      const Thalweg::PathConvection<2> convection(mesh,
                                                  {},
                                                  {{3, WallKind::open}});
      const Field<2>                   wave = [](const Point<2> &p) {
        return Tensor<1, 2>(
          {1.5 + std::sin(6. * p[1]), p[1] * std::sin(5. * p[0])});
      };
      const auto fields = path_fields<2>(mesh,
                                         2,
                                         wave,
                                         times<2>(1.5, wave),
                                         times<2>(-1., wave),
                                         times<2>(2., wave));
      for (unsigned int step = 0; step < 3; ++step)
        convection.move(population, fields, 0.5);
      result[i] = i == 0 ? all_states(population) : states(population);
    }
  ASSERT_EQ(result[0].size(), result[1].size());
  for (const auto &[id, state] : result[0])
    {
      ASSERT_EQ(result[1].count(id), 1u);
      EXPECT_LE(state.position.distance(result[1].at(id).position), 1e-12);
      EXPECT_LE((state.velocity - result[1].at(id).velocity).norm(), 1e-11);
    }
}
