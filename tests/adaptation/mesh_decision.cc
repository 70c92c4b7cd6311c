// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/mesh_decision.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace
{
  using Thalweg::CellWishes;
  using Thalweg::decide;
  using Thalweg::DecisionParameters;
  using Thalweg::MarkingStrategy;

  /// Cells of level 3 that may become anything, this rank's share of
  /// indicators that all ranks have together.
  struct Cells
  {
    explicit Cells(const std::vector<double> &indicators)
    {
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      std::vector<double> own;
      for (unsigned int i = rank; i < indicators.size(); i += n)
        own.push_back(indicators[i]);
      wishes           = CellWishes(own.size());
      wishes.indicator = own;
      level.assign(own.size(), 3);
      wishes.at_most.assign(own.size(), 7);
    }

    /// The sums of the indicators of cells that are refined and coarsened,
    /// and their numbers.
    std::vector<double>
    run(const DecisionParameters &parameters) const
    {
      const auto decision =
        decide(MPI_COMM_WORLD, parameters, level, wishes, 4);
      std::vector<double> sums(4, 0.);
      for (unsigned int c = 0; c < level.size(); ++c)
        {
          if (decision[c] != 0)
            sums[decision[c] > 0 ? 0 : 1] += wishes.indicator[c];
          sums[2] += decision[c] > 0;
          sums[3] += decision[c] < 0;
        }
      dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
      return sums;
    }

    std::vector<unsigned char> level;
    CellWishes                 wishes;
  };



  /// 1, 2, ..., 100.
  std::vector<double>
  ramp()
  {
    std::vector<double> values(100);
    std::iota(values.begin(), values.end(), 1.);
    return values;
  }
} // namespace



TEST(MeshDecisionMpi, FractionOfCells)
{
  DecisionParameters parameters;
  parameters.strategy           = MarkingStrategy::fraction_of_cells;
  parameters.refined_fraction   = .3;
  parameters.coarsened_fraction = .1;
  const auto sums               = Cells(ramp()).run(parameters);
  EXPECT_NEAR(sums[2], 30., 1.);
  EXPECT_EQ(sums[3], 10.);
}



TEST(MeshDecisionMpi, FractionOfError)
{
  DecisionParameters parameters;
  parameters.refined_fraction   = .5;
  parameters.coarsened_fraction = .02;
  const auto sums               = Cells(ramp()).run(parameters);
  EXPECT_NEAR(sums[0], .5 * 5050., 60.);
  EXPECT_NEAR(sums[1], .02 * 5050., 10.);
}



TEST(MeshDecisionMpi, TargetNumberOfCells)
{
  DecisionParameters parameters;
  parameters.strategy       = MarkingStrategy::target_number;
  parameters.target_n_cells = 160;
  const auto sums           = Cells(ramp()).run(parameters);
  EXPECT_NEAR(100. + 3. * sums[2] - .75 * sums[3], 160., 4.);
  EXPECT_GT(sums[3], 0.);
}



TEST(MeshDecisionMpi, Threshold)
{
  DecisionParameters parameters;
  parameters.strategy          = MarkingStrategy::threshold;
  parameters.refine_threshold  = 80.;
  parameters.coarsen_threshold = 20.;
  const auto sums              = Cells(ramp()).run(parameters);
  EXPECT_EQ(sums[2], 21.);
  EXPECT_EQ(sums[3], 20.);
}



TEST(MeshDecisionMpi, MaximalNumberOfCells)
{
  DecisionParameters parameters;
  parameters.strategy         = MarkingStrategy::threshold;
  parameters.refine_threshold = 1e-3;
  parameters.maximal_n_cells  = 130;
  const auto sums             = Cells(ramp()).run(parameters);
  EXPECT_LE(100. + 3. * sums[2], 130.);
  EXPECT_GT(100. + 3. * sums[2], 120.);
}



TEST(MeshDecisionMpi, EqualIndicatorsAreTreatedAlike)
{
  std::vector<double> indicators(64, 1. / 3.);
  for (unsigned int i = 0; i < indicators.size(); ++i)
    indicators[i] *= 1. + 1e-13 * std::sin(7. * i);
  DecisionParameters parameters;
  parameters.strategy           = MarkingStrategy::fraction_of_cells;
  parameters.coarsened_fraction = .1;
  for (const double fraction : {.3, .7})
    {
      parameters.refined_fraction = fraction;
      EXPECT_EQ(Cells(indicators).run(parameters)[2], fraction < .5 ? 0. : 64.);
    }
}



TEST(MeshDecisionMpi, LevelsComeBeforeIndicators)
{
  DecisionParameters parameters;
  parameters.strategy         = MarkingStrategy::threshold;
  parameters.refine_threshold = .5;
  Cells cells(std::vector<double>(40, 1.));
  for (unsigned int c = 0; c < cells.level.size(); ++c)
    {
      cells.wishes.indicator[c] = c % 2 == 0 ? 1. : 0.;
      cells.wishes.at_least[c]  = c % 2 == 0 ? 0 : 4;
      cells.wishes.at_most[c]   = c % 2 == 0 ? 2 : 7;
    }
  const auto decision =
    decide(MPI_COMM_WORLD, parameters, cells.level, cells.wishes, 4);
  for (unsigned int c = 0; c < decision.size(); ++c)
    EXPECT_EQ(decision[c], c % 2 == 0 ? -1 : 1);
}



TEST(MeshDecisionMpi, CellsWithoutIndicatorBecomeCoarser)
{
  Cells cells(std::vector<double>(40, 0.));
  EXPECT_EQ(cells.run({})[3], 40.);
  cells.wishes.at_least.assign(cells.level.size(), 3);
  EXPECT_EQ(cells.run({})[3], 0.);
}
