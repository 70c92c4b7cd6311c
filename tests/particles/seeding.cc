// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <set>

#include "setup.h"

using namespace ParticleTest;


TEST(SeedingMpi, JitteredParticlesAreTheSameOnAnyNumberOfRanks)
{
  std::map<unsigned int, Point<3>> result[2];
  const MPI_Comm communicators[2] = {MPI_COMM_WORLD, MPI_COMM_SELF};
  for (unsigned int i = 0; i < 2; ++i)
    {
      Thalweg::Mesh<3> mesh(communicators[i]);
      make_box(mesh, 3);
      refine_around(mesh, Point<3>(0.2, 0.7, 0.5), 0.4);
      Thalweg::Population<3> population(mesh);
      seed_plain(population, 2, 1.);
      EXPECT_EQ(population.n_global_particles(),
                8u * mesh.triangulation().n_global_active_cells());
      result[i] = i == 0 ? all_positions(population) : positions(population);
    }
  ASSERT_EQ(result[0].size(), result[1].size());
  for (const auto &[id, p] : result[0])
    {
      ASSERT_EQ(result[1].count(id), 1u);
      EXPECT_EQ(p.distance(result[1].at(id)), 0.);
    }
}


TEST(SeedingMpi, JitterStaysInTheSubCellAndDiffersFromCellToCell)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 3, 0.5);
  std::set<double> coordinates;
  for (const auto &particle : population.particles())
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double x      = 3. * particle.reference()[d];
        const double center = std::floor(x) + 0.5;
        EXPECT_LE(std::abs(x - center), 0.25);
        coordinates.insert(x - center);
      }
  EXPECT_EQ(coordinates.size(), 2u * population.n_particles());
  EXPECT_LE(inconsistency(population), 1e-14);
}


TEST(SeedingMpi, RegularParticlesTakeVelocityAndLevelSetFromFunctions)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 3);
  Thalweg::Population<2> population(mesh);
  Thalweg::seed(population,
                Thalweg::SeedingParameters(),
                dealii::Functions::ConstantFunction<2>(
                  std::vector<double>{2., -3.}),
                dealii::Functions::Monomial<2>(Tensor<1, 2>({1., 0.})));
  EXPECT_EQ(population.n_global_particles(), 81u);
  for (const auto &particle : population.particles())
    {
      const auto properties = particle.properties();
      EXPECT_EQ(properties[0], 2.);
      EXPECT_EQ(properties[1], -3.);
      EXPECT_NEAR(properties[2], particle.position()[0], 1e-15);
    }
}


TEST(SeedingMpi, ParticlesOnTheInterfaceAreInTheSecondFluid)
{
  // The middle of the cells in the middle, and round-off of both signs.
  class Level : public dealii::Function<2>
  {
  public:
    double
    value(const Point<2> &x, const unsigned int) const override
    {
      return x[0] - .5 + 1e-13 * std::sin(1e3 * x[1]);
    }
  };
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 5);
  Thalweg::Population<2> population(mesh);
  Thalweg::seed(population,
                Thalweg::SeedingParameters(),
                dealii::Functions::ZeroFunction<2>(2),
                Level());
  unsigned int n = 0;
  for (const auto &particle : population.particles())
    if (std::abs(particle.position()[0] - .5) < 1e-6)
      {
        ++n;
        EXPECT_EQ(particle.properties()[2], 0.);
      }
  EXPECT_EQ(dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD), 15u);
}


TEST(SeedingMpi, ParticlesShareTheVolumesOfTheirCells)
{
  // A film of a tenth of a cell, which no particle of the lattice stands in.
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  Thalweg::Population<2> population(mesh);
  class Film : public dealii::Function<2>
  {
  public:
    double
    value(const Point<2> &p, const unsigned int = 0) const override
    {
      return p[1] - .025;
    }
  };
  Thalweg::seed(population,
                {},
                dealii::Functions::ZeroFunction<2>(2),
                Film(),
                [](const Thalweg::CellGraph<2>::Cell &cell) {
                  return cell.vertices[0][1] < .1 ? .025 * .25 : 0.;
                });
  EXPECT_EQ(population.n_global_particles(), 9u * 16u + 4u);
  double volumes[2] = {0., 0.};
  for (const auto &particle : population.particles())
    {
      const auto         properties = particle.properties();
      const unsigned int fluid = Thalweg::Population<2>::fluid_of(properties);
      EXPECT_GT(properties[3], 0.);
      EXPECT_EQ(fluid == 0, particle.position()[1] < .025);
      volumes[fluid] += properties[3];
    }
  EXPECT_NEAR(dealii::Utilities::MPI::sum(volumes[0], MPI_COMM_WORLD),
              .025,
              1e-15);
  EXPECT_NEAR(dealii::Utilities::MPI::sum(volumes[1], MPI_COMM_WORLD),
              .975,
              1e-14);
}


TEST(SeedingMpi, NewIdsAreUniqueAndAboveThoseThatExist)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 2);
  Thalweg::Population<2> population(mesh);
  seed_plain(population, 2);
  // ranks may create different numbers of particles
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  std::vector<unsigned int> ids;
  for (unsigned int i = 0; i < 3 * rank + 1; ++i)
    ids.push_back(population.next_id());
  std::set<unsigned int> all;
  unsigned int           n = 0;
  for (const auto &of_rank :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, ids))
    {
      all.insert(of_rank.begin(), of_rank.end());
      n += of_rank.size();
    }
  EXPECT_EQ(all.size(), n);
  EXPECT_GE(*all.begin(), 16u);

  // Resumed, the same ranks go on with the same ids.
  const Thalweg::Archive archive;
  population.keep(archive);
  const auto next = population.next_id();
  population.reserve_ids_below(0);
  population.keep(Thalweg::Archive::restore(archive.bytes()));
  EXPECT_EQ(population.next_id(), next);
}
