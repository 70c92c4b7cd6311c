// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
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
  Thalweg::Mesh<dim> &
  make_mesh(Thalweg::Mesh<dim> &mesh, const bool distorted)
  {
    make_box(mesh, 4);
    refine_around(mesh, middle_of_box<dim>(), .3);
    if (distorted)
      distort(mesh, .05);
    return mesh;
  }

  /// Drops fall, bubbles rise with a velocity of 0.25 m/s.
  template <int dim>
  Thalweg::DispersedMotion<dim>
  falling()
  {
    Thalweg::DispersedMotion<dim> motion;
    motion.acceleration = [](const auto &, const auto &) {
      std::array<double, dim> g{};
      g[dim - 1] = -gravity;
      return g;
    };
    motion.rise = [](const auto &, const double) {
      std::array<double, dim> v{};
      v[dim - 1] = .25;
      return v;
    };
    return motion;
  }

  /// A mesh that stands still.
  template <int dim>
  Thalweg::CellVelocity<dim>
  still(const Thalweg::Mesh<dim> &mesh)
  {
    return nodal<dim>(mesh, constant(Tensor<1, dim>()));
  }

  /// Makes all particles water: each carries @p volume.
  template <int dim>
  void
  make_water(Population<dim> &population, const double volume)
  {
    for (auto &particle : population.particles())
      {
        Population<dim>::set_level_set(particle.properties(), -1e-3);
        particle.properties()[Population<dim>::volume_offset] = volume;
      }
  }

  template <int dim>
  double
  total_volume(const Population<dim> &population)
  {
    double sum = 0;
    for (const auto &particle : population.particles())
      sum += particle.properties()[Population<dim>::volume_offset];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /// A field that is high above the water everywhere.
  template <int dim>
  Thalweg::CellField<dim, 1>
  no_water(const Thalweg::Mesh<dim> &mesh)
  {
    return nodal_scalar<dim>(mesh, [](const auto &) { return 1.; });
  }

  /// A mesh full of drops that each have the same volume.
  template <int dim>
  struct Rain
  {
    Rain(const bool distorted, const unsigned int per_direction)
      : mesh(MPI_COMM_WORLD)
      , drops(make_mesh(mesh, distorted))
    {
      seed_plain(drops, per_direction);
      make_water(drops, 1e-4);
    }

    Thalweg::Mesh<dim> mesh;
    Population<dim>    drops;
  };

  /// Drops fly through many cells in one step, and are exactly where a
  /// parabola leads.
  template <int dim>
  void
  follow_parabolas(const bool distorted)
  {
    Rain<dim> rain(distorted, 2);
    auto &[mesh, drops]     = rain;
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
      spray
        .move(no_water(mesh), still<dim>(mesh), falling<dim>(), dt, 0., landed)
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
    Rain<dim> rain(distorted, 1);
    auto &[mesh, drops] = rain;
    Tensor<1, dim> forward;
    forward[0]       = .2;
    forward[dim - 1] = -3.;
    set_velocity<dim>(drops, constant(forward));
    const auto                    before = all_states(drops);
    DispersedPhase<dim>           spray(drops, substeps("rk2", .25), {});
    std::vector<NewParticle<dim>> landed;
    spray.move(
      no_water(mesh), still<dim>(mesh), falling<dim>(), 1., 0., landed);
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
    Rain<dim> rain(false, 1);
    auto &[mesh, drops] = rain;
    const double volume = total_volume(drops);
    const auto   level =
      nodal_scalar<dim>(mesh, [](const auto &p) { return p[dim - 1] - .3; });
    const auto                    before = all_states(drops);
    DispersedPhase<dim>           spray(drops, substeps("rk2", .125), {});
    std::vector<NewParticle<dim>> landed;
    const double                  dt = 1., ahead = .5;
    spray.move(level, still<dim>(mesh), falling<dim>(), dt, ahead, landed);
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
                1e-14);
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
    EXPECT_NEAR(total_volume(particles) + spray.volumes()[0], volume, 1e-14);
    const auto flying = all_states(drops);
    for (const auto &[id, old] : before)
      EXPECT_EQ(flying.count(id), old.position[dim - 1] > .5 + .125 ? 1u : 0u);
    for (const auto &[id, drop] : flying)
      {
        EXPECT_EQ(drop.position.distance(before.at(id).position), 0.);
        EXPECT_NEAR(drop.velocity[dim - 1], -gravity * .5, 1e-14);
      }
    // So much in a cell is water again.
    for (auto &drop : drops.particles())
      drop.properties()[Population<dim>::volume_offset] *= 16.;
    const double all = total_volume(particles) + spray.volumes()[0];
    spray.exchange(particles, level, falling<dim>(), -.5);
    EXPECT_EQ(drops.n_global_particles(), 0u);
    EXPECT_NEAR(total_volume(particles), all, 1e-14);
    for (const auto &[id, particle] : all_states(particles))
      EXPECT_NEAR(particle.velocity[dim - 1], 0., 1e-14);

    make_water(particles, 0.);
    spray.exchange(particles, level, falling<dim>(), -.5);
    EXPECT_EQ(drops.n_global_particles(), 0u);
    EXPECT_EQ(particles.n_global_particles(), before.size() - flying.size());
  }
} // namespace


TEST(DispersedPhaseMpi, FollowsParabolas)
{
  for (const bool distorted : {false, true})
    {
      follow_parabolas<2>(distorted);
      follow_parabolas<3>(distorted);
    }
}


TEST(DispersedPhaseMpi, SlidesAlongTheFloor)
{
  for (const bool distorted : {false, true})
    {
      slide_along_floor<2>(distorted);
      slide_along_floor<3>(distorted);
    }
}


TEST(DispersedPhaseMpi, LandsInTheWater)
{
  land_in_water<2>();
  land_in_water<3>();
}


TEST(DispersedPhaseMpi, ComesFromWaterAndGoesBack)
{
  exchange_both_ways<2>();
  exchange_both_ways<3>();
}


TEST(DispersedPhaseMpi, BubblesGoWithTheFlowAndThroughIt)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_mesh(mesh, false);
  Population<2> bubbles(mesh);
  seed_plain(bubbles, 1);
  for (auto &bubble : bubbles.particles())
    bubble.properties()[Population<2>::volume_offset] = 1e-4;
  const auto before = all_states(bubbles);
  const auto water =
    nodal_scalar<2>(mesh, [](const auto &p) { return p[1] - 2.; });
  const auto        flow = nodal<2>(mesh, constant(Tensor<1, 2>({.1, 0.})));
  const double      dt   = 1.;
  DispersedPhase<2> phase(bubbles, substeps("rk2", .5), {});
  std::vector<NewParticle<2>> landed;
  phase.move(water, flow, falling<2>(), dt, 0., landed);
  EXPECT_TRUE(landed.empty());
  for (const auto &[id, bubble] : all_states(bubbles))
    if (const auto &p = before.at(id).position; p[0] < .85 && p[1] < .7)
      {
        EXPECT_LE(bubble.position.distance(p + Tensor<1, 2>({.1, .25})), 1e-9);
      }

  // In air they are air again, with its velocity.
  const auto surface =
    nodal_scalar<2>(mesh, [](const auto &p) { return p[1] - .5; });
  phase.move(surface, flow, falling<2>(), 4., 0., landed);
  EXPECT_EQ(bubbles.n_global_particles(), 0u);
  for (const auto &particle : landed)
    {
      EXPECT_NEAR(particle.properties[0], .1, 1e-12);
      EXPECT_GE(particle.properties[Population<2>::level_set_offset], 0.);
    }
}


TEST(DispersedPhaseMpi, LeavesThroughOpenBoundaries)
{
  Rain<2> rain(false, 1);
  auto &[mesh, drops] = rain;
  set_velocity<2>(drops, constant(Tensor<1, 2>({5., 0.})));
  const auto        n = drops.n_global_particles();
  DispersedPhase<2> spray(drops, substeps("rk2", .5), {{1, WallKind::open}});
  std::vector<NewParticle<2>> landed;
  const auto                  report =
    spray.move(no_water(mesh), still<2>(mesh), falling<2>(), 1., 0., landed);
  EXPECT_TRUE(report.exits.empty());
  double volume = 0;
  for (const auto &exit : report.dispersed_exits)
    volume += exit.volume;
  EXPECT_NEAR(dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD),
              1e-4 * n,
              1e-15);
  EXPECT_EQ(report.sum(MPI_COMM_WORLD).left.at(1)[0], n);
  EXPECT_EQ(drops.n_global_particles(), 0u);
}
