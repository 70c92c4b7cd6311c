// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "adaptation/adaptation.h"
#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/put_particle.h"

namespace
{
  using namespace AdaptationTest;
  using dealii::Point;
  using dealii::Tensor;

  template <typename T>
  struct CriteriaMpi : testing::Test
  {};
  TYPED_TEST_SUITE(CriteriaMpi, Dimensions);



  /// A disc or ball in the middle of the unit box.
  template <int dim>
  double
  ball(const Point<dim> &p)
  {
    return p.distance(center_of_box<dim>()) - .2;
  }



  /// The distance of a cell from the ball of radius .2, by its nearest point
  /// on a grid.
  template <int dim>
  double
  distance_from_ball(const std::array<Point<dim>, (1 << dim)> &corners)
  {
    double             nearest = 1e9;
    constexpr unsigned n       = 8;
    for (unsigned int i = 0; i < std::pow(n + 1, dim); ++i)
      {
        Point<dim>   x     = corners[0];
        unsigned int digit = i;
        for (unsigned int d = 0; d < dim; ++d, digit /= n + 1)
          x[d] += (corners.back()[d] - corners[0][d]) * (digit % (n + 1)) / n;
        nearest = std::min(nearest, std::abs(ball(x)));
      }
    return nearest;
  }



  /// Whether each cell's indicator is @p expected(cell's centre, its size).
  template <int dim, typename Expected>
  void
  expect_indicators(const State<dim>               &state,
                    const std::string              &name,
                    const std::vector<std::string> &settings,
                    const Expected                 &expected)
  {
    const auto wish = wishes(state, name, settings);
    for (unsigned int c = 0; c < wish.indicator.size(); ++c)
      {
        const auto &cell = state.mesh.graph().iterator(c);
        EXPECT_NEAR(wish.indicator[c],
                    expected(cell->center(), cell->extent_in_direction(0)),
                    1e-9)
          << name;
      }
  }
} // namespace



TYPED_TEST(CriteriaMpi, BandsAreWideAsAskedFor)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(dim == 2 ? 32 : 16));
  // Cut off as it is in a run.
  state.set(state.level_set, [](const auto &p) {
    return std::max(-.05, std::min(.05, ball(p)));
  });
  const auto   wish = wishes(state,
                           "interface distance",
                           {"Widths = 2, 8", "Levels below maximum = 0, 1"},
                           {0, 2});
  const double h    = (dim == 2 ? 1. / 32. : 1. / 16.) / 4.;
  unsigned int n[3] = {0, 0, 0};
  for (unsigned int c = 0; c < wish.at_least.size(); ++c)
    {
      const double d =
        distance_from_ball<dim>(state.mesh.graph().cell(c).vertices);
      ++n[wish.at_least[c]];
      // The boxes around the facets are at most a cell of this mesh wide.
      const double slack = 4. * h * std::sqrt(dim);
      const int highest  = d > 8. * h + slack ? 0 : d > 2. * h + slack ? 1 : 2;
      const int lowest   = d < 2. * h ? 2 : d < 8. * h ? 1 : 0;
      EXPECT_LE(wish.at_least[c], highest);
      EXPECT_GE(wish.at_least[c], lowest);
    }
  for (const unsigned int of_level : n)
    EXPECT_GT(dealii::Utilities::MPI::sum(of_level, MPI_COMM_WORLD), 0u);
}



TYPED_TEST(CriteriaMpi, BandsReachThroughPeriodicSides)
{
  constexpr int dim = TypeParam::value;
  State<dim> state(unit_box<dim>(8, "0", {"Periodic boundaries = left:right"}));
  state.set(state.level_set, [](const auto &p) { return p[0] - .06; });
  const auto wish =
    wishes(state, "interface distance", {"Widths = 1.6"}, {0, 1});
  for (unsigned int c = 0; c < wish.at_least.size(); ++c)
    {
      const double x = state.mesh.graph().iterator(c)->center()[0];
      EXPECT_EQ(wish.at_least[c], x < .25 || x > .875 ? 1 : 0) << x;
    }
}



TYPED_TEST(CriteriaMpi, BandsRunAheadOfTheInterface)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(16));
  state.set(state.level_set, [](const auto &p) { return p[0] - .22; });
  state.set(
    state.velocity, [](const auto &) { return 2.; }, dim, 0);
  const auto wish =
    wishes(state, "interface distance", {"Widths = 0"}, {0, 1}, .2);
  for (unsigned int c = 0; c < wish.at_least.size(); ++c)
    {
      const double x = state.mesh.graph().iterator(c)->center()[0];
      EXPECT_EQ(wish.at_least[c], x > .1875 && x < .625 ? 1 : 0) << x;
    }
}



TYPED_TEST(CriteriaMpi, AnInterfaceThatLeavesItsBandIsSeen)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(8, "if(x < 0.5, 1, 0)"));
  state.set(state.level_set, [](const auto &p) { return p[0] - .22; });
  state.set(
    state.velocity, [](const auto &) { return 1.; }, dim, 0);
  const Adaptation<dim> setup({"Criteria = interface distance",
                               "Maximum level = 1"},
                              section("interface distance", {"Widths = 1"}));
  EXPECT_FALSE(setup.adaptive.must_adapt(whole(state.view()), .2));
  EXPECT_TRUE(setup.adaptive.must_adapt(whole(state.view()), .3));
  state.set(
    state.velocity, [](const auto &) { return -1.; }, dim, 0);
  EXPECT_FALSE(setup.adaptive.must_adapt(whole(state.view()), .3));
}



TYPED_TEST(CriteriaMpi, VorticityAndGradients)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(hanging_box<dim>(4) + two_fluids(1000., 1.));
  // x y has the mean of its derivatives at the centre.
  state.set(
    state.velocity, [](const auto &p) { return p[0] * p[1]; }, dim, 0);
  state.set(
    state.velocity, [](const auto &p) { return 3. * p[0]; }, dim, 1);
  state.set(state.pressure, [](const auto &p) { return 7. * p[1]; });
  expect_indicators<dim>(state,
                         "vorticity",
                         {},
                         [](const auto &x, const double h) {
                           return std::abs(3. - x[0]) * h;
                         });
  expect_indicators<dim>(state,
                         "gradient",
                         {"Field = velocity"},
                         [](const auto &x, const double h) {
                           return h * std::sqrt(x[0] * x[0] + x[1] * x[1] + 9.);
                         });
  expect_indicators<dim>(state,
                         "gradient",
                         {"Field = pressure"},
                         [](const auto &, const double h) { return 7. * h; });
  expect_indicators<dim>(state,
                         "gradient",
                         {"Field = expression", "Expression = 2*x - y"},
                         [](const auto &, const double h) {
                           return std::sqrt(5.) * h;
                         });
  state.set(
    state.velocity, [](const auto &) { return 0.; }, dim, 1);
  state.set(
    state.velocity, [](const auto &p) { return 1. - p[0]; }, dim, 0);
  if (dim == 2)
    return;
  expect_indicators<dim>(state,
                         "vorticity",
                         {},
                         [](const auto &, const double) { return 0.; });
}



TYPED_TEST(CriteriaMpi, KineticEnergyIsThatOfEachFluid)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(4) + two_fluids(1000., 1.));
  state.set(state.level_set, [](const auto &p) { return p[0] - .6; });
  state.set(
    state.velocity, [](const auto &p) { return std::sqrt(p[1]); }, dim, 0);
  const auto wish = wishes(state, "gradient", {"Field = kinetic energy"});
  for (unsigned int c = 0; c < wish.indicator.size(); ++c)
    {
      const double x = state.mesh.graph().iterator(c)->center()[0];
      if (x < .5 || x > .75)
        {
          EXPECT_NEAR(wish.indicator[c], (x < .5 ? 500. : .5) / 4., 1e-9);
        }
    }
}



TYPED_TEST(CriteriaMpi, VelocityErrorIsWhereTheDerivativeJumps)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(8, "if(y > 0.5, 1, 0)"));
  state.set(
    state.velocity,
    [](const auto &p) { return p[1] + std::max(0., p[0] - .5); },
    dim,
    0);
  const auto wish = wishes(state, "velocity error", {});
  for (unsigned int c = 0; c < wish.indicator.size(); ++c)
    {
      const auto  &cell    = state.mesh.graph().iterator(c);
      const double x       = cell->center()[0];
      const double h       = cell->extent_in_direction(0);
      const bool   is_near = std::abs(x - .5) < h;
      // sqrt(diameter / 24 int [1]^2) over one face
      EXPECT_NEAR(wish.indicator[c],
                  is_near
                    ? std::sqrt(std::sqrt(dim) * h / 24. * std::pow(h, dim - 1))
                    : 0.,
                  1e-6);
    }
}



TYPED_TEST(CriteriaMpi, RegionsPrescribeLevels)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(4) + two_fluids(1000., 1.));
  state.set(state.level_set, [](const auto &p) { return p[1] - .5; });
  auto wish = wishes(state,
                     "region",
                     {"At least = if(x < 0.5, 3, 1)", "At most = 4 + t"});
  for (unsigned int c = 0; c < wish.at_least.size(); ++c)
    {
      const auto x = state.mesh.graph().iterator(c)->center();
      EXPECT_EQ(wish.at_least[c], x[0] < .5 ? 3 : 1);
      EXPECT_EQ(wish.at_most[c], 4);
    }
  const std::string name = state.fluids[1].name;
  wish = wishes(state, "region", {"At most = 2", "Fluid = " + name});
  for (unsigned int c = 0; c < wish.at_least.size(); ++c)
    EXPECT_EQ(wish.at_most[c],
              state.mesh.graph().iterator(c)->center()[1] > .5 - .25 ? 2 : 255);
  EXPECT_NE(complaint_of([&]() { wishes(state, "region", {"Fluid = oil"}); }),
            "");
}



TYPED_TEST(CriteriaMpi, ParticlesNeedCells)
{
  constexpr int dim = TypeParam::value;
  State<dim>    state(unit_box<dim>(4, "1"));
  EXPECT_EQ(wishes(state, "particle need", {}).at_most,
            std::vector<unsigned char>(state.mesh.graph().n_owned_cells(),
                                       255));
  // Three in each cell left of the middle, two of them in one sub-cell, and
  // nothing to the right.
  const auto &graph = state.mesh.graph();
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    if (graph.iterator(c)->center()[0] < .5)
      for (const double at : {.2, .3, .7})
        {
          Point<dim> xi;
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = at;
          put_particle(*state.population, c, xi);
        }
  const double part = 1. - 2. / (1 << dim);
  for (const double limit : {part - .01, part + .01})
    {
      const auto wish = wishes(state,
                               "particle need",
                               {"Particles per cell = 6",
                                "Empty part = " + std::to_string(limit)});
      for (unsigned int c = 0; c < wish.at_least.size(); ++c)
        {
          const bool has_some = graph.iterator(c)->center()[0] < .5;
          EXPECT_EQ(wish.indicator[c], has_some ? .5 : 0.);
          EXPECT_EQ(wish.at_most[c], has_some && limit > part ? 255 : 0);
        }
    }
}
