// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/division.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <unistd.h>

#include "made_geometry.h"

namespace
{
  using namespace Thalweg;

  /// A file that lives as long as this object.
  struct TemporaryFile
  {
    TemporaryFile(const std::string &name, const std::string &content)
      : path(::testing::TempDir() + "/" + std::to_string(getpid()) + name)
    {
      std::ofstream(path) << content;
    }

    ~TemporaryFile()
    {
      std::remove(path.c_str());
    }

    std::string path;
  };


  /// Two quadrilaterals with material ids 3 and 4, boundary ids 7 and 8.
  std::string
  gmsh_file(const std::string &cells = "5 3 2 3 1 1 2 5 4\n6 3 2 4 1 2 3 6 5\n",
            const std::string &node  = "5 1 1 0")
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n"
           "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n" +
           node +
           "\n6 2 1 0\n"
           "$EndNodes\n$Elements\n6\n"
           "1 1 2 7 1 1 4\n2 1 2 8 1 3 6\n3 1 2 8 1 1 2\n4 1 2 8 1 4 5\n" +
           cells + "$EndElements\n";
  }
} // namespace


TEST(Box, HasSizeCellsAndNamedSidesIn2D)
{
  Made<2> box("box",
              "Lower corner = -1, 0\nUpper corner = 2, 4\nRepetitions = 3, 2");
  box.create();
  EXPECT_EQ(box.mesh.n_active_cells(), 6u);
  EXPECT_NEAR(dealii::GridTools::volume(box.mesh), 12., 1e-12);
  EXPECT_EQ(box.geometry->boundary_names().size(), 4u);
  EXPECT_NEAR(box.boundary_measure("left"), 4., 1e-12);
  EXPECT_NEAR(box.boundary_measure("top"), 3., 1e-12);
  for (const auto &face : box.mesh.active_face_iterators())
    {
      if (face->at_boundary() && face->boundary_id() == 3)
        {
          EXPECT_NEAR(face->center()[1], 4., 1e-12);
        }
    }
}


TEST(Box, NamesSixSidesIn3D)
{
  Made<3> box("box", "Upper corner = 1, 2, 3\nRepetitions = 1, 2, 3");
  box.create();
  const auto names = box.geometry->boundary_names();
  EXPECT_EQ(names.at("front"), 4u);
  EXPECT_EQ(names.at("back"), 5u);
  EXPECT_NEAR(box.boundary_measure("right"), 6., 1e-12);
  EXPECT_NEAR(box.boundary_measure("bottom"), 3., 1e-12);
  EXPECT_NEAR(box.boundary_measure("back"), 2., 1e-12);
}


TEST(Box, RefusesSwappedCorners)
{
  Made<2> box("box", "Lower corner = 0, 1\nUpper corner = 1, 0");
  EXPECT_TRUE(contains(box.error(), "no extent in direction y"));
}


TEST(Box, CanBeDistributed)
{
  Made<2> box("box", "Repetitions = 2, 2");
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  box.geometry->create(mesh);
  EXPECT_EQ(mesh.n_global_active_cells(), 4u);
}


TEST(Divide, PutsLinesOnFixedPositionsAndSpreadsEvenly)
{
  const auto steps =
    Geometries::divide(0., 1., {0.25, 1., 0.55, 0.25, -3.}, 0.1);
  EXPECT_NEAR(std::accumulate(steps.begin(), steps.end(), 0.), 1., 1e-14);
  double           position = 0;
  std::set<double> missing{0.25, 0.55};
  for (const double step : steps)
    {
      EXPECT_GT(step, 0.08);
      EXPECT_LT(step, 0.13);
      position += step;
      for (const double fixed : {0.25, 0.55})
        if (std::abs(position - fixed) < 1e-12)
          missing.erase(fixed);
    }
  EXPECT_TRUE(missing.empty());
}


TEST(BoxWithObstacles, CutsOutAndNamesObstacles)
{
  Made<2> box("box with obstacles",
              "Upper corner = 0.584, 0.6\nCell size = 0.012\n"
              "Obstacles = 0.292, 0 : 0.316, 0.048 ; 0.4, 0.1 : 0.45, 0.2");
  box.create();
  EXPECT_NEAR(dealii::GridTools::volume(box.mesh),
              0.584 * 0.6 - 0.024 * 0.048 - 0.05 * 0.1,
              1e-12);
  EXPECT_NEAR(box.boundary_measure("obstacle"), 2 * .048 + .024 + .3, 1e-12);
  EXPECT_NEAR(box.boundary_measure("bottom"), 0.584 - 0.024, 1e-12);
  EXPECT_NEAR(box.boundary_measure("left"), 0.6, 1e-12);
  for (const auto &cell : box.mesh.active_cell_iterators())
    {
      const double ratio =
        cell->extent_in_direction(0) / cell->extent_in_direction(1);
      EXPECT_GT(ratio, 0.8);
      EXPECT_LT(ratio, 1.25);
    }
}


TEST(BoxWithObstacles, WorksDistributedIn3DAndWithoutObstacles)
{
  Made<3>                                         box("box with obstacles",
              "Cell size = 0.25\nObstacles = 0.5, 0, 0.25 : 0.75, 0.5, 0.75");
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  box.geometry->create(mesh);
  EXPECT_EQ(mesh.n_global_active_cells(), 64u - 4u);
  box.create();
  EXPECT_NEAR(box.boundary_measure("obstacle"),
              2 * .25 + 2 * .125 + .125,
              1e-12);

  Made<2> empty("box with obstacles", "Cell size = 0.5");
  empty.create();
  EXPECT_EQ(empty.mesh.n_active_cells(), 4u);
  EXPECT_EQ(empty.geometry->boundary_names().count("obstacle"), 0u);
}


TEST(BoxWithObstacles, RefusesWhatCannotBe)
{
  const std::string model = "box with obstacles";
  EXPECT_TRUE(
    contains(Made<2>(model, "Cell size = -1").error(), "greater than zero"));
  EXPECT_TRUE(contains(Made<2>(model, "Obstacles = 2, 0 : 3, 1").error(),
                       "lies outside the box"));
  EXPECT_TRUE(contains(Made<2>(model, "Obstacles = 0.5, 0.5 : 0.4, 1").error(),
                       "The obstacle from"));
  EXPECT_TRUE(contains(Made<2>(model, "Obstacles = -1, -1 : 2, 2").error(),
                       "fill the whole box"));
}


TEST(Generator, CallsByNameAndNamesByNumber)
{
  Made<2> shell("generator",
                "Function = hyper_shell\nArguments = 0, 0 : 1 : 2 : 8 : true");
  shell.create();
  EXPECT_EQ(shell.mesh.n_active_cells(), 8u);
  EXPECT_EQ(shell.geometry->boundary_names().size(), 2u);
  EXPECT_EQ(shell.geometry->boundary_names().at("1"), 1u);
  shell.mesh.refine_global(4);
  EXPECT_NEAR(dealii::GridTools::volume(shell.mesh), 3 * M_PI, 1e-2);
}


TEST(Generator, ExplainsWhatIsWrong)
{
  EXPECT_TRUE(contains(Made<2>("generator", "Function = hyper_cub").error(),
                       "'hyper_cub' with the arguments"));
  // What deal.II says differs from version to version; that it is passed on
  // does not.
  const std::string message =
    Made<2>("generator", "Function = hyper_cube\nArguments = a : 1").error();
  const auto reason = message.find("What went wrong:\n");
  ASSERT_NE(reason, std::string::npos) << message;
  EXPECT_TRUE(contains(message.substr(reason), "a : 1")) << message;

  EXPECT_TRUE(
    contains(Made<2>("generator",
                     "Function = subdivided_hyper_cube_with_simplices\n"
                     "Arguments = 2 : 0 : 1 : false")
               .error(),
             "'subdivided_hyper_cube_with_simplices'"));
}


TEST(File, KeepsIdsAndTakesNames)
{
  const TemporaryFile file("a.msh", gmsh_file());
  Made<2>             mesh("file",
               "File name = " + file.path +
                 "\nScale = 0.1\nBoundary names = inlet:7, wall:8");
  mesh.create();
  EXPECT_NEAR(dealii::GridTools::volume(mesh.mesh), 0.02, 1e-14);
  EXPECT_NEAR(mesh.boundary_measure("inlet"), 0.1, 1e-14);
  EXPECT_NEAR(mesh.boundary_measure("8"), 0.3, 1e-14);
  std::set<dealii::types::material_id> materials;
  for (const auto &cell : mesh.mesh.active_cell_iterators())
    materials.insert(cell->material_id());
  EXPECT_EQ(materials, (std::set<dealii::types::material_id>{3, 4}));

  dealii::parallel::distributed::Triangulation<2> distributed(MPI_COMM_WORLD);
  mesh.geometry->create(distributed);
  for (const auto &cell : distributed.active_cell_iterators())
    EXPECT_EQ(materials.count(cell->material_id()), 1u);
}


TEST(File, ExplainsWhatIsWrong)
{
  EXPECT_TRUE(contains(Made<2>("file", "File name = no/such.msh").error(),
                       "'no/such.msh' cannot be opened"));
  EXPECT_TRUE(contains(Made<2>("file", "File name = mesh.stl").error(),
                       "no mesh format is known"));

  const TemporaryFile garbage("b.msh", "this is no mesh\n");
  EXPECT_TRUE(contains(Made<2>("file", "File name = " + garbage.path).error(),
                       "cannot be read as a mesh in 2 dimensions"));

  const TemporaryFile twisted(
    "c.msh", gmsh_file("5 3 2 3 1 1 5 2 4\n6 3 2 4 1 2 3 6 5\n"));
  const std::string message =
    Made<2>("file", "File name = " + twisted.path).error();
  EXPECT_TRUE(contains(message, "inverted or distorted")) << message;
  EXPECT_TRUE(contains(message, "The first is cell 0 ")) << message;

  const TemporaryFile concave(
    "f.msh",
    gmsh_file("5 3 2 3 1 1 2 5 4\n6 3 2 4 1 2 3 6 5\n", "5 0.2 0.2 0"));
  const std::string where =
    Made<2>("file", "File name = " + concave.path).error();
  EXPECT_TRUE(contains(where, "The first is cell 0 with its centre at"))
    << where;

  const TemporaryFile triangles(
    "d.msh", gmsh_file("5 2 2 3 1 1 2 5\n6 2 2 4 1 1 5 4\n"));
  EXPECT_TRUE(contains(Made<2>("file", "File name = " + triangles.path).error(),
                       "not quadrilaterals"));

  const TemporaryFile good("e.msh", gmsh_file());
  EXPECT_TRUE(contains(
    Made<2>("file", "File name = " + good.path + "\nBoundary names = inlet:9")
      .error(),
    "It has: 0, 7, 8"));
}


TEST(File, DividesTriangles)
{
  std::string text =
    gmsh_file("5 2 2 3 1 1 2 5\n6 2 2 4 1 1 5 4\n7 3 2 5 1 2 3 6 5\n");
  text.replace(text.find("Elements\n6"), 10, "Elements\n7");
  const TemporaryFile file("g.msh", text);
  Made<2>             mesh("file",
               "File name = " + file.path +
                 "\nDivide cells = true\nBoundary names = inlet:7, wall:8");
  EXPECT_EQ(mesh.error(), "");
  EXPECT_EQ(mesh.mesh.n_active_cells(), 10u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh.mesh), 2., 1e-14);
  EXPECT_NEAR(mesh.boundary_measure("inlet"), 1., 1e-14);
  EXPECT_NEAR(mesh.boundary_measure("wall"), 3., 1e-14);
  std::map<dealii::types::material_id, double> areas;
  for (const auto &cell : mesh.mesh.active_cell_iterators())
    areas[cell->material_id()] += cell->measure();
  EXPECT_NEAR(areas[3], .5, 1e-14);
  EXPECT_NEAR(areas[4], .5, 1e-14);
  EXPECT_NEAR(areas[5], 1., 1e-14);
}


TEST(File, DividesTetrahedra)
{
  const TemporaryFile file(
    "h.msh",
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n"
    "3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n$Elements\n3\n"
    "1 2 2 7 1 1 2 3\n2 4 2 1 1 1 2 3 4\n3 4 2 2 1 2 3 4 5\n$EndElements\n");
  Made<3> mesh("file", "File name = " + file.path + "\nDivide cells = true");
  EXPECT_EQ(mesh.error(), "");
  EXPECT_EQ(mesh.mesh.n_active_cells(), 8u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh.mesh), .5, 1e-12);
  EXPECT_NEAR(mesh.boundary_measure("7"), .5, 1e-12);
}


namespace
{
  /// A mesh of one cell, which deal.II 9.4 cannot read from a file.
  void
  make_cell(dealii::Triangulation<3>            &mesh,
            const std::vector<dealii::Point<3>> &vertices)
  {
    dealii::CellData<3> cell(vertices.size());
    std::iota(cell.vertices.begin(), cell.vertices.end(), 0u);
    mesh.create_triangulation(vertices, {cell}, {});
  }
} // namespace


TEST(Division, DividesWedgesAndRefusesPyramids)
{
  dealii::Triangulation<3> wedge, pyramid, cubes;
  make_cell(wedge,
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  Geometries::divide_into_cubes(wedge, cubes, "A wedge");
  EXPECT_EQ(cubes.n_active_cells(), 6u);
  EXPECT_NEAR(dealii::GridTools::volume(cubes), .5, 1e-12);

  make_cell(pyramid, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {.5, .5, 1}});
  const std::string message = complaint_of(
    [&]() { Geometries::divide_into_cubes(pyramid, cubes, "A pyramid"); });
  EXPECT_TRUE(contains(message, "has pyramids")) << message;
}
