// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/touching_boundaries.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include "support/complaint.h"

using namespace Thalweg;

namespace
{
  /// Two boxes beside each other, with nodes of their own and @p n cells a
  /// direction, the second one moved by @p gap.
  template <int dim>
  std::string
  beside(const unsigned int n, const double gap, const double offset = 0.)
  {
    dealii::Triangulation<dim> left, right, both;
    dealii::Point<dim>         lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = offset;
        upper[d] = offset + 1.;
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(
      left, std::vector<unsigned int>(dim, 2), lower, upper);
    lower[0] = offset + 1. + gap;
    upper[0] = offset + 2. + gap;
    dealii::GridGenerator::subdivided_hyper_rectangle(
      right, std::vector<unsigned int>(dim, n), lower, upper);
    // A negative tolerance merges no vertices.
    dealii::GridGenerator::merge_triangulations(left, right, both, -1.);
    return touching_boundaries(both, {{"0", 0}, {"wall", 0}});
  }
} // namespace



TEST(TouchingBoundaries, AreFoundWhereNodesAreNotMerged)
{
  const std::string text = beside<2>(2, 0.);
  EXPECT_EQ(text.find("4 boundary faces of the coarse mesh ('wall') lie on "
                      "each other, the first at (1 0.25)"),
            0u)
    << text;
  EXPECT_EQ(beside<3>(2, 0.).find("8 boundary faces"), 0u);
}



TEST(TouchingBoundaries, AreFoundWhereCellsDoNotMatch)
{
  EXPECT_EQ(beside<2>(6, 0.).find("8 boundary faces"), 0u) << beside<2>(6, 0.);
  EXPECT_EQ(beside<3>(4, 0.).find("20 boundary faces"), 0u) << beside<3>(4, 0.);
}



TEST(TouchingBoundaries, AreFoundFarFromTheOrigin)
{
  EXPECT_EQ(beside<2>(2, 1e-8, 1e7).find("4 boundary faces"), 0u);
}



TEST(TouchingBoundaries, GapsAreNone)
{
  EXPECT_EQ(beside<2>(2, 1e-3), "");
  EXPECT_EQ(beside<3>(2, 1e-3), "");
  EXPECT_EQ(beside<2>(2, 1e-3, 1e6), "");
}



namespace
{
  /// What is said of 2 x 2 cells beside n x n ones, whose nodes are merged
  /// where they are nearer than @p tolerance.
  std::string
  fault_beside(const unsigned int               n,
               const double                     tolerance,
               const dealii::types::boundary_id id)
  {
    dealii::Triangulation<2> left, right, both;
    dealii::GridGenerator::subdivided_hyper_rectangle(left,
                                                      {2, 2},
                                                      dealii::Point<2>(0, 0),
                                                      dealii::Point<2>(1, 1));
    dealii::GridGenerator::subdivided_hyper_rectangle(right,
                                                      {n, n},
                                                      dealii::Point<2>(1, 0),
                                                      dealii::Point<2>(2, 1));
    dealii::GridGenerator::merge_triangulations(left, right, both, tolerance);
    for (const auto &face : both.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(id);
    return complaint_of([&]() { refuse_doubled_nodes(both, "It"); });
  }
} // namespace



TEST(TouchingBoundaries, OfDoubledNodesAreRefusedUnlessTheyHaveNumbers)
{
  EXPECT_EQ(fault_beside(2, -1., 0).find(
              "It has doubled nodes: 4 boundary faces lie on each other, "
              "the first at (1 0.25)"),
            0u);
  EXPECT_EQ(fault_beside(2, -1., 3), "");
  EXPECT_EQ(fault_beside(2, 1e-9, 0), "");
}



TEST(TouchingBoundaries, WithHangingNodesAreRefused)
{
  for (const dealii::types::boundary_id id : {0, 3})
    EXPECT_EQ(fault_beside(4, 1e-9, id)
                .find("It has a node in the middle of a cell's side, at (1 "
                      "0.25)"),
              0u);
  EXPECT_EQ(fault_beside(4, -1., 3), "");
}
