// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/mesh_outline.h>
#include <thalweg/mesh/geometries/overlap.h>
#include <thalweg/mesh/touching_boundaries.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include "support/complaint.h"

using namespace Thalweg;
using namespace Thalweg::Geometries;

namespace
{
  const std::string square_in_vtk =
    "# vtk DataFile Version 3.0\nx\nASCII\n"
    "DATASET UNSTRUCTURED_GRID\nPOINTS 4 double"
    "\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\nCELLS 1 5\n"
    "4 0 1 2 3\n\nCELL_TYPES 1\n9\n";
  const std::string square_in_ucd =
    "# a\n# b\n4 2 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "1 3 quad 1 2 3 4\n2 7 line 1 2\n";
  const std::string square_in_unv =
    " -1\n 2411\n1 1 1 1\n0 0 0\n2 1 1 1\n1 0 0\n3 1 1 1\n1 1 0\n4 1 1 1\n"
    "0 1 0\n -1\n -1\n 2412\n1 94 1 1 1 4\n1 2 3 4\n2 11 1 1 1 2\n0 1 1\n1 2\n"
    " -1\n -1\n 2467\n1 0 0 0 0 0 0 1\n7\n8 2 0 0\n -1\n";
  const std::string square_in_abaqus =
    "*HEADING\nx\n*NODE, NSET=A\n1, 0, 0\n2, 1, 0, 0\n3, 1, 1\n4, 0, 1\n** x\n"
    "*Element, TYPE=S4\n1, 1, 2, 3, 4\n*ELSET, ELSET=B\n1,\n";

  /// @p text with @p old replaced, as @p read takes it.
  template <typename Read>
  std::string
  fault(const Read        &read,
        std::string        text,
        const std::string &old,
        const std::string &other)
  {
    text.replace(text.find(old), old.size(), other);
    return complaint_of([&]() { check_outline(read(text, "It"), 2, "It"); });
  }

  MeshOutline
  abaqus_2d(const std::string &text, const std::string &refusal)
  {
    return outline_of_abaqus(text, 2, refusal);
  }
} // namespace


TEST(MeshOutline, IsReadFromFiles)
{
  for (const MeshOutline &outline : {outline_of_vtk(square_in_vtk, "It"),
                                     outline_of_ucd(square_in_ucd, "It"),
                                     outline_of_unv(square_in_unv, "It"),
                                     abaqus_2d(square_in_abaqus, "It")})
    {
      ASSERT_EQ(outline.points.size(), 4u);
      EXPECT_EQ(outline.points[2], dealii::Point<3>(1, 1, 0));
      ASSERT_GE(outline.elements.size(), 1u);
      EXPECT_EQ(outline.elements[0].shape, Shape::quadrilateral);
      EXPECT_EQ(outline.elements[0].nodes,
                (std::vector<unsigned int>{0, 1, 2, 3}));
      EXPECT_NO_THROW(check_outline(outline, 2, "It"));
    }
  EXPECT_EQ(outline_of_ucd(square_in_ucd, "It").elements[1].tag, 7);
}


TEST(MeshOutline, TellsWhatIsWrongInFiles)
{
  EXPECT_EQ(fault(outline_of_vtk, square_in_vtk, "4 0 1 2 3", "4 0 1 2 4"),
            "It: in line 12 an element has the node 4, but there is no node of "
            "this number.");
  EXPECT_EQ(fault(outline_of_vtk, square_in_vtk, "4 0 1 2 3", "3 0 1 2"),
            "It: in line 12 the number of a cell's points is '3', but must be "
            "a whole number from 4 to 4.");
  EXPECT_EQ(fault(outline_of_vtk, square_in_vtk, "POINTS 4", "POINTS 4000"),
            "It: in line 5 the number of points is 4000, but the rest of the "
            "file has room for 13 at the most.");
  EXPECT_EQ(fault(outline_of_ucd, square_in_ucd, "quad", "quadr"),
            "It: in line 8 stands an element of the type 'quadr', which is not "
            "supported.");
  EXPECT_EQ(fault(outline_of_ucd, square_in_ucd, "2 1 0 0", "1 1 0 0"),
            "It: in line 5 the node 1 comes for the second time.");
  EXPECT_EQ(fault(outline_of_unv, square_in_unv, "2412", "2413"),
            "It: in line 13 must begin the section 2412 of the elements.");
  EXPECT_EQ(fault(abaqus_2d, square_in_abaqus, "2, 3, 4", "2, 3"),
            "It: in line 10 the number of an element's nodes is '3', but must "
            "be a whole number from 4 to 4.");
  EXPECT_EQ(fault(abaqus_2d, square_in_abaqus, "1, 1\n", "1, x\n"),
            "It: in line 6 a coordinate is 'x', but must be a finite number.");
}


TEST(MeshOutline, IsReadFromFilesWithoutBoundaries)
{
  const std::string xda = "x\n1 # cells\n4 # nodes\n\n\n\n\n\n\n\n\n"
                          "0 1 2 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string dbmesh =
    "MeshVersionFormatted 0\n\nDimension\n2\n\n# END\n\nVertices\n4\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n\nEdges\n0\n\nCrackedEdges\n0\n\n"
    "Quadrilaterals\n1\n1 2 3 4 0\n\nEnd\n";
  const std::string tecplot =
    "TITLE = \"x\"\nVARIABLES = \"x\" \"y\"\nZONE N = 4, E=1, F=FEPOINT, "
    "ET=QUADRILATERAL\n0 0\n1 0\n1 1\n0 1e0\n1 2 3 4\n";
  const auto read_xda = [](const std::string &text, const std::string &what) {
    return outline_of_xda(text, 2, what);
  };
  const auto read_tecplot = [](const std::string &text,
                               const std::string &what) {
    return outline_of_tecplot(text, 2, what);
  };
  for (const MeshOutline &outline : {read_xda(xda, "It"),
                                     outline_of_dbmesh(dbmesh, "It"),
                                     read_tecplot(tecplot, "It")})
    {
      EXPECT_EQ(outline.points.size(), 4u);
      ASSERT_EQ(outline.elements.size(), 1u);
      EXPECT_EQ(outline.elements[0].nodes,
                (std::vector<unsigned int>{0, 1, 2, 3}));
    }
  EXPECT_EQ(fault(read_xda, xda, "0 1 2 3", "0 1 2 4"),
            "It: in line 12 an element has the node 4, but there is no node of "
            "this number.");
  EXPECT_EQ(fault(outline_of_dbmesh, dbmesh, "1 2 3 4 0", "1 2 3 0 0"),
            "It: in line 23 an element has the node 0, but there is no node of "
            "this number.");
  EXPECT_EQ(fault(read_tecplot, tecplot, "1 2 3 4", "1 2 3 77"),
            "It: in line 8 an element has the node 77, but there is no node of "
            "this number.");
}


TEST(MeshOutline, SidesBelongToCells)
{
  EXPECT_EQ(fault(outline_of_ucd, square_in_ucd, "line 1 2", "line 1 3"),
            "It: the element 2 in line 9 is to mark a boundary, but is no side "
            "of a cell (its middle is (0.5 0.5 0)). Remove it, or repair the "
            "mesh.");
  EXPECT_EQ(fault(outline_of_ucd,
                  square_in_ucd,
                  "1 3 quad 1 2 3 4\n2 7 line 1 2",
                  "1 7 line 1 2\n2 7 line 1 2"),
            "It: it has no cells of 2 dimensions. Does the parameter "
            "'Dimension' fit the mesh?");
}


namespace
{
  /// Two cells, the second one at @p x, whose nodes are not those of the
  /// first.
  template <int dim>
  std::string
  overlap_with(const double x)
  {
    dealii::Triangulation<dim> one, other, both;
    dealii::GridGenerator::hyper_cube(one);
    dealii::GridGenerator::hyper_cube(other, .25, 1.25);
    dealii::Tensor<1, dim> shift;
    shift[0] = x;
    dealii::GridTools::shift(shift, other);
    dealii::GridGenerator::merge_triangulations(one, other, both, -1.);
    return complaint_of([&]() { check_overlap(both, "It"); });
  }
} // namespace


TEST(Overlap, OfCellsIsRefused)
{
  EXPECT_NE(overlap_with<2>(0.).find("It has cells that overlap: cell 0 "),
            std::string::npos);
  EXPECT_NE(overlap_with<3>(.5).find("It has cells that overlap: cell 0 "),
            std::string::npos);
  EXPECT_EQ(overlap_with<2>(.75), "");
  EXPECT_EQ(overlap_with<3>(.75), "");
}


TEST(Overlap, OfNeighboursIsNone)
{
  dealii::Triangulation<3> ball;
  dealii::GridGenerator::hyper_ball(ball);
  EXPECT_NO_THROW(check_overlap(ball, "It"));
}
