// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/boundary_exchange.h>
#include <thalweg/particles/seeding.h>

#include <deal.II/base/function_lib.h>

#include "support/dimensions.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class BoundaryExchangeMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(BoundaryExchangeMpi, Dimensions);

  /// A box that fluid passes from the left to the right with 0.3 m/s, full
  /// of the second fluid, into which the first one comes.
  template <int dim>
  struct Channel
  {
    /// @param along velocity from the left to the right, given on the left
    /// @param across velocity of the field along both sides, not given there
    explicit Channel(const double along = .3, const double across = 0.)
      : scene(unit_box<dim>(6) +
              section("Boundary conditions",
                      {"Velocity = left: " + std::to_string(along) + "; 0" +
                         std::string(dim == 3 ? "; 0" : ""),
                       "Open = right: 0"}))
      , convection(scene.mesh,
                   {},
                   {{scene.mesh.boundary_id("left"), WallKind::open},
                    {scene.mesh.boundary_id("right"), WallKind::open}})
      , exchange(
          *scene.space,
          *scene.boundary,
          {{scene.mesh.boundary_id("left"), [](const auto &) { return -1.; }},
           {scene.mesh.boundary_id("right"), [](const auto &) { return 1.; }}},
          convection,
          3)
      , velocity(scene.velocity([along, across](const auto &) {
        dealii::Tensor<1, dim> u;
        u[0]       = along;
        u[dim - 1] = across;
        return u;
      }))
    {
      seed(*scene.population,
           {},
           dealii::Functions::ZeroFunction<dim>(dim),
           dealii::Functions::ConstantFunction<dim>(1.),
           [](const auto &) { return 0.; });
      exchange.open_books(*scene.population);
      scene.space->copy_to_cells(velocity, cell_velocity);
    }

    void
    step(const double dt)
    {
      const auto report = convection.move(*scene.population, cell_velocity, dt);
      exchange.pass(*scene.population, report, velocity, cell_velocity, dt);
    }

    FluidVolumes
    inside() const
    {
      auto volumes = scene.population->volumes_of_cells();
      exchange.add_waiting(volumes);
      return sum_over_ranks(volumes, MPI_COMM_WORLD);
    }

    Scene<dim>                scene;
    StreamlineConvection<dim> convection;
    BoundaryExchange<dim>     exchange;
    Vector                    velocity;
    CellVelocity<dim>         cell_velocity;
  };
} // namespace



TYPED_TEST(BoundaryExchangeMpi, WhatIsInsideFollowsTheFluxAtAnyStepSize)
{
  constexpr int dim = TypeParam::value;
  for (const double courant : {.03, .5, 1.7, 5.})
    {
      Channel<dim> channel;
      const double dt   = courant / 6 / .3;
      double       time = 0;
      for (unsigned int i = 0; i < 12 && time + dt < 3.; ++i, time += dt)
        {
          channel.step(dt);
          const auto inside = channel.inside();
          const auto books  = channel.exchange.books();
          EXPECT_NEAR(inside[0], .3 * (time + dt), 1e-12);
          EXPECT_NEAR(inside[0] + inside[1] - books.owed[0] - books.owed[1],
                      1.,
                      1e-12);
          for (unsigned int f = 0; f < 2; ++f)
            EXPECT_NEAR(books.inside()[f], inside[f], 1e-12);
        }
    }
}



TYPED_TEST(BoundaryExchangeMpi, AFullChannelLetsOutWhatComesIn)
{
  constexpr int dim = TypeParam::value;
  Channel<dim>  channel;
  const double  dt = .7 / 6 / .3;
  // twice through the channel
  for (unsigned int i = 0; i < 2 * 6 / .7; ++i)
    channel.step(dt);
  EXPECT_NEAR(channel.inside()[0], 1., 1e-9);
  EXPECT_NEAR(channel.inside()[1], 0., 1e-9);
}



TYPED_TEST(BoundaryExchangeMpi, WhatWaitsComesIntoTheNextRun)
{
  constexpr int dim = TypeParam::value;
  Channel<dim>  channel;
  channel.step(.01);
  const Archive archive;
  channel.exchange.keep(archive);
  const auto inside = channel.inside();
  EXPECT_GT(inside[0], 0.);

  Channel<dim> other;
  other.exchange.keep(Archive::restore(archive.bytes()));
  std::vector<FluidVolumes> waiting(other.scene.mesh.graph().n_owned_cells());
  other.exchange.add_waiting(waiting);
  EXPECT_NEAR(sum_over_ranks(waiting, MPI_COMM_WORLD)[0], inside[0], 1e-15);
  EXPECT_EQ(other.exchange.books().inside()[0],
            channel.exchange.books().inside()[0]);
}



TYPED_TEST(BoundaryExchangeMpi, WhatWasAtRestOutsideComesInAlongTheNormal)
{
  constexpr int dim = TypeParam::value;
  Channel<dim>  channel(-.3, .2);
  for (unsigned int i = 0; i < 10; ++i)
    channel.step(.5 / 6 / .3);
  unsigned int n = 0;
  for (const auto &particle : channel.scene.population->particles())
    {
      const auto properties = particle.properties();
      if (properties[0] == 0.)
        continue; // there from the start
      ++n;
      EXPECT_NEAR(properties[0], -.3, 1e-12);
      EXPECT_NEAR(properties[dim - 1], 0., 1e-12);
    }
  EXPECT_GT(dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD), 50U);
}
