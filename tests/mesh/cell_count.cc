// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/cell_count.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <gtest/gtest.h>

#include "made_geometry.h"
#include "support/complaint.h"

using namespace Thalweg;

namespace
{
  /// Two levels more on the left of x = 0.5.
  template <int dim>
  class Left : public dealii::Function<dim>
  {
  public:
    double
    value(const dealii::Point<dim> &x, const unsigned int) const override
    {
      return x[0] < .5 ? 2. : 0.;
    }
  };


  template <int dim>
  double
  count(const unsigned int           levels,
        const dealii::Function<dim> &local,
        const double                 most = 1e9)
  {
    dealii::Triangulation<dim> box;
    dealii::GridGenerator::subdivided_hyper_cube(box, 2);
    return count_cells(box, levels, local, false, most);
  }


  /// How many cells a geometry says that it has, over those that it makes.
  template <int dim>
  double
  estimated(const std::string &model, const std::string &settings)
  {
    Made<dim>    made(model, settings);
    const double n = made.geometry->n_cells();
    made.create();
    return n / made.mesh.n_active_cells();
  }
} // namespace


TEST(CellCount, CountsWithoutRefining)
{
  EXPECT_EQ(count<2>(0, Left<2>()), 2 * 16 + 2);
  EXPECT_EQ(count<3>(1, Left<3>()), 4 * 512 + 4 * 8);
  EXPECT_EQ(count<2>(3, dealii::Functions::ZeroFunction<2>()), 4 * 64);
  EXPECT_EQ(count<2>(1, dealii::Functions::ConstantFunction<2>(-5.)), 4);
}


TEST(CellCount, StopsWhereItIsTooMuch)
{
  const double n = count<2>(20, dealii::Functions::ZeroFunction<2>(), 100.);
  EXPECT_GT(n, 100.);
  EXPECT_LT(n, 200.);
}


TEST(CellCount, ConstantLevelsAreNotCounted)
{
  dealii::Triangulation<2> box;
  dealii::GridGenerator::subdivided_hyper_cube(box, 2);
  EXPECT_EQ(
    count_cells(box, 18, dealii::Functions::ConstantFunction<2>(2.), true, 1e9),
    4. * std::pow(2., 40));
}


TEST(CellCount, RefusesLevelsThatDoNotExist)
{
  EXPECT_NE(complaint_of([]() {
              count<3>(2, dealii::Functions::ConstantFunction<3>(1e300));
            }).find("(0.25 0.25 0.25) 1e+300 times. It must be at the most 18"),
            std::string::npos);
}


TEST(CellCount, GeometriesKnowHowMany)
{
  EXPECT_EQ(estimated<3>("box", "Repetitions = 2, 3, 4"), 1.);
  EXPECT_EQ(estimated<2>("cavity", "Repetitions = 2, 3"), 1.);
  for (const double ratio :
       {estimated<2>("box with obstacles",
                     "Cell size = 0.1\nObstacles = 0.3, 0 : 0.4, 0.1"),
        estimated<2>("backward step", ""),
        estimated<3>("backward step", ""),
        estimated<2>("cylinder in channel", ""),
        estimated<3>("cylinder in channel", ""),
        estimated<2>("airfoil", ""),
        estimated<3>("airfoil", "")})
    {
      EXPECT_GT(ratio, .8);
      EXPECT_LT(ratio, 1.25);
    }
}
