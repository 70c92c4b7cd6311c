// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "fluid/solver_scene.h"
#include "support/dimensions.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class MonolithicMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(MonolithicMpi, Dimensions);

  constexpr double mu = .3;

  /// A flow of Stokes' equations, (0.3 friction) in the unit box.
  template <int dim>
  dealii::Tensor<1, dim>
  eddies(const dealii::Point<dim> &x)
  {
    dealii::Tensor<1, dim> u;
    if (dim == 2)
      {
        u[0] = std::sin(3. * x[0]) * std::cos(3. * x[1]);
        u[1] = -std::cos(3. * x[0]) * std::sin(3. * x[1]);
      }
    else
      {
        u[0] =
          std::sin(3. * x[0]) * std::cos(3. * x[1]) * std::cos(3. * x[2]);
        u[1] =
          std::cos(3. * x[0]) * std::sin(3. * x[1]) * std::cos(3. * x[2]);
        u[2] = -2. * std::cos(3. * x[0]) * std::cos(3. * x[1]) *
               std::sin(3. * x[2]);
      }
    return u;
  }

  template <int dim>
  double
  eddy_pressure(const dealii::Point<dim> &x)
  {
    return std::cos(2. * x[0]) * std::sin(3. * x[dim - 1]);
  }

  /// The flow as expressions.
  template <int dim>
  std::string
  eddies_as_text()
  {
    if (dim == 2)
      return "sin(3*x)*cos(3*y); -cos(3*x)*sin(3*y)";
    return "sin(3*x)*cos(3*y)*cos(3*z); cos(3*x)*sin(3*y)*cos(3*z); "
           "-2*cos(3*x)*cos(3*y)*sin(3*z)";
  }

  /// Conditions and forces with which it is steady.
  template <int dim>
  std::string
  eddy_case()
  {
    std::string velocity = "Velocity = ";
    for (const char *side : {"left", "right", "bottom", "top", "front", "back"})
      if (dim == 3 || (side != std::string("front") &&
                       side != std::string("back")))
        velocity += (velocity.back() == ' ' ? "" : " | ") + std::string(side) +
                    ": " + eddies_as_text<dim>();
    const std::string factor = std::to_string(mu * 9. * dim) + "*";
    std::string force;
    if (dim == 2)
      force = factor + "sin(3*x)*cos(3*y) - 2*sin(2*x)*sin(3*y); -" + factor +
              "cos(3*x)*sin(3*y) + 3*cos(2*x)*cos(3*y)";
    else
      force = factor + "sin(3*x)*cos(3*y)*cos(3*z) - 2*sin(2*x)*sin(3*z); " +
              factor + "cos(3*x)*sin(3*y)*cos(3*z); -2*" + factor +
              "cos(3*x)*cos(3*y)*sin(3*z) + 3*cos(2*x)*cos(3*z)";
    return section("Boundary conditions", {velocity}) +
           section("Body forces", {"Force density = " + force});
  }
} // namespace



TYPED_TEST(MonolithicMpi, SteadyStokesFlowsConverge)
{
  constexpr int dim = TypeParam::value;
  double        errors[2][2];
  for (const unsigned int level : {0, 1})
    {
      SolverScene<dim> scene(unit_box<dim>((dim == 2 ? 16 : 6) << level) +
                               one_fluid(1., mu) + eddy_case<dim>(),
                             "monolithic");
      scene.initialize();
      scene.find_steady_flow();
      errors[level][0] = scene.velocity_error(eddies<dim>);
      errors[level][1] = scene.pressure_error(eddy_pressure<dim>);
      EXPECT_LE(scene.context.statistics.get("coupled iterations"), 40.);
    }
  EXPECT_GT(std::log2(errors[0][0] / errors[1][0]), 1.9);
  EXPECT_GT(std::log2(errors[0][1] / errors[1][1]), .9);
  EXPECT_LT(errors[1][0], dim == 2 ? 1e-3 : 1e-2);
}
