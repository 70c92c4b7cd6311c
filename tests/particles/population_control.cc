// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/population_control.h>

#include <deal.II/base/function_signed_distance.h>

#include <gtest/gtest.h>
#include <set>

#include "setup.h"

using namespace ParticleTest;
using Thalweg::WallKind;

namespace
{
  template <int dim>
  void
  fill_an_empty_mesh()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    refine_around(mesh, Point<dim>(), 0.5);
    Thalweg::Population<dim> population(mesh);

    const Thalweg::StreamlineConvection<dim> convection(mesh,
                                                        {},
                                                        {{0, WallKind::open}});
    const Thalweg::PopulationControl<dim>    control(
      {}, convection, {{0, [](const auto &) { return -1.; }}});

    Tensor<1, dim> v;
    v[0]                = 1.;
    const auto velocity = nodal<dim>(mesh, [&](const auto &) { return v; });
    const auto level_set =
      nodal_scalar<dim>(mesh, [](const auto &p) { return 0.5 - p[0]; });
    const unsigned int added = dealii::Utilities::MPI::sum(
      control.fill_empty_cells(population, velocity, level_set, 0.3),
      MPI_COMM_WORLD);

    EXPECT_EQ(added,
              (1u << dim) * mesh.triangulation().n_global_active_cells());
    EXPECT_EQ(population.n_global_particles(), added);
    EXPECT_LE(inconsistency(population), 1e-12);
    for (const auto &particle : population.particles())
      {
        const auto   properties = particle.properties();
        const double x          = particle.position()[0];
        EXPECT_NEAR(properties[0], 1., 1e-12);
        EXPECT_EQ(properties[dim], x < 0.3 ? -1. : (x - 0.3 <= 0.5 ? 1. : -1.));
      }
    // all ids differ
    EXPECT_EQ(all_positions(population).size(), added);

    // nothing is missing now
    EXPECT_EQ(control.fill_empty_cells(population, velocity, level_set, 0.3),
              0u);
  }
} // namespace


TEST(PopulationControlMpi, EmptyCellsGetParticlesFromUpstream)
{
  // With a minimum above 2^dim the sub-cells are what decides.
  fill_an_empty_mesh<2>();
  fill_an_empty_mesh<3>();
}


TEST(PopulationControlMpi, OnlyEmptySubCellsAreFilled)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 2);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 1);
  // the one particle stands in the middle, which counts to the last quarter
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  const Thalweg::PopulationControl<2>    control({}, convection, {});
  const auto                             velocity =
    nodal<2>(mesh, [](const auto &) { return Tensor<1, 2>(); });
  const auto level_set = nodal_scalar<2>(mesh, [](const auto &) { return 1.; });
  control.fill_empty_cells(population, velocity, level_set, 0.1);
  EXPECT_EQ(population.n_global_particles(), 16u);
  for (const auto &particle : population.particles())
    {
      const auto &reference = particle.reference();
      EXPECT_TRUE(particle.id() < 4 || reference[0] < 0.5 ||
                  reference[1] < 0.5);
    }
}


TEST(PopulationControlMpi, CrowdedCellsKeepTheMixtureOfFluids)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 3);
  Thalweg::Population<2>     population(mesh);
  Thalweg::SeedingParameters seeding;
  seeding.particles_per_direction = 6;
  seeding.jitter                  = 0.5;
  // 36 particles a cell; in the middle column a third of them is negative
  Thalweg::seed(population,
                seeding,
                dealii::Functions::ZeroFunction<2>(2),
                dealii::Functions::SignedDistance::Plane<2>(
                  Point<2>(4. / 9., 0.), Tensor<1, 2>({1., 0.})));
  Thalweg::PopulationParameters<2> parameters;
  parameters.maximum_per_cell = 12;
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  const Thalweg::PopulationControl<2>    control(parameters, convection, {});

  const unsigned int removed =
    dealii::Utilities::MPI::sum(control.limit(population), MPI_COMM_WORLD);
  EXPECT_EQ(removed, 9u * 24u);
  EXPECT_EQ(population.n_global_particles(), 9u * 12u);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        unsigned int           n = 0, n_negative = 0;
        std::set<unsigned int> quarters;
        for (const auto &particle :
             population.in_cell(mesh.graph().index(cell)))
          {
            ++n;
            n_negative += particle.properties()[2] < 0 ? 1 : 0;
            const auto &reference = particle.reference();
            quarters.insert((reference[0] > 0.5 ? 1 : 0) +
                            (reference[1] > 0.5 ? 2 : 0));
          }
        const double x = cell->center()[0];
        EXPECT_EQ(n, 12u);
        EXPECT_EQ(n_negative, x < 0.4 ? 12u : (x < 0.6 ? 4u : 0u));
        EXPECT_EQ(quarters.size(), 4u);
      }
  EXPECT_EQ(control.limit(population), 0u);
}


TEST(PopulationControlMpi, VolumeAndMomentumOutliveTheirParticles)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2>     population(mesh);
  Thalweg::SeedingParameters seeding;
  seeding.particles_per_direction = 5;
  seeding.jitter                  = .7;
  Thalweg::seed(population,
                seeding,
                dealii::Functions::Monomial<2>(Tensor<1, 2>({1., 1.}), 2),
                dealii::Functions::SignedDistance::Plane<2>(
                  Point<2>(.4, .3), Tensor<1, 2>({.6, .8})),
                [](const auto &cell) { return .3 * cell.measure; });
  const auto sums = [&]() {
    std::array<double, 4> sums{};
    for (const auto &particle : population.particles())
      {
        const auto properties = particle.properties();
        sums[Thalweg::Population<2>::fluid_of(properties)] += properties[3];
        for (unsigned int d = 0; d < 2; ++d)
          sums[2 + d] += properties[3] * properties[d];
      }
    for (double &sum : sums)
      sum = dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    return sums;
  };
  const auto                             before = sums();
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  Thalweg::PopulationParameters<2>       parameters;
  parameters.maximum_per_cell = 7;
  parameters.carry_volume     = true;
  const Thalweg::PopulationControl<2> thin(parameters, convection, {});
  EXPECT_GT(dealii::Utilities::MPI::sum(thin.limit(population), MPI_COMM_WORLD),
            0u);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(sums()[i], before[i], 1e-14);

  parameters.maximum_per_cell = 30;
  parameters.minimum_per_cell = 20;
  const Thalweg::PopulationControl<2> fill(parameters, convection, {});
  fill.fill_empty_cells(population,
                        nodal<2>(mesh,
                                 [](const auto &) { return Tensor<1, 2>(); }),
                        nodal_scalar<2>(mesh, [](const auto &) { return 1.; }),
                        .1);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(sums()[i], before[i], 1e-14);
}


TEST(PopulationControl, BoundsThatContradictEachOtherAreRefused)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_SELF);
  make_box(mesh, 2);
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  Thalweg::PopulationParameters<2>       parameters;
  parameters.minimum_per_cell = 20;
  parameters.maximum_per_cell = 10;
  try
    {
      const Thalweg::PopulationControl<2> control(parameters, convection, {});
      FAIL() << "was accepted";
    }
  catch (const dealii::ExceptionBase &error)
    {
      EXPECT_NE(
        std::string(error.what()).find("'Particles/Maximum per cell' is 10"),
        std::string::npos);
    }
}
