// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "support/dimensions.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class PhaseFieldMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(PhaseFieldMpi, Dimensions);

  /// Twice the height above 0.45.
  template <int dim>
  double
  steep(const dealii::Point<dim> &p)
  {
    return 2. * (p[1] - .45);
  }


  /// A ball's distance.
  template <int dim>
  double
  ball(const dealii::Point<dim> &p)
  {
    dealii::Point<dim> center;
    for (unsigned int d = 0; d < dim; ++d)
      center[d] = .5;
    return p.distance(center) - .3;
  }
} // namespace



TYPED_TEST(PhaseFieldMpi, AShiftGivesTheVolumeThatIsAskedFor)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(hanging_box<dim>(8));
  scene.phase->target_volume = .48;
  scene.phase->rebuild(scene.scalar(steep<dim>));
  EXPECT_NEAR(scene.phase->volume_before_shift(), .45, 1e-12);
  EXPECT_NEAR(scene.phase->volume(), .48, 1e-12);
  EXPECT_NEAR(scene.phase->total_volume(), 1., 1e-12);
  // The level set is a distance by then, also across hanging nodes.
  EXPECT_NEAR(scene.phase->shift(), -.03, 1e-12);
}



TYPED_TEST(PhaseFieldMpi, CurvedInterfacesGetTheirVolumeToo)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(hanging_box<dim>(8));
  for (const double target : {.02, .11, .3})
    {
      scene.phase->target_volume = target;
      scene.phase->rebuild(scene.scalar(ball<dim>));
      EXPECT_NEAR(scene.phase->volume(), target, 1e-12);
    }
}



TYPED_TEST(PhaseFieldMpi, WithoutHoldingTheVolumeNothingIsShifted)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(8) +
                         section("Interface", {"Hold volume = false"}));
  scene.phase->target_volume = .48;
  scene.phase->rebuild(scene.scalar(steep<dim>));
  EXPECT_NEAR(scene.phase->volume(), .45, 1e-12);
  EXPECT_EQ(scene.phase->shift(), 0.);
}



TYPED_TEST(PhaseFieldMpi, CellsAreCutWhereTheLevelSetChangesSign)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(8));
  scene.set_phases(ball<dim>);
  const auto &graph = scene.mesh.graph();
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      double least = 1., most = -1.;
      for (const auto &vertex : graph.cell(c).vertices)
        {
          least = std::min(least, ball<dim>(vertex));
          most  = std::max(most, ball<dim>(vertex));
        }
      const int index = scene.phase->cut_index(c);
      EXPECT_EQ(index >= 0, least < 0 && most > 0);
      if (index >= 0)
        EXPECT_EQ(scene.phase->cut_cells()[index].cell, c);
      else
        EXPECT_EQ(&scene.phase->fluid(c), &scene.fluids[least < 0 ? 0 : 1]);
    }
}



TYPED_TEST(PhaseFieldMpi, RoundOffPutsNodesOnNoSideOfTheInterface)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(8));
  scene.set_phases([](const auto &p) {
    return p[1] - .5 + 1e-13 * std::sin(1e3 * (p[0] + p[dim - 1]));
  });
  scene.for_each_node([&](const unsigned int n, const auto &x) {
    if (std::abs(x[1] - .5) < 1e-6)
      EXPECT_EQ(scene.phase->level_set().local_element(n), 0.) << x;
  });
  EXPECT_TRUE(scene.phase->cut_cells().empty());
}



TYPED_TEST(PhaseFieldMpi, OneFluidFillsEverything)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + one_fluid(1., 0.));
  scene.set_phases([](const auto &) { return 1.; });
  EXPECT_NEAR(scene.phase->volume(), 1., 1e-12);
  EXPECT_TRUE(scene.phase->cut_cells().empty());
}
