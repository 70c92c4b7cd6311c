// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/dispersed_phase.h>

#include <gtest/gtest.h>

#include "particles/path_setup.h"

using namespace ParticleTest;
using Thalweg::DispersedPhase;
using Thalweg::NewParticle;
using Thalweg::Population;
using Thalweg::WallKind;

namespace
{
  constexpr double gravity = 9.81;

  template <int dim>
  void
  make_mesh(Thalweg::Mesh<dim> &mesh, const bool distorted)
  {
    make_box(mesh, 4);
    refine_around(mesh, middle_of_box<dim>(), .3);
    if (distorted)
      distort(mesh, .05);
  }

  template <int dim>
  typename DispersedPhase<dim>::Acceleration
  falling()
  {
    return [](const auto &, const auto &) {
      std::array<double, dim> g{};
      g[dim - 1] = -gravity;
      return g;
    };
  }

  /// Makes all particles water: each carries @p volume.
  template <int dim>
  void
  make_water(Population<dim> &population, const double volume)
  {
    for (auto &particle : population.handler())
      {
        Population<dim>::set_level_set(particle.get_properties(), -1e-3);
        particle.get_properties()[Population<dim>::volume_offset] = volume;
      }
  }

  template <int dim>
  double
  total_volume(const Population<dim> &population)
  {
    double sum = 0;
    for (const auto &particle : population.handler())
      sum += particle.get_properties()[Population<dim>::volume_offset];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /// A field that is high above the water everywhere.
  template <int dim>
  Thalweg::CellField<dim, 1>
  no_water(const Thalweg::Mesh<dim> &mesh)
  {
    return nodal_scalar<dim>(mesh, [](const auto &) { return 1.; });
  }

  /// Drops fly through many cells in one step, and are exactly where a
  /// parabola leads.
  template <int dim>
  void
  follow_parabolas(const bool distorted)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh, distorted);
    Population<dim> drops(mesh);
    seed_plain(drops, 2);
    make_water(drops, 1e-4);
    const Point<dim> middle = middle_of_box<dim>();
    set_velocity<dim>(drops, [&](const Point<dim> &p) {
      Tensor<1, dim> v = middle - p;
      v *= 1.5;
      v[dim - 1] += 1.;
      return v;
    });
    const auto   before = all_states(drops);
    const double dt     = .2;

    DispersedPhase<dim>           spray(drops, substeps("rk2", .5), {});
    std::vector<NewParticle<dim>> landed;
    const auto                    report =
      spray.fly(no_water(mesh), falling<dim>(), dt, 0., landed)
        .sum(MPI_COMM_WORLD);
    EXPECT_EQ(report.n_lost, 0u);
    EXPECT_TRUE(landed.empty());
    EXPECT_LE(inconsistency(drops), 1e-12);
    const auto after = all_states(drops);
    ASSERT_EQ(after.size(), before.size());
    unsigned int n_compared = 0;
    for (const auto &[id, old] : before)
      {
        Tensor<1, dim> g;
        g[dim - 1] = -gravity;
        const Point<dim> place =
          old.position + dt * (old.velocity + .5 * dt * g);
        const double top    = old.velocity[dim - 1] / gravity;
        const double height = old.position[dim - 1] + .5 * gravity * top * top;
        // Those that meet no wall.
        if (place[dim - 1] < 0 || (top > 0 && height > 1))
          continue;
        ++n_compared;
        EXPECT_LE(after.at(id).position.distance(place), 1e-12);
        EXPECT_LE((after.at(id).velocity - old.velocity - dt * g).norm(),
                  1e-12);
      }
    EXPECT_GE(n_compared, before.size() / 2);
  }

  /// A drop that falls on the floor slides on with what is along it.
  template <int dim>
  void
  slide_along_floor(const bool distorted)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh, distorted);
    Population<dim> drops(mesh);
    seed_plain(drops, 1);
    make_water(drops, 1e-4);
    Tensor<1, dim> forward;
    forward[0]       = .2;
    forward[dim - 1] = -3.;
    set_velocity<dim>(drops, constant(forward));
    const auto                    before = all_states(drops);
    DispersedPhase<dim>           spray(drops, substeps("rk2", .25), {});
    std::vector<NewParticle<dim>> landed;
    spray.fly(no_water(mesh), falling<dim>(), 1., 0., landed);
    for (const auto &[id, drop] : all_states(drops))
      {
        EXPECT_LE(std::abs(drop.position[dim - 1]), 1e-12);
        // Less than what a substep brings.
        EXPECT_LE(std::abs(drop.velocity[dim - 1]), 1.2);
        if (before.at(id).position[0] < .75)
          {
            EXPECT_NEAR(drop.position[0], before.at(id).position[0] + .2, 1e-9);
            EXPECT_NEAR(drop.velocity[0], .2, 1e-9);
          }
      }
    EXPECT_NEAR(total_volume(drops), 1e-4 * drops.n_global_particles(), 1e-15);
  }

  /// Drops that fall into water come back as particles, at the time and with
  /// the velocity that they have there.
  template <int dim>
  void
  land_in_water()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh, false);
    Population<dim> drops(mesh);
    seed_plain(drops, 1);
    make_water(drops, 1e-4);
    const double volume = total_volume(drops);
    const auto   level =
      nodal_scalar<dim>(mesh, [](const auto &p) { return p[dim - 1] - .3; });
    const auto                    before = all_states(drops);
    DispersedPhase<dim>           spray(drops, substeps("rk2", .125), {});
    std::vector<NewParticle<dim>> landed;
    const double                  dt = 1., ahead = .5;
    spray.fly(level, falling<dim>(), dt, ahead, landed);
    EXPECT_EQ(drops.n_global_particles(), 0u);
    double landed_volume = 0;
    for (const NewParticle<dim> &particle : landed)
      {
        landed_volume += particle.properties[Population<dim>::volume_offset];
        const auto &vertices = mesh.graph().cell(particle.cell).vertices;
        const auto  place =
          Thalweg::Q1::position<dim>(vertices, particle.reference);
        EXPECT_LE(place[dim - 1], .3);
        EXPECT_NEAR(particle.properties[Population<dim>::level_set_offset],
                    std::min(-1e-3, place[dim - 1] - .3),
                    1e-12);
        // All fell from rest: v = -g t at the time of the particles.
        EXPECT_NEAR(particle.properties[dim - 1], -gravity * ahead, 1e-12);
      }
    EXPECT_NEAR(dealii::Utilities::MPI::sum(landed_volume, MPI_COMM_WORLD),
                volume,
                1e-15);
  }

  /// Water that the mesh does not see becomes spray, and back where it is
  /// dense; volumes and velocities are kept, markers go.
  template <int dim>
  void
  exchange_both_ways()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    Population<dim> particles(mesh), drops(mesh);
    seed_plain(particles, 2);
    const double cell = std::pow(.25, dim), whole = cell / (1 << dim);
    make_water(particles, .2 * whole);
    const double volume = total_volume(particles);
    const auto   level =
      nodal_scalar<dim>(mesh, [](const auto &p) { return p[dim - 1] - .5; });
    DispersedPhase<dim> spray(drops, substeps("rk2", .5), {});
    const auto          before = all_states(particles);
    spray.exchange(particles, level, falling<dim>(), -.5);
    EXPECT_NEAR(total_volume(particles) + spray.volume(), volume, 1e-15);
    const auto flying = all_states(drops);
    for (const auto &[id, old] : before)
      EXPECT_EQ(flying.count(id), old.position[dim - 1] > .5 + .125 ? 1u : 0u);
    for (const auto &[id, drop] : flying)
      {
        EXPECT_EQ(drop.position.distance(before.at(id).position), 0.);
        EXPECT_NEAR(drop.velocity[dim - 1], -gravity * .5, 1e-14);
      }
    // So much in a cell is water again.
    for (auto &drop : drops.handler())
      drop.get_properties()[Population<dim>::volume_offset] *= 4.;
    const double all = total_volume(particles) + spray.volume();
    spray.exchange(particles, level, falling<dim>(), -.5);
    EXPECT_EQ(drops.n_global_particles(), 0u);
    EXPECT_NEAR(total_volume(particles), all, 1e-15);
    for (const auto &[id, particle] : all_states(particles))
      EXPECT_NEAR(particle.velocity[dim - 1], 0., 1e-14);

    make_water(particles, 0.);
    spray.exchange(particles, level, falling<dim>(), -.5);
    EXPECT_EQ(drops.n_global_particles(), 0u);
    EXPECT_EQ(particles.n_global_particles(), before.size() - flying.size());
  }
} // namespace


TEST(SprayMpi, FollowsParabolas)
{
  for (const bool distorted : {false, true})
    {
      follow_parabolas<2>(distorted);
      follow_parabolas<3>(distorted);
    }
}


TEST(SprayMpi, SlidesAlongTheFloor)
{
  for (const bool distorted : {false, true})
    {
      slide_along_floor<2>(distorted);
      slide_along_floor<3>(distorted);
    }
}


TEST(SprayMpi, LandsInTheWater)
{
  land_in_water<2>();
  land_in_water<3>();
}


TEST(SprayMpi, ComesFromWaterAndGoesBack)
{
  exchange_both_ways<2>();
  exchange_both_ways<3>();
}


TEST(SprayMpi, LeavesThroughOpenBoundaries)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_mesh(mesh, false);
  Population<2> drops(mesh);
  seed_plain(drops, 1);
  make_water(drops, 1e-4);
  set_velocity<2>(drops, constant(Tensor<1, 2>({5., 0.})));
  const auto                  n = drops.n_global_particles();
  DispersedPhase<2>           spray(drops,
                          substeps("rk2", .5),
                          {{1, WallKind::open}},
                          false);
  std::vector<NewParticle<2>> landed;
  const auto report = spray.fly(no_water(mesh), falling<2>(), 1., 0., landed);
  EXPECT_TRUE(report.exits.empty());
  double volume = 0;
  for (const auto &exit : report.drops)
    volume += exit.volume;
  EXPECT_NEAR(dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD),
              1e-4 * n,
              1e-15);
  EXPECT_EQ(report.sum(MPI_COMM_WORLD).left.at(1)[0], n);
  EXPECT_EQ(drops.n_global_particles(), 0u);
}
