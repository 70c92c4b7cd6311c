// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/viscous_operator.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class ViscousOperatorMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ViscousOperatorMpi, Dimensions);

  template <int dim>
  using Gradient = dealii::Tensor<2, dim>;

  /// -K u, folded.
  template <int dim>
  Vector
  viscous_force(const Scene<dim> &scene, const Vector &u)
  {
    const ViscousOperator<dim> viscous(*scene.space,
                                       *scene.boundary,
                                       *scene.phase);
    Vector                     force;
    scene.space->initialize_velocity(force);
    viscous.subtract_viscous_force(u, force);
    scene.space->fold(force, dim);
    return force;
  }


  /// A bent mesh with hanging nodes, filled with a fluid of viscosity 0.7.
  template <int dim>
  std::unique_ptr<Scene<dim>>
  bent_scene()
  {
    auto scene =
      std::make_unique<Scene<dim>>(unit_box<dim>(4) + one_fluid(1., .7),
                                   Meshes::distort_and_refine<dim>);
    scene->set_phases([](const auto &) { return -1.; });
    return scene;
  }


  template <int dim>
  Gradient<dim>
  some_gradient()
  {
    Gradient<dim> gradient;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        gradient[d][e] = std::sin(1. + 2. * d + 5. * e);
    return gradient;
  }


  /// The same arbitrary vector on any number of ranks.
  template <int dim>
  Vector
  arbitrary(const Scene<dim> &scene, const double seed)
  {
    return scene.velocity([&](const auto &p) {
      dealii::Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = std::sin(37. * seed * p[0] + 61. * p[1] + 17. * p[dim - 1] + d);
      return u;
    });
  }


  /// Lumped masses of an arbitrary size.
  template <int dim>
  Vector
  arbitrary_masses(const Scene<dim> &scene)
  {
    return scene.scalar([](const auto &p) { return 1. + p[0] * p[1]; });
  }

  const double mu_1 = 4., mu_2 = .05;

  /// Two layers, the lower fluid up to @p height, in a box with hanging nodes
  /// or none.
  template <int dim>
  std::unique_ptr<Scene<dim>>
  layers(const std::string &box, const double height)
  {
    auto scene =
      std::make_unique<Scene<dim>>(box + two_fluids(2., 1., mu_1, mu_2));
    scene->set_phases([&](const auto &p) { return p[1] - height; });
    return scene;
  }
} // namespace



TYPED_TEST(ViscousOperatorMpi, RigidMotionsMeetNoForce)
{
  constexpr int dim      = TypeParam::value;
  const auto    scene    = bent_scene<dim>();
  Gradient<dim> rotation = some_gradient<dim>();
  rotation -= transpose(rotation);
  const Vector force =
    viscous_force(*scene, scene->velocity([&](const auto &p) {
      dealii::Tensor<1, dim> u = rotation * p;
      u[1] += 3.;
      return u;
    }));
  EXPECT_NEAR(force.linfty_norm(), 0., 1e-14);
}



TYPED_TEST(ViscousOperatorMpi, LinearVelocitiesHaveTheirStressAndEnergy)
{
  constexpr int       dim      = TypeParam::value;
  const auto          scene    = bent_scene<dim>();
  const Gradient<dim> gradient = some_gradient<dim>();
  const auto          rate     = symmetrize(gradient);
  const Vector u = scene->velocity([&](const auto &p) { return gradient * p; });
  const Vector force = viscous_force(*scene, u);
  EXPECT_NEAR(-(u * force), 2. * .7 * (rate * rate), 1e-12);

  // Inside it is in balance; the sum of x times force is minus the first row
  // of the stress.
  dealii::Tensor<1, dim> virial;
  scene->for_each_node([&](const unsigned int n, const auto &p) {
    if (!on_side_of_unit_box<dim>(p))
      {
        EXPECT_NEAR(scene->at(force, n).norm(), 0., 1e-13) << p;
      }
    virial += p[0] * scene->at(force, n);
  });
  virial = dealii::Utilities::MPI::sum(virial, MPI_COMM_WORLD);
  for (unsigned int d = 0; d < dim; ++d)
    EXPECT_NEAR(virial[d], -2. * .7 * rate[d][0], 1e-12);
}



TYPED_TEST(ViscousOperatorMpi, QuadraticVelocitiesHaveTheirDivergenceOfStress)
{
  // With u_x = y^2 the force per volume is 2 mu in direction x; with
  // u_x = x^2, which is not free of divergence, 4 mu.
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4) + one_fluid(1., .7));
  scene.set_phases([](const auto &) { return -1.; });
  for (const unsigned int direction : {0, 1})
    {
      const Vector force =
        viscous_force(scene, scene.velocity([&](const auto &p) {
          dealii::Tensor<1, dim> u;
          u[0] = p[direction] * p[direction];
          return u;
        }));
      scene.for_each_node([&](const unsigned int n, const auto &p) {
        if (on_side_of_unit_box<dim>(p))
          return;
        auto rest = scene.at(force, n);
        rest[0] -= (direction == 0 ? 4. : 2.) * .7 * std::pow(.25, dim);
        EXPECT_NEAR(rest.norm(), 0., 1e-14) << p;
      });
    }
}



TYPED_TEST(ViscousOperatorMpi, ShearAcrossLayersIsInBalance)
{
  // The stress tau is the same in both fluids, so the slope of u jumps.
  constexpr int dim    = TypeParam::value;
  const double  height = .43, tau = 3.;
  const auto    scene = layers<dim>(unit_box<dim>(4), height);
  const Vector  u     = scene->velocity([&](const auto &p) {
    dealii::Tensor<1, dim> u;
    u[0] = p[1] < height ? tau / mu_1 * p[1]
                              : tau / mu_1 * height + tau / mu_2 * (p[1] - height);
    return u;
  });
  const Vector  force = viscous_force(*scene, u);
  scene->for_each_node([&](const unsigned int n, const auto &p) {
    if (!on_side_of_unit_box<dim>(p))
      {
        EXPECT_NEAR(scene->at(force, n).norm(), 0., 1e-13) << p;
      }
  });
  EXPECT_NEAR(-(u * force),
              tau * tau * (height / mu_1 + (1. - height) / mu_2),
              1e-10);
}



TYPED_TEST(ViscousOperatorMpi, StretchingAlongLayersSeesTheArithmeticMean)
{
  constexpr int dim    = TypeParam::value;
  const double  height = .43;
  const auto    scene  = layers<dim>(hanging_box<dim>(4), height);
  const Vector  u      = scene->velocity([&](const auto &p) {
    dealii::Tensor<1, dim> u;
    u[0] = p[0];
    u[1] = -p[1];
    return u;
  });
  EXPECT_NEAR(-(u * viscous_force(*scene, u)),
              4. * (height * mu_1 + (1. - height) * mu_2),
              1e-12);
}



TYPED_TEST(ViscousOperatorMpi, IsSymmetricAndPositive)
{
  constexpr int dim = TypeParam::value;
  const auto    scene =
    layers<dim>(hanging_box<dim>(4, {"Periodic boundaries = left:right"}), .43);
  const Vector         mass = arbitrary_masses(*scene);
  ViscousOperator<dim> A(*scene->space, *scene->boundary, *scene->phase);
  A.update(mass, .1);
  Vector a = arbitrary(*scene, 1.), b = arbitrary(*scene, 2.), Aa, Ab;
  for (Vector *vector : {&a, &b})
    {
      vector->zero_out_ghost_values();
      const auto &continuity = scene->space->scalar_layout();
      for (unsigned int n = 0; n < continuity.locally_owned_size(); ++n)
        if (scene->space->is_dependent(n))
          for (unsigned int d = 0; d < dim; ++d)
            vector->local_element(dim * n + d) = 0.;
      scene->boundary->project(*vector);
    }
  scene->space->initialize_velocity(Aa);
  scene->space->initialize_velocity(Ab);
  A.vmult(Aa, a);
  A.vmult(Ab, b);
  EXPECT_NEAR(a * Ab, b * Aa, 1e-9 * std::abs(a * Aa));
  EXPECT_GT(a * Aa, 0.);
  EXPECT_GT(b * Ab, 0.);
}



TYPED_TEST(ViscousOperatorMpi, JacobiHasTheRealDiagonal)
{
  constexpr int        dim   = TypeParam::value;
  const auto           scene = layers<dim>(unit_box<dim>(3), .43);
  const Vector         mass  = arbitrary_masses(*scene);
  ViscousOperator<dim> A(*scene->space, *scene->boundary, *scene->phase);
  A.update(mass, .1);
  Vector unit, column;
  scene->space->initialize_velocity(unit);
  scene->space->initialize_velocity(column);
  const auto &owned = unit.locally_owned_elements();
  for (unsigned int i = 0; i < unit.size(); ++i)
    {
      const bool         here  = owned.is_element(i);
      const unsigned int local = here ? owned.index_within_set(i) : 0;
      unit                     = 0.;
      if (here)
        unit.local_element(local) = 1.;
      A.vmult(column, unit);
      if (here && column.local_element(local) != 0.)
        {
          EXPECT_NEAR(A.jacobi().inverse_diagonal.local_element(local) *
                        column.local_element(local),
                      1.,
                      1e-12);
        }
    }
}



// A film beside a wall to which fluid sticks does not lubricate what is above
// it, as long as it is thinner than a cell.
TYPED_TEST(ViscousOperatorMpi, FilmsAtWallsDoNotLubricate)
{
  const auto work = [](const std::string &condition) {
    constexpr int dim   = TypeParam::value;
    const auto    scene = layers<dim>(
      unit_box<dim>(4) + section("Boundary conditions", {condition}), .1);
    const Vector u = scene->velocity([](const auto &p) {
      dealii::Tensor<1, dim> v;
      v[0] = p[1];
      return v;
    });
    return -(u * viscous_force(*scene, u));
  };
  // mu_1 up to 0.1
  const double lowest = (.4 * mu_1 + .6 * mu_2) / 4.;
  EXPECT_NEAR(work("No slip = bottom"), lowest + .75 * mu_2, 1e-12);
  EXPECT_LT(work("Slip = bottom"), .2 * lowest + .75 * mu_2);
}
