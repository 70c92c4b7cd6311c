// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/transfer/projection.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class ProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ProjectionMpi, Dimensions);

  template <typename T>
  class LeastSquaresMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(LeastSquaresMpi, Dimensions);

  template <typename T>
  class IncrementMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(IncrementMpi, Dimensions);

  template <int dim>
  std::unique_ptr<Projection<dim>>
  make_projection(const std::string &name)
  {
    return Registry<Projection<dim>>::entries().at(name).make();
  }


  /// Fills the mesh with particles anywhere in their sub-cells.
  template <int dim>
  void
  fill(Scene<dim> &scene)
  {
    SeedingParameters parameters;
    parameters.jitter = .8;
    seed(*scene.population,
         parameters,
         dealii::Functions::ZeroFunction<dim>(dim),
         dealii::Functions::ConstantFunction<dim>(1.));
  }


  /// Lets @p change(position, properties) set what particles carry.
  template <int dim, typename Change>
  void
  set_carried(Scene<dim> &scene, const Change &change)
  {
    for (auto &particle : scene.population->particles())
      change(particle.position(), particle.properties());
  }


  /// The sums over all particles of N_j rho at the nodes, folded.
  template <int dim>
  Vector
  masses(const Scene<dim> &scene)
  {
    Vector result;
    scene.space->initialize_scalar(result);
    for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
      for (const auto &particle : scene.population->in_cell(c))
        {
          const auto shape = Q1::values<dim>(particle.reference());
          for (unsigned int v = 0; v < shape.size(); ++v)
            result.local_element(scene.space->nodes(c)[v]) +=
              shape[v] * scene.fluids
                           .of_particle(Thalweg::Population<dim>::fluid_of(
                             particle.properties()))
                           .density;
        }
    scene.space->fold(result, 1);
    return result;
  }


  /// The momentum of all particles if each has a volume of one.
  template <int dim>
  dealii::Tensor<1, dim>
  momentum(const Scene<dim> &scene)
  {
    dealii::Tensor<1, dim> sum;
    for (const auto &particle : scene.population->particles())
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += scene.fluids
                    .of_particle(
                      Thalweg::Population<dim>::fluid_of(particle.properties()))
                    .density *
                  particle.properties()[d];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }


  /// The same at the nodes.
  template <int dim>
  dealii::Tensor<1, dim>
  momentum(const Scene<dim> &scene, const Vector &velocity)
  {
    const Vector           mass = masses(scene);
    dealii::Tensor<1, dim> sum;
    scene.for_each_node([&](const unsigned int n, const auto &) {
      sum += mass.local_element(n) * scene.at(velocity, n);
    });
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }


  /// A velocity and a level set without any pattern.
  template <int dim>
  void
  set_wild(Scene<dim> &scene)
  {
    set_carried(scene, [](const auto &x, const auto &properties) {
      for (unsigned int d = 0; d < dim; ++d)
        properties[d] = std::sin(90. * x[0] + 70. * x[dim - 1] + d);
      Thalweg::Population<dim>::set_level_set(properties,
                                              std::cos(50. * x[1] +
                                                       30. * x[0]));
    });
  }
} // namespace



TYPED_TEST(ProjectionMpi, KeepsConstantsWhateverTheDensities)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4), Meshes::distort_and_refine<dim>);
  fill(scene);
  for (const std::string name : {"weighted average", "least squares"})
    for (const double sign : {-1., 1.})
      {
        set_carried(scene, [&](const auto &x, const auto &properties) {
          for (unsigned int d = 0; d < dim; ++d)
            properties[d] = 1. + d;
          Thalweg::Population<dim>::set_level_set(
            properties, sign * (sign < 0 ? .3 : x[0] + .1));
        });
        Vector velocity = scene.velocity(
          [&](const auto &) { return dealii::Tensor<1, dim>(); });
        Vector level_set = scene.scalar([](const auto &) { return 0.; });
        make_projection<dim>(name)->project(
          *scene.population, *scene.space, scene.fluids, velocity, level_set);
        scene.for_each_node([&](const unsigned int n, const auto &) {
          for (unsigned int d = 0; d < dim; ++d)
            EXPECT_NEAR(velocity.local_element(dim * n + d), 1. + d, 1e-12);
          if (sign < 0)
            {
              EXPECT_NEAR(level_set.local_element(n), -.3, 1e-12);
            }
        });
      }
}



TYPED_TEST(ProjectionMpi, KeepsTheTotalMomentum)
{
  constexpr int dim = TypeParam::value;
  Scene<dim> scene(hanging_box<dim>(4, {"Periodic boundaries = left:right"}));
  fill(scene);
  set_wild(scene);
  Vector velocity =
    scene.velocity([&](const auto &) { return dealii::Tensor<1, dim>(); });
  Vector level_set = scene.scalar([](const auto &) { return 0.; });
  make_projection<dim>("weighted average")
    ->project(
      *scene.population, *scene.space, scene.fluids, velocity, level_set);
  const auto exact = momentum(scene);
  EXPECT_GT(exact.norm(), 1.);
  EXPECT_NEAR((momentum(scene, velocity) - exact).norm() / exact.norm(),
              0.,
              1e-12);
}



TYPED_TEST(ProjectionMpi, HeavyParticlesCountByTheirMass)
{
  // Light and heavy particles in turn along one direction of a mesh whose
  // nodes see as many of both: velocities 1 and 0. Beside the ends it is not
  // the mean alone.
  constexpr int     dim = TypeParam::value;
  Scene<dim>        scene(unit_box<dim>(8) + two_fluids(9., 1.));
  SeedingParameters parameters;
  parameters.particles_per_direction = 2;
  seed(*scene.population,
       parameters,
       dealii::Functions::ZeroFunction<dim>(dim),
       dealii::Functions::ConstantFunction<dim>(1.));
  set_carried(scene, [](const auto &x, const auto &properties) {
    const bool heavy = std::lround(std::floor(16. * x[0])) % 2 == 0;
    properties[0]    = heavy ? 1. : 0.;
    Thalweg::Population<dim>::set_level_set(properties, heavy ? -1. : 1.);
  });
  Vector velocity =
    scene.velocity([&](const auto &) { return dealii::Tensor<1, dim>(); });
  Vector level_set = scene.scalar([](const auto &) { return 0.; });
  make_projection<dim>("weighted average")
    ->project(
      *scene.population, *scene.space, scene.fluids, velocity, level_set);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    if (on_side_of_unit_box<dim>(p))
      return;
    if (std::abs(p[0] - .5) < .3)
      EXPECT_NEAR(velocity.local_element(dim * n), .9, 1e-12);
    EXPECT_NEAR(level_set.local_element(n), 0., 1e-12);
  });
}



TYPED_TEST(ProjectionMpi, NodesWithoutParticlesKeepTheirValues)
{
  constexpr int dim = TypeParam::value;
  for (const std::string name : {"weighted average", "least squares"})
    {
      Scene<dim> scene(hanging_box<dim>(4));
      Vector     velocity = scene.velocity(
        [&](const auto &p) { return dealii::Tensor<1, dim>(p); });
      Vector level_set = scene.scalar([](const auto &p) { return 2. * p[1]; });
      make_projection<dim>(name)->project(
        *scene.population, *scene.space, scene.fluids, velocity, level_set);
      scene.for_each_node([&](const unsigned int n, const auto &p) {
        EXPECT_EQ((scene.at(velocity, n) - p).norm(), 0.);
        EXPECT_EQ(level_set.local_element(n), 2. * p[1]);
      });
    }
}



TYPED_TEST(LeastSquaresMpi, AreExactForPlanes)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    bent(unit_box<dim>(4), Meshes::distort_and_refine<dim>);
  Scene<dim>    periodic(
    hanging_box<dim>(4, {"Periodic boundaries = left:right"}));
  for (Scene<dim> *scene : {&bent, &periodic})
    {
      const auto plane = [&](const dealii::Point<dim> &p) {
        return (scene == &bent ? 1.3 * p[0] : 0.) - p[1] + .2 * p[dim - 1];
      };
      fill(*scene);
      set_carried(*scene, [&](const auto &x, const auto &properties) {
        Thalweg::Population<dim>::set_level_set(properties, plane(x));
      });
      Vector velocity =
        scene->velocity([&](const auto &) { return dealii::Tensor<1, dim>(); });
      Vector level_set = scene->scalar([](const auto &) { return 0.; });
      make_projection<dim>("least squares")
        ->project(*scene->population,
                  *scene->space,
                  scene->fluids,
                  velocity,
                  level_set);
      scene->for_each_node([&](const unsigned int n, const auto &p) {
        EXPECT_NEAR(level_set.local_element(n), plane(p), 1e-10) << p;
      });
    }
}



TYPED_TEST(IncrementMpi, ParticlesGetTheInterpolatedDifference)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4), Meshes::distort_and_refine<dim>);
  fill(scene);
  set_carried(scene, [](const auto &x, const auto &properties) {
    properties[0] = 5. * x[1];
    Thalweg::Population<dim>::set_level_set(properties, x[0]);
  });
  const auto old_velocity = scene.velocity(
    [&](const auto &p) { return 3. * dealii::Tensor<1, dim>(p); });
  const auto new_velocity = scene.velocity([&](const auto &p) {
    dealii::Tensor<1, dim> u = 3. * dealii::Tensor<1, dim>(p);
    u[0] += 1. + p[0] - 2. * p[dim - 1];
    u[1] -= p[1];
    return u;
  });
  add_increment(*scene.population, *scene.space, new_velocity, old_velocity);
  set_carried(scene, [](const auto &x, const auto &properties) {
    EXPECT_NEAR(properties[0], 5. * x[1] + 1. + x[0] - 2. * x[dim - 1], 1e-12);
    EXPECT_NEAR(properties[1], -x[1], 1e-12);
    if (dim == 3)
      {
        EXPECT_NEAR(properties[2], 0., 1e-12);
      }
    EXPECT_EQ(properties[dim], x[0]);
  });
}



TYPED_TEST(IncrementMpi, AddsTheNodesMomentumToTheParticles)
{
  constexpr int dim = TypeParam::value;
  Scene<dim> scene(hanging_box<dim>(4, {"Periodic boundaries = left:right"}));
  fill(scene);
  set_wild(scene);
  const auto before = momentum(scene);
  const auto zero =
    scene.velocity([&](const auto &) { return dealii::Tensor<1, dim>(); });
  const auto change = scene.velocity([&](const auto &p) {
    dealii::Tensor<1, dim> u;
    u[0] = std::sin(7. * p[1]);
    u[1] = std::cos(9. * p[dim - 1]) + std::sin(2. * M_PI * p[0]);
    return u;
  });
  add_increment(*scene.population, *scene.space, change, zero);
  const auto gained = momentum(scene) - before;
  EXPECT_NEAR((gained - momentum(scene, change)).norm() / gained.norm(),
              0.,
              1e-12);
}
