// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/nodal_mass.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class NodalMassMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(NodalMassMpi, Dimensions);

  /// The nodal accelerations that forces rho f on each cell, at its nodes
  /// with the exact masses, give.
  template <int dim>
  Vector
  accelerations(const Scene<dim>                  &scene,
                const NodalMass<dim>              &mass,
                const typename Scene<dim>::Tensor &uniform)
  {
    Vector force;
    scene.space->initialize_velocity(force);
    for (unsigned int n = 0; n < force.locally_owned_size() / dim; ++n)
      for (unsigned int d = 0; d < dim; ++d)
        force.local_element(dim * n + d) =
          mass.lumped().local_element(n) * uniform[d];
    mass.accelerate(force, {}, nullptr);
    return force;
  }
} // namespace



TYPED_TEST(NodalMassMpi, UniformAccelerationsAreExactInAllCells)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(unit_box<dim>(4) + two_fluids(1000., 1.) +
                     section("Boundary conditions", {"Otherwise = no slip"}),
                   Meshes::distort_and_refine<dim>);
  scene.set_phases([](const auto &x) { return x[1] - .37 - .3 * x[0]; });
  NodalMass<dim> mass(*scene.space, *scene.boundary, *scene.phase);
  mass.update();
  dealii::Tensor<1, dim> a;
  a[0]                = 3.;
  a[dim - 1]          = -2.;
  const Vector result = accelerations(scene, mass, a);
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    EXPECT_LT((scene.at(result, n) - a).norm(), 1e-12) << x;
  });
}



TYPED_TEST(NodalMassMpi, TheSumOfTheMassesIsThatOfTheFluids)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + two_fluids(1000., 1.));
  scene.set_phases([](const auto &x) { return x[1] - .37; });
  NodalMass<dim> mass(*scene.space, *scene.boundary, *scene.phase);
  mass.update();
  EXPECT_NEAR(mass.lumped().mean_value() * mass.lumped().size(),
              370. + .63,
              1e-10);
}



TYPED_TEST(NodalMassMpi, BesideASurfaceAccelerationsAreNearlyThoseOfTheNodes)
{
  // Fluid of nearly all mass below a plane that passes a third above the
  // nodes of a row. The acceleration grows with the height; the force that
  // makes it is int N rho a.
  static constexpr int dim = TypeParam::value;
  constexpr double     h   = .125;
  const Scene<dim>     scene(unit_box<dim>(8) + two_fluids(1e6, 1.));
  scene.set_phases([](const auto &x) { return x[1] - 4. * h - h / 3.; });
  NodalMass<dim> mass(*scene.space, *scene.boundary, *scene.phase);
  mass.update();
  const auto field = [](const auto &x) {
    dealii::Tensor<1, dim> a;
    a[0] = std::sin(dealii::numbers::PI * x[0]) * x[1];
    return a;
  };
  // M a with the consistent mass matrix.
  const Vector exact = scene.velocity(field);
  Vector       force;
  scene.space->initialize_velocity(force);
  const auto &graph = scene.mesh.graph();
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      const int   cut   = scene.phase->cut_index(c);
      const auto &nodes = scene.space->nodes(c);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            double m = graph.cell(c).measure * scene.phase->fluid(c).density;
            for (unsigned int d = 0; d < dim; ++d)
              m *= ((i ^ j) >> d) & 1u ? 1. / 6. : 1. / 3.;
            if (cut >= 0)
              m = scene.phase->cut_cells()[cut].mass_matrix[i][j];
            for (unsigned int d = 0; d < dim; ++d)
              force.local_element(dim * nodes[i] + d) +=
                m * exact.local_element(dim * nodes[j] + d);
          }
    }
  scene.space->fold(force, dim);
  Vector lumped = force;
  mass.accelerate(force, {}, nullptr);
  double worst = 0, worst_lumped = 0;
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    if (std::abs(x[1] - 5. * h) > 1e-9)
      return;
    worst        = std::max(worst, (scene.at(force, n) - field(x)).norm());
    worst_lumped = std::max(
      worst_lumped,
      (scene.at(lumped, n) / mass.lumped().local_element(n) - field(x)).norm());
  });
  EXPECT_LT(max_of_all(worst), .6 * max_of_all(worst_lumped));
}
