// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/pressure_system.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class PressureSystemMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(PressureSystemMpi, Dimensions);

  /// The pressure for a velocity that the scene's forces act on.
  template <int dim>
  EnrichedPressure
  solve(const Scene<dim> &scene,
        const Vector     &velocity,
        const double      dt,
        const bool        with_forces = true)
  {
    PressureSystem<dim> system(*scene.space,
                               *scene.boundary,
                               *scene.phase,
                               scene.forces);
    EnrichedPressure    p;
    initialize(*scene.space, p);
    system.apply_open_boundary(nodal(p));
    scene.space->interpolate(nodal(p), 1);
    system.assemble();
    Vector rate = velocity;
    rate *= 1. / dt;
    rate.update_ghost_values();
    system.correct(rate, with_forces, p, 1e-12, 1000);
    return p;
  }


  /// The differences of the nodal values from those of @p exact.
  struct Errors
  {
    double greatest;
    double root_mean_square;
  };


  /// @param up_to_a_constant whether only differences of the pressure count
  template <int dim>
  Errors
  errors(const Scene<dim>                  &scene,
         const EnrichedPressure            &p,
         const typename Scene<dim>::Scalar &exact,
         const bool                         up_to_a_constant)
  {
    double sum = 0, n_nodes = 0, squares = 0, worst = 0;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      sum += nodal(p).local_element(n) - exact(x);
      n_nodes += 1.;
    });
    n_nodes           = sum_of_all(n_nodes);
    const double mean = up_to_a_constant ? sum_of_all(sum) / n_nodes : 0.;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      const double e = nodal(p).local_element(n) - mean - exact(x);
      worst          = std::max(worst, std::abs(e));
      squares += e * e;
    });
    return {max_of_all(worst), std::sqrt(sum_of_all(squares) / n_nodes)};
  }


  template <int dim>
  double
  pressure_error(const Scene<dim>                  &scene,
                 const EnrichedPressure            &p,
                 const typename Scene<dim>::Scalar &exact,
                 const bool                         up_to_a_constant)
  {
    return errors(scene, p, exact, up_to_a_constant).greatest;
  }

  constexpr double rho[2] = {1000., 1.};

  template <int dim>
  typename Scene<dim>::Field
  rest()
  {
    return [](const dealii::Point<dim> &) { return dealii::Tensor<1, dim>(); };
  }


  /// The normal of a tilted plane.
  template <int dim>
  dealii::Tensor<1, dim>
  normal()
  {
    dealii::Tensor<1, dim> normal;
    normal[1]       = .2;
    normal[0]       = -.3;
    normal[dim - 1] = 1.;
    return normal / normal.norm();
  }


  /// The distance to that plane.
  template <int dim>
  double
  plane(const dealii::Point<dim> &x)
  {
    return normal<dim>() * x - .33;
  }
} // namespace



TYPED_TEST(PressureSystemMpi, RecoversAPressureToSecondOrderAcrossDensities)
{
  // p = rho d s with the distance d to a plane and a smooth s: grad p / rho
  // is smooth, and as V/dt it is the velocity whose divergence p removes.
  constexpr int dim = TypeParam::value;
  const double  dt  = .1;
  const auto    s   = [](const dealii::Point<dim> &x) {
    return std::cos(2. * x[0]) + x[dim - 1];
  };
  const auto velocity = [&](const dealii::Point<dim> &x) {
    dealii::Tensor<1, dim> u = s(x) * normal<dim>();
    u[0] -= plane<dim>(x) * 2. * std::sin(2. * x[0]);
    u[dim - 1] += plane<dim>(x);
    return dt * u;
  };
  const auto exact = [&](const dealii::Point<dim> &x) {
    return rho[plane<dim>(x) < 0 ? 0 : 1] * plane<dim>(x) * s(x);
  };
  for (const bool hanging : {false, true})
    {
      double rms[2];
      for (const unsigned int level : {0, 1})
        {
          const unsigned int n = (dim == 2 ? 16 : 6) << level;
          const Scene<dim>   scene(
            (hanging ? hanging_box<dim>(n) : unit_box<dim>(n)) +
            two_fluids(rho[0], rho[1]));
          scene.set_phases(plane<dim>);
          rms[level] = errors(scene,
                              solve(scene, scene.velocity(velocity), dt),
                              exact,
                              true)
                         .root_mean_square;
        }
      EXPECT_LT(rms[1], rms[0] / 3.5) << hanging;
      EXPECT_LT(rms[1], (dim == 2 ? 2e-4 : 2e-3) * rho[0]) << hanging;
    }
}



TYPED_TEST(PressureSystemMpi, FluidsAtRestHaveTheirHydrostaticPressure)
{
  // Gravity normal to a tilted plane, 1000 : 1, in a closed box.
  constexpr int      dim = TypeParam::value;
  const auto         g   = -8. * normal<dim>();
  std::ostringstream components;
  components << std::setprecision(17) << g[0];
  for (unsigned int d = 1; d < dim; ++d)
    components << ", " << g[d];
  const Scene<dim> scene(
    hanging_box<dim>(6) + two_fluids(rho[0], rho[1]) +
    section("Body forces", {"Gravity = " + components.str()}));
  scene.set_phases(plane<dim>);
  const auto exact = [](const dealii::Point<dim> &x) {
    return -8. * rho[plane<dim>(x) < 0 ? 0 : 1] * plane<dim>(x);
  };
  EXPECT_LT(pressure_error(scene,
                           solve(scene, scene.velocity(rest<dim>()), .1),
                           exact,
                           true),
            1e-9 * 8000.);
}



TYPED_TEST(PressureSystemMpi, OpenBoundariesSetTheLevelOfThePressure)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(
    hanging_box<dim>(6) + two_fluids(rho[0], rho[1]) +
    section("Body forces",
            {dim == 2 ? "Gravity = 0, -8" : "Gravity = 0, -8, 0"}) +
    section("Boundary conditions", {"Open = top: 50 + 8"}));
  scene.set_phases([](const auto &x) { return x[1] - .43; });
  const auto exact = [](const dealii::Point<dim> &x) {
    return 50. + 8. + 8. * rho[1] * (1. - x[1]) +
           (x[1] < .43 ? 8. * (rho[0] - rho[1]) * (.43 - x[1]) : 0.);
  };
  EXPECT_LT(pressure_error(scene,
                           solve(scene, scene.velocity(rest<dim>()), .1),
                           exact,
                           false),
            1e-8 * 8000.);
}



TYPED_TEST(PressureSystemMpi, OpenBoundariesActOnAFluidAtRest)
{
  // Nothing else moves the fluid than the pressures at both ends.
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(
    hanging_box<dim>(4) + one_fluid(3., 0.) +
    section("Boundary conditions", {"Open = left: 7 | right: 2"}));
  scene.set_phases([](const auto &) { return -1.; });
  EXPECT_LT(pressure_error(
              scene,
              solve(scene, scene.velocity(rest<dim>()), .1),
              [](const auto &x) { return 7. - 5. * x[0]; },
              false),
            1e-9);
}



TYPED_TEST(PressureSystemMpi, AConstantForceDensityIsBalancedExactly)
{
  constexpr int     dim   = TypeParam::value;
  const std::string force = dim == 2 ? "3; -2*t" : "3; -2*t; 1";
  for (const std::string &fluids :
       {one_fluid(2., 0.), two_fluids(rho[0], rho[1])})
    {
      Scene<dim> scene(hanging_box<dim>(4) + fluids +
                       section("Body forces", {"Force density = " + force}));
      scene.forces.set_time(2.);
      scene.set_phases(plane<dim>);
      EXPECT_LT(pressure_error(
                  scene,
                  solve(scene, scene.velocity(rest<dim>()), .1),
                  [](const auto &x) {
                    return 3. * x[0] - 4. * x[1] + (dim == 3 ? x[dim - 1] : 0.);
                  },
                  true),
                1e-8);
    }
}



TYPED_TEST(PressureSystemMpi, ASolenoidalVelocityNeedsNoPressure)
{
  // Through given inflow and outflow, with the interface in between.
  static constexpr int dim   = TypeParam::value;
  const std::string    other = dim == 3 ? "; 0" : "";
  Scene<dim>           scene(
    hanging_box<dim>(4) + two_fluids(rho[0], rho[1]) +
    section("Boundary conditions",
            {"Velocity = left: 2; 0" + other + " | right: 2; 0" + other}));
  scene.set_phases(plane<dim>);
  const auto flow = [](const auto &) {
    dealii::Tensor<1, dim> u;
    u[0] = 2.;
    return u;
  };
  EXPECT_LT(pressure_error(
              scene,
              solve(scene, scene.velocity(flow), 1e-3),
              [](const auto &) { return 0.; },
              true),
            1e-9 * 1e3);
}



TYPED_TEST(PressureSystemMpi, TheGradientPushesAsThePressureFalls)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4) + one_fluid(1., 0.),
                   Meshes::distort_and_refine<dim>);
  scene.set_phases([](const auto &) { return -1.; });
  PressureSystem<dim> system(*scene.space,
                             *scene.boundary,
                             *scene.phase,
                             scene.forces);
  EnrichedPressure    p;
  initialize(*scene.space, p);
  nodal(p) = scene.scalar([](const auto &x) { return 3. * x[0] - x[1]; });
  Vector force;
  scene.space->initialize_velocity(force);
  system.subtract_gradient(p, force);
  scene.space->fold(force, dim);
  dealii::Tensor<1, dim> sum;
  double                 worst = 0;
  scene.for_each_node([&](const unsigned int n, const auto &) {
    const auto f = scene.at(force, n);
    sum += f;
    worst = std::max(worst, std::abs(f[0] + 3. * f[1]));
  });
  sum = dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  EXPECT_NEAR(worst, 0., 1e-14);
  EXPECT_NEAR(sum[0], -3., 1e-12);
  EXPECT_NEAR(sum[1], 1., 1e-12);
}
