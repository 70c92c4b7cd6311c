// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "adaptation/adaptation.h"
#include "support/complaint.h"
#include "support/dimensions.h"

namespace
{
  using namespace AdaptationTest;
  using dealii::Point;

  template <typename T>
  struct AdaptiveRefinementMpi : testing::Test
  {};
  TYPED_TEST_SUITE(AdaptiveRefinementMpi, Dimensions);



  /// A ball around a place on a line through the unit box, which goes on
  /// periodically.
  template <int dim>
  typename Scene<dim>::Scalar
  ball_at(const double x)
  {
    return [x](const Point<dim> &p) {
      double squares = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double way = std::abs(p[d] - (d == 0 ? x : .5));
          squares += std::pow(std::min(way, 1. - way), 2);
        }
      return std::sqrt(squares) - .2;
    };
  }



  /// Layers at the top and at the bottom.
  double
  shear(const double y)
  {
    return std::tanh(30. * (std::abs(y - .5) - .3));
  }



  /// The numbers of all cells, of those with flags for refinement, and of
  /// those with flags for coarsening.
  template <int dim>
  std::vector<double>
  count_flags(const Thalweg::Mesh<dim> &mesh)
  {
    std::vector<double> n(3, 0.);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          n[0] += 1.;
          n[1] += cell->refine_flag_set() ? 1. : 0.;
          n[2] += cell->coarsen_flag_set() ? 1. : 0.;
        }
    dealii::Utilities::MPI::sum(n, mesh.triangulation().get_communicator(), n);
    return n;
  }



  const std::string two_bands =
    section("interface distance",
            {"Widths = 1, 4", "Levels below maximum = 0, 1"});



  /// Lets the mesh follow a ball that jumps on by a part of its radius, and
  /// a layer of shear; returns the mesh's fingerprints.
  template <int dim>
  std::vector<std::uint64_t>
  follow(const MPI_Comm                  communicator,
         const std::string              &strategy,
         const std::vector<std::string> &geometry)
  {
    World<dim>            world(communicator,
                     unit_box<dim>(2, dim == 2 ? "2" : "1", geometry));
    const Adaptation<dim> setup({"Criteria = interface distance, vorticity",
                                 "Minimum level = 1",
                                 "Maximum level = " +
                                   std::to_string(dim == 2 ? 5 : 3),
                                 "Target number of cells = 300",
                                 "Refinement threshold = 0.3",
                                 "Coarsening threshold = 0.1",
                                 "Strategy = " + strategy},
                                two_bands);
    std::vector<std::uint64_t> fingerprints;
    for (unsigned int i = 0; i < (dim == 2 ? 6 : 3); ++i)
      {
        world.set(ball_at<dim>(.2 + .1 * i),
                  [](const auto &p) { return shear(p[1]); });
        setup.adaptive.mark(world.mesh, world.view());
        const auto before = count_flags(world.mesh);
        world.change_mesh();
        fingerprints.push_back(world.fingerprint());
        // Nobody has changed the flags while they were carried out.
        EXPECT_EQ(count_flags(world.mesh)[0],
                  before[0] + ((1 << dim) - 1) * before[1] -
                    before[2] * (1. - 1. / (1 << dim)));
      }
    return fingerprints;
  }
} // namespace



TYPED_TEST(AdaptiveRefinementMpi, ProcessesDecideAsOneAlone)
{
  constexpr int            dim = TypeParam::value;
  std::vector<std::string> strategies{"fraction of error",
                                      "target number of cells"};
  if (dim == 2)
    strategies.insert(strategies.end(), {"fraction of cells", "threshold"});
  for (const std::string &strategy : strategies)
    EXPECT_EQ(follow<dim>(MPI_COMM_WORLD, strategy, {}),
              follow<dim>(MPI_COMM_SELF, strategy, {}))
      << strategy;
}



TYPED_TEST(AdaptiveRefinementMpi, AlsoAcrossPeriodicSides)
{
  constexpr int                  dim = TypeParam::value;
  const std::vector<std::string> geometry{
    "Periodic boundaries = left:right, bottom:top"};
  EXPECT_EQ(follow<dim>(MPI_COMM_WORLD, "fraction of error", geometry),
            follow<dim>(MPI_COMM_SELF, "fraction of error", geometry));
}



TYPED_TEST(AdaptiveRefinementMpi, BandsComeToRest)
{
  constexpr int         dim = TypeParam::value;
  World<dim>            world(MPI_COMM_WORLD, unit_box<dim>(2, "1"));
  const Adaptation<dim> setup({"Criteria = interface distance",
                               "Maximum level = " +
                                 std::to_string(dim == 2 ? 6 : 3)},
                              two_bands);
  const auto            set = [&]() {
    world.set(ball_at<dim>(.45), [](const auto &) { return 0.; });
  };
  set();
  EXPECT_TRUE(setup.adaptive.must_adapt(world.view(), 0.));
  for (unsigned int i = 0; i < setup.adaptive.initial_adaptations() + 2; ++i)
    {
      setup.adaptive.mark(world.mesh, world.view());
      world.change_mesh();
      set();
    }
  EXPECT_FALSE(setup.adaptive.mark(world.mesh, world.view()));
  EXPECT_FALSE(setup.adaptive.must_adapt(world.view(), 0.));
  const auto  &graph = world.mesh.graph();
  unsigned int n_cut = 0, n_fine = 0;
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      const bool is_fine = graph.iterator(c)->level() == (dim == 2 ? 6 : 3);
      n_fine += is_fine;
      const auto phi =
        Thalweg::gather<dim>(world.level_set, world.space->nodes(c));
      if (*std::min_element(phi.begin(), phi.end()) < 0. &&
          *std::max_element(phi.begin(), phi.end()) > 0.)
        {
          ++n_cut;
          EXPECT_TRUE(is_fine);
        }
    }
  n_cut  = dealii::Utilities::MPI::sum(n_cut, MPI_COMM_WORLD);
  n_fine = dealii::Utilities::MPI::sum(n_fine, MPI_COMM_WORLD);
  EXPECT_GT(n_cut, 0u);
  // One cell on each side, and what completes families.
  EXPECT_LT(n_fine, 8u * n_cut);
}



TYPED_TEST(AdaptiveRefinementMpi, ABandOnCurvedCellsComesToRest)
{
  constexpr int         dim = TypeParam::value;
  World<dim>            world(MPI_COMM_WORLD, unit_box<dim>(4, "1"));
  const Adaptation<dim> setup({"Criteria = interface distance",
                               "Maximum level = 3"},
                              two_bands);
  Meshes::distort(world.mesh, .08);
  world.make_space();
  const auto set = [&]() {
    world.set(ball_at<dim>(.45), [](const auto &) { return 0.; });
  };
  for (unsigned int i = 0; i < 5; ++i)
    {
      set();
      setup.adaptive.mark(world.mesh, world.view());
      world.change_mesh();
    }
  set();
  EXPECT_FALSE(setup.adaptive.mark(world.mesh, world.view()));
}



TYPED_TEST(AdaptiveRefinementMpi, WhatMustBeFineWinsAndLevelsAreBounded)
{
  constexpr int         dim = TypeParam::value;
  World<dim>            world(MPI_COMM_WORLD, unit_box<dim>(4, "1"));
  const Adaptation<dim> setup({"Criteria = region, interface distance",
                               "Minimum level = 1",
                               "Maximum level = 2"},
                              section("interface distance", {"Widths = 0"}) +
                                section("region",
                                        {"At most = 0", "At least = 0"}));
  world.set([](const auto &p) { return p[0] - .3; },
            [](const auto &) { return 0.; });
  EXPECT_TRUE(setup.adaptive.mark(world.mesh, world.view()));
  for (const auto &cell : world.mesh.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const double x = cell->center()[0];
        EXPECT_EQ(bool(cell->refine_flag_set()), x > .25 && x < .375);
        EXPECT_FALSE(cell->coarsen_flag_set());
      }
}



TYPED_TEST(AdaptiveRefinementMpi, WeightsDecideBetweenCriteria)
{
  constexpr int dim = TypeParam::value;
  for (const std::string combination : {"maximum", "weighted sum"})
    {
      World<dim>            world(MPI_COMM_WORLD, unit_box<dim>(4, "0"));
      const Adaptation<dim> setup(
        {"Criteria = gradient, vorticity",
         "Maximum level = 1",
         "Strategy = threshold",
         "Refinement threshold = 1.2",
         "Combination = " + combination},
        section("gradient",
                {"Field = expression", "Expression = 4*x", "Weight = 1"}) +
          section("vorticity", {"Weight = 2"}));
      // Vorticity 2 above the middle, times h = 1/4 times the weight: 1.
      world.set([](const auto &) { return -1.; },
                [](const auto &p) { return 2. * std::max(0., p[1] - .5); });
      setup.adaptive.mark(world.mesh, world.view());
      for (const auto &cell :
           world.mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            EXPECT_EQ(bool(cell->refine_flag_set()),
                      combination == "weighted sum" && cell->center()[1] > .5);
          }
    }
}



TEST(AdaptiveRefinement, RefusesWhatMakesNoSense)
{
  const auto complaint = [](const std::vector<std::string> &settings,
                            const std::string              &sub    = "",
                            const std::string              &fluids = "") {
    const Adaptation<2> setup(settings, sub);
    const World<2>      world(MPI_COMM_SELF, unit_box<2>(2) + fluids);
    return complaint_of([&]() {
      setup.adaptive.check(
        whole(Thalweg::FlowOutline<2>{world.mesh, world.fluids}));
    });
  };
  const std::string distance = "Criteria = interface distance";
  EXPECT_EQ(complaint({}), "");
  EXPECT_EQ(complaint({distance, "Maximum level = 3"}), "");
  EXPECT_NE(complaint({distance}).find("above the minimum"), std::string::npos);
  EXPECT_NE(complaint({distance, "Maximum level = 3"}, "", one_fluid(1., 1.))
              .find("two fluids"),
            std::string::npos);
  EXPECT_NE(complaint({distance, "Maximum level = 3"},
                      section("interface distance", {"Widths = 1, 2"}))
              .find("2 'Widths'"),
            std::string::npos);
  EXPECT_NE(complaint({distance, "Maximum level = 1"},
                      section("interface distance",
                              {"Levels below maximum = 2"}))
              .find("below the minimum level"),
            std::string::npos);
  EXPECT_NE(complaint({"Criteria = region", "Maximum level = 1"},
                      section("region", {"At least = x +"})),
            "");
}



TEST(AdaptiveRefinement, IsDueAtIntervals)
{
  const Adaptation<2> setup({"Criteria = vorticity", "Interval = 3"});
  EXPECT_FALSE(setup.adaptive.is_due(0));
  EXPECT_FALSE(setup.adaptive.is_due(2));
  EXPECT_TRUE(setup.adaptive.is_due(3));
  EXPECT_TRUE(setup.adaptive.is_due(6));
  EXPECT_FALSE(Adaptation<2>({}).adaptive.is_due(5));
}
