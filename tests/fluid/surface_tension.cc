// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fluid/solver_scene.h"
#include "support/dimensions.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class SurfaceTensionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(SurfaceTensionMpi, Dimensions);

  constexpr double sigma = .07, radius = .3;

  std::string
  tension(const std::string &curvature = "")
  {
    return section("Interface",
                   {},
                   section("Surface tension",
                           {"Coefficient = " + std::to_string(sigma),
                            "Curvature = " + curvature}));
  }

  /// The distance from a ball that is not where nodes are.
  template <int dim>
  double
  ball(const dealii::Point<dim> &x)
  {
    const dealii::Point<dim> center = dim == 2
                                        ? dealii::Point<dim>(.513, .479)
                                        : dealii::Point<dim>(.513, .479, .507);
    return x.distance(center) - radius;
  }

  /// The difference of the pressures in the middle and in a corner of a box,
  /// far from the interface.
  template <int dim>
  double
  pressure_difference(const SolverScene<dim> &scene)
  {
    double inside = -1e300, outside = -1e300;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      const double p   = scene.solver->pressure().local_element(n);
      const double phi = ball<dim>(x);
      if (phi < -.5 * radius)
        inside = std::max(inside, p);
      if (phi > .5 * radius)
        outside = std::max(outside, p);
    });
    return max_of_all(inside) - max_of_all(outside);
  }
} // namespace



// With the right curvature a drop is at rest, whatever the densities and the
// mesh, and both solvers know the pressure inside.
TYPED_TEST(SurfaceTensionMpi, DropsAreAtRestWithTheRightCurvature)
{
  constexpr int dim = TypeParam::value;
  for (const std::string solver : {"fractional step", "monolithic"})
    for (const std::string mesh : {"even", "hanging"})
      {
        const std::string curvature = std::to_string((dim - 1) / radius);
        SolverScene<dim>  scene(
          (mesh == "even" ? unit_box<dim>(12) : hanging_box<dim>(6)) +
            two_fluids(1000., 1., 1e-3, 1e-5) + tension(curvature),
          solver,
          solver == "monolithic" ? "set Tolerance = 1e-12\n"
                                  : "set Pressure tolerance = 1e-14\n");
        scene.initialize(ball<dim>);
        scene.step_from_rest(1.);
        const double exact = sigma * std::stod(curvature);
        EXPECT_NEAR(pressure_difference(scene), exact, 1e-9 * exact)
          << solver << ' ' << mesh;
        // The gas would move with sigma dt / (rho R h) = 1 m/s.
        EXPECT_LT(scene.velocity_error(
                    [](const auto &) { return dealii::Tensor<1, dim>(); }),
                  1e-10)
          << solver << ' ' << mesh;
      }
}



// Small waves on a plane interface are pulled back with sigma k^3 / (rho_1 +
// rho_2) of their height, wherever it is between the nodes.
TEST(SurfaceTension, WavesArePulledBack)
{
  const unsigned int n = 32;
  for (const double density : {1e-3, 1e3})
    for (const auto &[waves, smallest, largest] :
         {std::make_tuple(1, .98, 1.), std::make_tuple(2, .96, 1.)})
      for (const double offset : {.002, .01, .1, .5, .9, .998})
        {
          SolverScene<2> scene(unit_box<2>(n) + two_fluids(1., density) +
                                 tension(),
                               "fractional step",
                               "set Pressure tolerance = 1e-12\n");
          const double   k      = 2. * dealii::numbers::PI * waves;
          const double   height = 1e-3 / n, dt = 1e-4;
          scene.initialize([&](const auto &x) {
            return x[1] - .5 - offset / n - height * std::cos(k * x[0]);
          });
          scene.step_from_rest(dt);
          double sums[2] = {0., 0.};
          scene.for_each_node([&](const unsigned int node, const auto &x) {
            const double row    = (x[1] - .5) * n;
            const double weight = std::max(0., 1. - std::abs(row - offset)) *
                                  (on_side_of_unit_box(x) ? .5 : 1.);
            const double wave = std::cos(k * x[0]);
            sums[0] +=
              weight * wave * scene.at(scene.solver->velocity(), node)[1];
            sums[1] += weight * wave * wave;
          });
          const double exact =
            -sigma * k * k * k / (1. + density) * height * dt;
          EXPECT_GT(sums[0] / sums[1] / exact, smallest)
            << density << ' ' << waves << ' ' << offset;
          EXPECT_LT(sums[0] / sums[1] / exact, largest)
            << density << ' ' << waves << ' ' << offset;
        }
}
