// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/convected_change.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class ConvectedChangeMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ConvectedChangeMpi, Dimensions);

  /// The greatest difference from @p exact(position) within @p radius around
  /// the middle of the unit box.
  template <int dim>
  double
  error(const Scene<dim>                 &scene,
        const typename Scene<dim>::Field &velocity,
        const double                      time,
        const typename Scene<dim>::Field &exact,
        const double                      radius)
  {
    ConvectionParameters parameters;
    parameters.integrator             = "rk4";
    parameters.substep_courant_number = .1;
    const StreamlineConvection<dim> convection(scene.mesh, parameters, {});
    CellField<dim, 1>               level_set;
    scene.space->copy_to_cells(scene.scalar([](const auto &) { return -1.; }),
                               level_set);
    Vector change;
    scene.space->initialize_velocity(change);
    ConvectedChange<dim>(*scene.space)
      .find(convection, scene.velocity(velocity), level_set, time, change);
    dealii::Point<dim> middle;
    for (unsigned int d = 0; d < dim; ++d)
      middle[d] = .5;
    double worst = 0;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      if (x.distance(middle) < radius)
        worst = std::max(worst, (scene.at(change, n) - exact(x)).norm());
    });
    return max_of_all(worst);
  }
} // namespace



TYPED_TEST(ConvectedChangeMpi, InASteadyRotationItIsThatOfTheRotation)
{
  // The velocity is linear, so that the walk is all that can be wrong; half a
  // radian leads through several cells.
  static constexpr int dim  = TypeParam::value;
  const double         time = .5;
  const Scene<dim>     scene(unit_box<dim>(8), Meshes::distort_and_refine<dim>);
  const auto           velocity = [](const dealii::Point<dim> &x) {
    dealii::Tensor<1, dim> u;
    u[0] = .5 - x[1];
    u[1] = x[0] - .5;
    return u;
  };
  const auto exact = [&](const dealii::Point<dim> &x) {
    const auto             u = velocity(x);
    dealii::Tensor<1, dim> before;
    before[0] = std::cos(time) * u[0] + std::sin(time) * u[1];
    before[1] = std::cos(time) * u[1] - std::sin(time) * u[0];
    return before - u;
  };
  EXPECT_LT(error<dim>(scene, velocity, time, exact, .4), 1e-6);
}



TYPED_TEST(ConvectedChangeMpi, UniformFlowDoesNotChange)
{
  // At the side where it comes in there is no more of a streamline.
  static constexpr int dim = TypeParam::value;
  const Scene<dim>     scene(
    hanging_box<dim>(4, {"Periodic boundaries = bottom:top"}));
  const auto velocity = [](const dealii::Point<dim> &) {
    dealii::Tensor<1, dim> u;
    u[0] = 2.;
    u[1] = -1.;
    return u;
  };
  const auto nothing = [](const dealii::Point<dim> &) {
    return dealii::Tensor<1, dim>();
  };
  EXPECT_LT(error<dim>(scene, velocity, .3, nothing, 2.), 1e-12);
}
