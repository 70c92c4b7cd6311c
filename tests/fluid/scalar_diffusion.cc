// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/scalar_diffusion.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/irregular_mesh.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class ScalarDiffusionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(ScalarDiffusionMpi, Dimensions);

  using Material = std::array<double, 2>;

  /// A scalar on a scene.
  template <int dim>
  struct Warmth
  {
    Warmth(const Scene<dim>                &scene,
           const ScalarConditionParameters &parameters,
           const Material                  &capacity,
           const Material                  &conductivity,
           dealii::Function<dim>           *source = nullptr)
      : scene(scene)
      , conditions(parameters, scene.mesh, "Boundary conditions")
      , diffusion(*scene.space, conditions, source, 1e-13)
    {
      diffusion.update(*scene.phase, capacity, conductivity);
    }

    void
    advance(Vector &s, const double time, const double dt, const unsigned int n)
    {
      for (unsigned int i = 0; i < n; ++i)
        diffusion.advance(s, time + i * dt, dt, supply);
    }

    double
    supplied() const
    {
      return sum_of_all(supply.total());
    }

    const Scene<dim>     &scene;
    ScalarConditions<dim> conditions;
    ScalarDiffusion<dim>  diffusion;
    ScalarSupply          supply;
  };


  /// The greatest difference from a function at the nodes.
  template <int dim, typename Function>
  double
  error(const Scene<dim> &scene, const Vector &s, const Function &exact)
  {
    double largest = 0.;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      largest = std::max(largest, std::abs(s.local_element(n) - exact(x)));
    });
    return max_of_all(largest);
  }


  template <int dim>
  std::unique_ptr<Scene<dim>>
  one_fluid_scene(const std::string &mesh)
  {
    auto scene = std::make_unique<Scene<dim>>(mesh + one_fluid(1., 1.),
                                              Meshes::distort_and_refine<dim>);
    scene->set_phases([](const auto &) { return -1.; });
    return scene;
  }
} // namespace



TYPED_TEST(ScalarDiffusionMpi, PlanesStayOnAnyMesh)
{
  constexpr int dim   = TypeParam::value;
  auto          scene = one_fluid_scene<dim>(unit_box<dim>(4));
  const auto    plane = [](const auto &x) { return 290. + 3. * x[0]; };
  ScalarConditionParameters given;
  given.value = "left: 290";
  given.flux  = "right: 6";
  Warmth<dim> warmth(*scene, given, {{5., 5.}}, {{2., 2.}});
  Vector      s = scene->scalar(plane);
  warmth.advance(s, 0., .1, 3);
  EXPECT_LT(error(*scene, s, plane), 1e-10);
  EXPECT_NEAR(warmth.supplied(), 0., 1e-9);
  for (const auto &[id, nodes] : warmth.diffusion.fluxes(s, 0.))
    for (const auto &[flux, area] : nodes)
      EXPECT_NEAR(flux, 6., 1e-9);
}



TYPED_TEST(ScalarDiffusionMpi, WhatIsUniformStaysToTheLastBit)
{
  constexpr int dim   = TypeParam::value;
  auto          scene = one_fluid_scene<dim>(unit_box<dim>(3));
  Warmth<dim>   warmth(*scene, {}, {{5., 5.}}, {{2., 2.}});
  Vector        s = scene->scalar([](const auto &) { return 293.15; });
  warmth.advance(s, 0., 10., 3);
  EXPECT_EQ(error(*scene, s, [](const auto &) { return 293.15; }), 0.);
}



TYPED_TEST(ScalarDiffusionMpi, TheBooksOfAllConditionsBalance)
{
  constexpr int             dim   = TypeParam::value;
  auto                      scene = one_fluid_scene<dim>(unit_box<dim>(4));
  ScalarConditionParameters given;
  given.value    = "left: 1+y*y+t";
  given.flux     = "right: sin(y)*t";
  given.exchange = "top: 3*(1+t); 2";
  dealii::Functions::ConstantFunction<dim> source(.7);
  Warmth<dim>  warmth(*scene, given, {{5., 5.}}, {{2., 2.}}, &source);
  Vector       s = scene->scalar([](const auto &x) { return x[0] - x[1]; });
  const double before = warmth.diffusion.content(s);
  warmth.advance(s, 0., .2, 4);
  EXPECT_NEAR(warmth.diffusion.content(s) - before, warmth.supplied(), 1e-10);
  EXPECT_NEAR(sum_of_all(warmth.supply.source), .7 * .8, 1e-12);
  EXPECT_GT(std::abs(warmth.supplied()), .1);
}



TEST(ScalarDiffusion, IsOfSecondOrderInTimeAndDampsWhatIsRough)
{
  Scene<2> scene(unit_box<2>(16) + one_fluid(1., 1.));
  scene.set_phases([](const auto &) { return -1.; });
  Warmth<2>  warmth(scene, {}, {{1., 1.}}, {{.1, .1}});
  const auto wave = [](const auto &x) { return std::cos(M_PI * x[0]); };
  const auto at   = [&](const unsigned int n) {
    Vector s = scene.scalar(wave);
    warmth.advance(s, 0., 1. / n, n);
    return s.local_element(0);
  };
  const double exact = at(256);
  EXPECT_NEAR(at(256), std::exp(-.1 * M_PI * M_PI), 2e-3);
  EXPECT_GT(std::log2((at(4) - exact) / (at(8) - exact)), 1.9);

  // One long step leaves nothing of a single hot node but its mean.
  Vector s = scene.scalar([](const auto &x) {
    return std::abs(x[0] - .5) + std::abs(x[1] - .5) < 1e-6 ? 1. : 0.;
  });
  warmth.advance(s, 0., 1e4, 1);
  EXPECT_LT(error(scene, s, [](const auto &) { return 1. / 256.; }), 1e-4);
}



TYPED_TEST(ScalarDiffusionMpi, LayersOfTwoFluidsAreExact)
{
  // Conductivities 1000:1; the interface lies within cells. In steady state
  // the flux is everywhere the same, and the nodes are on two straight lines.
  constexpr int dim = TypeParam::value;
  const double  at = .43, k[] = {1., 1e-3};
  Scene<dim>    scene(unit_box<dim>(8));
  scene.set_phases([&](const auto &x) { return x[0] - at; });
  ScalarConditionParameters given;
  given.value = "left: 1 | right: 0";
  Warmth<dim>  warmth(scene, given, {{1., 4.}}, {{k[0], k[1]}});
  const double flux = 1. / (at / k[0] + (1. - at) / k[1]);
  Vector       s    = scene.scalar([](const auto &) { return .5; });
  warmth.advance(s, 0., 1e7, 3);
  EXPECT_LT(error(scene,
                  s,
                  [&](const auto &x) {
                    return x[0] < at ? 1. - flux / k[0] * x[0]
                                     : flux / k[1] * (1. - x[0]);
                  }),
            1e-8);
}



TEST(ScalarDiffusion, TiltedLayersConverge)
{
  // s = (n . x - a) / k on both sides of a plane at an angle.
  const double               a = .74, k[] = {1., 10.};
  const dealii::Tensor<1, 2> normal(dealii::Point<2>(.8, .6));
  const auto                 exact = [&](const auto &x) {
    const double d = normal * (x - dealii::Point<2>()) - a;
    return d / k[d < 0 ? 0 : 1];
  };
  ScalarConditionParameters given;
  const std::string         d = "(0.8*x+0.6*y-0.74)";
  given.value = on_all_sides<2>("if(" + d + "<0, " + d + ", " + d + "/10)");
  double errors[2];
  for (const unsigned int i : {0, 1})
    {
      Scene<2> scene(unit_box<2>(i == 0 ? 16 : 32));
      scene.set_phases(
        [&](const auto &x) { return normal * (x - dealii::Point<2>()) - a; });
      Warmth<2> warmth(scene, given, {{1., 1.}}, {{k[0], k[1]}});
      Vector    s = scene.scalar(exact);
      warmth.advance(s, 0., 1e6, 3);
      double sum = 0.;
      scene.for_each_node([&](const unsigned int n, const auto &x) {
        sum += std::pow(s.local_element(n) - exact(x), 2);
      });
      errors[i] = std::sqrt(sum) / (i == 0 ? 16. : 32.);
    }
  // Of first order: a laminate in cut cells is that.
  EXPECT_GT(std::log2(errors[0] / errors[1]), .9);
  EXPECT_LT(errors[1], 2e-3);
}
