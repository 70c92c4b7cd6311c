// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  /// The volume of the one cell of the unit box when its corners are moved.
  template <int dim>
  double
  measure(
    const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &change)
  {
    Scene<dim> scene(unit_box<dim>(1));
    Meshes::transform<dim>(scene.mesh, change);
    return scene.mesh.graph().n_owned_cells() > 0
             ? scene.mesh.graph().cell(0).measure
             : 0.;
  }
} // namespace



TEST(CellGraph, MeasuresQuadrilateralsExactly)
{
  // A trapezoid with parallel sides 1 and 1.5.
  const double offset = 16777216.;
  for (const double x : {0., offset})
    EXPECT_EQ(measure<2>([&](const dealii::Point<2> &p) {
                return dealii::Point<2>(x + p[0], -x + p[1] * (1. + .5 * p[0]));
              }),
              1.25);
}



TEST(CellGraph, MeasuresHexahedraExactly)
{
  // x = xi, y = eta (1 + xi / 2), z = zeta (1 + xi eta / 2), whose determinant
  // is (1 + xi / 2) (1 + xi eta / 2).
  const double exact = 1. + .25 + .125 + 1. / 24.;
  for (const double x : {0., 16777216.})
    EXPECT_NEAR(measure<3>([&](const dealii::Point<3> &p) {
                  return dealii::Point<3>(x + p[0],
                                          x + p[1] * (1. + .5 * p[0]),
                                          -x + p[2] * (1. + .5 * p[0] * p[1]));
                }),
                exact,
                1e-14);
}



TEST(CellGraph, BoxesAreBoxesWhateverTheDigitsOfTheirCorners)
{
  for (const double x : {0., 1000000.3, 5000001.5})
    {
      const std::string lower = std::to_string(x) + ", " + std::to_string(-x);
      const std::string upper =
        std::to_string(x + 1.) + ", " + std::to_string(.7 - x);
      const std::string levels =
        "if(x < " + std::to_string(x + .52) + ", 2, 0)";
      const Scene<2> scene(section("Geometry",
                                   {},
                                   section("box",
                                           {"Lower corner = " + lower,
                                            "Upper corner = " + upper,
                                            "Repetitions = 20, 14"})) +
                           section("Refinement", {"Local levels = " + levels}));
      EXPECT_TRUE(scene.mesh.graph().all_axis_parallel()) << x;
    }
}
