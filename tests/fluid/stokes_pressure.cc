// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/stokes_pressure.h>

#include "step_scene.h"
#include "support/dimensions.h"

using namespace Steps;

namespace
{
  template <typename T>
  class StokesPressureMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(StokesPressureMpi, Dimensions);


  constexpr double nu = .3;


  /// A quadratic velocity without divergence, symmetric about x = 0: Lap u is
  /// constant, -4 along y.
  template <int dim>
  dealii::Tensor<1, dim>
  flow(const dealii::Point<dim> &p)
  {
    dealii::Tensor<1, dim> u;
    u[0] = 2. * p[0] * p[1];
    u[1] = -p[0] * p[0] - p[1] * p[1];
    return u;
  }
} // namespace



TYPED_TEST(StokesPressureMpi, BoundariesKnowTheWeakLaplacian)
{
  constexpr int dim = TypeParam::value;
  for (const std::string &conditions :
       {section("Boundary conditions", {"No slip = left, right, bottom, top"}),
        section("Boundary conditions",
                {"Slip = left", "No slip = right, bottom, top"})})
    for (const unsigned int pressure_degree : {1u, 2u})
      {
        const StepScene<dim>   scene(hanging_box<dim>(3) + conditions,
                                   2,
                                   pressure_degree,
                                   nu);
        StokesPressure<dim>    stokes(scene.operators, scene.flow_boundary, nu);
        const Vector           u = scene.flow_velocity(flow<dim>);
        dealii::Tensor<1, dim> laplacian;
        laplacian[1] = -4.;
        const Vector g =
          scene.flow_velocity([&](const auto &) { return nu * laplacian; });
        Vector found = scene.empty_pressure(), wanted = scene.empty_pressure();
        stokes.add(u, g, found);
        scene.operators.add_weak_gradient(g, wanted, 1.);
        scene.P.fold(found, 1);
        scene.P.fold(wanted, 1);
        const double largest = wanted.linfty_norm();
        EXPECT_GT(largest, .01);
        found.add(-1., wanted);
        EXPECT_LT(found.linfty_norm(), 1e-12 * largest) << conditions;
      }
}
