// SPDX-License-Identifier: LGPL-2.1-or-later
// The memory in which particles lie, and what they carry besides.
#include <thalweg/particles/population_control.h>

#include <gtest/gtest.h>

#include "setup.h"
#include "support/complaint.h"
#include "support/put_particle.h"

using namespace ParticleTest;
using Thalweg::ParticleRows;
using Thalweg::Population;

namespace
{
  /// The first property of all particles, cell by cell.
  std::vector<std::vector<double>>
  contents(const Population<2> &population)
  {
    std::vector<std::vector<double>> all(
      population.mesh().graph().n_owned_cells());
    for (unsigned int c = 0; c < all.size(); ++c)
      for (const auto &particle : population.in_cell(c))
        all[c].push_back(particle.properties()[0]);
    return all;
  }


  /// What is there of particles that each have their own number for property.
  ParticleRows<2>
  numbered(const std::vector<double> &numbers, const unsigned int n_properties)
  {
    ParticleRows<2>     rows(n_properties);
    std::vector<double> row(n_properties, 0.);
    for (const double number : numbers)
      {
        row[0] = number;
        rows.append(number, {}, row.data());
      }
    return rows;
  }


  /// Four cells, two of them with particles.
  struct PopulationMemory : testing::Test
  {
    PopulationMemory()
      : mesh(MPI_COMM_SELF)
      , population(mesh)
    {
      make_box(mesh, 2);
      population.insert(numbered({1, 10, 2, 11, 3, 4}, 5), {1, 2, 1, 2, 1, 1});
    }

    Thalweg::Mesh<2> mesh;
    Population<2>    population;
  };

  using Contents = std::vector<std::vector<double>>;
} // namespace



TEST_F(PopulationMemory, NewOnesComeBehindThoseOfTheirCell)
{
  EXPECT_EQ(contents(population), (Contents{{}, {1, 2, 3, 4}, {10, 11}, {}}));
  population.insert(numbered({20, 5, 0, 12}, 5), {3, 1, 0, 2});
  EXPECT_EQ(contents(population),
            (Contents{{0}, {1, 2, 3, 4, 5}, {10, 11, 12}, {20}}));
  population.insert(numbered({}, 5), {});
  EXPECT_EQ(population.n_particles(), 10u);
  EXPECT_EQ(population.n_in_cell(1), 5u);
}



TEST_F(PopulationMemory, TheLastOfACellTakesAFreePlace)
{
  population.insert(numbered({20}, 5), {3});
  population.remove({4, 0, 2});
  EXPECT_EQ(contents(population), (Contents{{}, {4, 2}, {11}, {20}}));
  EXPECT_EQ(population.all()[3].id(), 20u);
  population.remove({});
  population.remove({0, 1, 2, 3});
  EXPECT_EQ(contents(population), Contents(4));
  population.insert(numbered({7}, 5), {3});
  EXPECT_EQ(contents(population), (Contents{{}, {}, {}, {7}}));
}



TEST_F(PopulationMemory, AllAreReplaced)
{
  population.replace(numbered({3, 1, 2}, 5), {2, 0, 2});
  EXPECT_EQ(contents(population), (Contents{{1}, {}, {3, 2}, {}}));
  population.clear();
  EXPECT_EQ(contents(population), Contents(4));
  for (unsigned int c = 0; c < 4; ++c)
    EXPECT_EQ(population.n_in_cell(c), 0u);
  EXPECT_TRUE(population.particles().empty());
}



TEST_F(PopulationMemory, PropertiesHaveNamesOfTheirOwn)
{
  population.clear();
  EXPECT_EQ(population.add_property("heat"), 5u);
  EXPECT_EQ(population.add_property("salt"), 6u);
  EXPECT_EQ(population.row_length(), 7u);
  EXPECT_NE(complaint_of([&]() {
              population.add_property("heat");
            }).find("'heat'"),
            std::string::npos);
}



TEST(PopulationMpi, AddedPropertiesGoAlong)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 8);
  make_periodic(mesh);
  Population<2>      population(mesh);
  const unsigned int offset = population.add_property("mark");
  seed_plain(population, 3);
  const auto mark = [](const Thalweg::ParticleId id) { return .5 + 3. * id; };
  for (const auto &particle : population.particles())
    {
      EXPECT_TRUE(std::isnan(particle.properties()[offset]));
      particle.properties()[offset] = mark(particle.id());
    }
  const Thalweg::StreamlineConvection<2> convection(mesh, {}, {});
  const auto velocity = nodal<2>(mesh, [](const auto &) {
    return Tensor<1, 2>({1., 0.});
  });
  // Far enough for other ranks, once around, and there and back.
  for (const double dt : {.03, .4, 1.})
    convection.move(population, velocity, dt);
  convection.move(population,
                  nodal<2>(mesh, rotation<2>({.5, .5})),
                  2. * dealii::numbers::PI);
  EXPECT_EQ(population.n_global_particles(), 9u * 64u);
  EXPECT_EQ(all_positions(population).size(), 9u * 64u);
  for (const auto &particle : population.particles())
    EXPECT_EQ(particle.properties()[offset], mark(particle.id()));
}



TEST(PopulationMpi, MergedParticlesMixWhatTheyCarry)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 2);
  Population<2>      population(mesh);
  const unsigned int offset = population.add_property("heat");
  const unsigned int volume = Population<2>::volume_offset;
  const auto         n      = mesh.graph().n_owned_cells();
  for (unsigned int c = 0; c < n; ++c)
    for (const double x : {.2, .4, .6, .8})
      for (const double y : {.2, .4, .6, .8})
        put_particle<2>(population, c, {x, y}, x + y);
  const auto integral = [&]() {
    double sum = 0.;
    for (const auto &particle : population.particles())
      sum += particle.properties()[volume] * particle.properties()[offset];
    return sum;
  };
  const double                     before = integral();
  Thalweg::PopulationParameters<2> parameters;
  parameters.maximum_per_cell = 9;
  parameters.carry_volume     = true;
  Thalweg::PopulationControl<2>(parameters, {}).limit(population);
  EXPECT_EQ(population.n_particles(), 9u * n);
  EXPECT_NEAR(integral(), before, 1e-13);
}
