// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/load_balance.h>

#include <gtest/gtest.h>

#include "adaptation/adaptation.h"
#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/put_particle.h"

namespace
{
  using namespace AdaptationTest;
  using dealii::Point;
  using Thalweg::LoadBalance;
  using Thalweg::Compat::CellFate;

  template <typename T>
  struct LoadBalanceMpi : testing::Test
  {};
  TYPED_TEST_SUITE(LoadBalanceMpi, Dimensions);



  template <int dim>
  struct Balance
  {
    explicit Balance(const std::vector<std::string> &settings)
    {
      balance.declare_parameters(Thalweg::Section(prm));
      prm.parse_input_from_string(section("Load balance", settings));
      balance.check();
    }

    dealii::ParameterHandler prm;
    LoadBalance<dim>         balance;
  };



  /// Puts @p n particles into the middle of each cell where @p is_there.
  template <int dim>
  void
  fill(World<dim>                                    &world,
       const unsigned int                             n,
       const std::function<bool(const Point<dim> &)> &is_there)
  {
    const auto &graph = world.mesh.graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      if (is_there(graph.iterator(c)->center()))
        for (unsigned int k = 0; k < n; ++k)
          put_particle(*world.population, c, center_of_box<dim>());
  }



  template <int dim>
  bool
  left_half(const Point<dim> &p)
  {
    return p[0] < .5;
  }



  const std::vector<std::string> weights{"Weight of a cell = 1",
                                         "Weight of a particle = 0.5",
                                         "Weight of a cut cell = 3"};
} // namespace



TYPED_TEST(LoadBalanceMpi, WeightsFollowTheCells)
{
  constexpr int dim = TypeParam::value;
  World<dim>    world(MPI_COMM_WORLD, unit_box<dim>(4, "1"));
  world.set([](const auto &p) { return p[0] - .1; },
            [](const auto &) { return 0.; });
  fill<dim>(world, 8, left_half<dim>);
  Balance<dim> own(weights);
  own.balance.count(world.view());
  constexpr double n_children = 1 << dim;
  const auto      &graph      = world.mesh.graph();
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      const auto  &cell        = graph.iterator(c);
      const double x           = cell->center()[0];
      const double n_particles = x < .5 ? 8. : 0.;
      const double cut         = x < .125 ? 3. : 0.;
      EXPECT_EQ(own.balance.weight(cell, CellFate::persists),
                1000. * (1. + .5 * n_particles + cut));
      EXPECT_EQ(own.balance.weight(cell, CellFate::is_refined),
                1000. * (1. + .5 * n_particles / n_children + .5 * cut));
      bool is_family_here = true;
      for (unsigned int k = 0; k < n_children; ++k)
        is_family_here =
          is_family_here && cell->parent()->child(k)->is_locally_owned();
      EXPECT_TRUE(is_family_here);
      EXPECT_EQ(own.balance.weight(cell->parent(), CellFate::is_coarsened),
                1000. * (1. + .5 * n_particles * n_children +
                         (cell->parent()->center()[0] < .25 ? 3. : 0.)));
    }
}



TYPED_TEST(LoadBalanceMpi, RefinedAndCoarsenedCellsKeepTheirWork)
{
  constexpr int dim = TypeParam::value;
  World<dim>    world(MPI_COMM_WORLD, unit_box<dim>(4, "1"));
  world.set([](const auto &) { return 1.; }, [](const auto &) { return 0.; });
  fill<dim>(world, 8, left_half<dim>);
  Balance<dim> own(weights);
  own.balance.count(world.view());
  double     sum = 0.;
  const auto connection =
    Thalweg::Compat::connect_weight(world.mesh.triangulation(),
                                    [&](const auto &cell, const CellFate fate) {
                                      const unsigned int weight =
                                        own.balance.weight(cell, fate);
                                      sum += weight;
                                      return weight;
                                    });
  double n_changed[2] = {0., 0.};
  for (const auto &cell : world.mesh.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        if (cell->center()[0] < .25)
          {
            cell->set_refine_flag();
            ++n_changed[0];
          }
        else if (cell->center()[0] > .5)
          {
            cell->set_coarsen_flag();
            ++n_changed[1];
          }
      }
  const double n_before = world.mesh.triangulation().n_global_active_cells();
  world.population->clear();
  world.mesh.triangulation().execute_coarsening_and_refinement();
  connection.disconnect();
  const double n_after = world.mesh.triangulation().n_global_active_cells();
  EXPECT_EQ(n_after,
            n_before + ((1 << dim) - 1) * sum_of_all(n_changed[0]) -
              (1. - 1. / (1 << dim)) * sum_of_all(n_changed[1]));
  EXPECT_EQ(sum_of_all(sum), 1000. * (n_after + .5 * 8. * n_before / 2.));
}



TYPED_TEST(LoadBalanceMpi, DistributesParticlesEvenly)
{
  constexpr int dim = TypeParam::value;
  World<dim>    world(MPI_COMM_WORLD, unit_box<dim>(4, dim == 2 ? "3" : "2"));
  const auto    set = [&]() {
    world.make_space();
    world.set([](const auto &) { return 1.; }, [](const auto &) { return 0.; });
  };
  set();
  fill<dim>(world, 10, [](const auto &p) { return p.norm() < .4; });
  Balance<dim> own(
    {"Weight of a particle = 1", "Threshold = 1.2", "Interval = 2"});
  const auto         before = own.balance.imbalance(world.view());
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  EXPECT_NEAR(before.cells, 1., .1);
  EXPECT_EQ(before.cut_cells, 1.);
  EXPECT_EQ(own.balance.is_due(world.view(), 2), n_ranks > 1);
  EXPECT_FALSE(own.balance.is_due(world.view(), 1));

  own.balance.count(world.view());
  const auto connection =
    Thalweg::Compat::connect_weight(world.mesh.triangulation(),
                                    [&](const auto &cell, const CellFate fate) {
                                      return own.balance.weight(cell, fate);
                                    });
  world.population->clear();
  world.mesh.repartition();
  connection.disconnect();
  world.mesh.update();
  set();
  fill<dim>(world, 10, [](const auto &p) { return p.norm() < .4; });
  const auto after = own.balance.imbalance(world.view());
  EXPECT_LT(after.total, 1.15);
  EXPECT_FALSE(own.balance.is_due(world.view(), 4));
  if (n_ranks > 1)
    {
      EXPECT_GT(before.total, 1.2);
      EXPECT_GT(after.cells, 1.05);
    }
}



TYPED_TEST(LoadBalanceMpi, HugeWeightsDoNotOverflow)
{
  constexpr int dim = TypeParam::value;
  World<dim>    world(MPI_COMM_WORLD, unit_box<dim>(4, "1"));
  world.set([](const auto &) { return 1.; }, [](const auto &) { return 0.; });
  fill<dim>(world, 50, left_half<dim>);
  Balance<dim> own({"Weight of a particle = 1e12"});
  own.balance.count(world.view());
  const double largest = std::numeric_limits<int>::max();
  const auto  &graph   = world.mesh.graph();
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      const auto  &cell = graph.iterator(c);
      const double parent =
        own.balance.weight(cell->parent(), CellFate::is_coarsened);
      EXPECT_LE(parent, largest);
      EXPECT_GE(parent, 1.);
      if (cell->center()[0] < .5)
        {
          EXPECT_NEAR(parent / own.balance.weight(cell, CellFate::persists),
                      1 << dim,
                      1e-3);
        }
    }
}



TEST(LoadBalance, RefusesCellsWithoutWork)
{
  EXPECT_NE(complaint_of([]() {
              Balance<2>({"Weight of a cell = 0", "Weight of a particle = 0"});
            }),
            "");
}
