// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/gmsh.h>
#include <thalweg/mesh/mesh_plan.h>

#include <fstream>
#include <gtest/gtest.h>

#include "made_geometry.h"
#include "support/complaint.h"
#include "support/files.h"

using namespace Thalweg;

namespace
{
  const std::string names_2d = "$PhysicalNames\n4\n"
                               "1 1 \"inlet\"\n1 4 \"open sky\"\n"
                               "1 9 \"inside\"\n2 3 \"fluid\"\n"
                               "$EndPhysicalNames\n";

  /// A unit square in version 2.2, its lower left corner at @p x, @p x.
  std::string
  version_2(const std::string &names, const double x = 0.)
  {
    const std::string zero = std::to_string(x), one = std::to_string(x + 1.);
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n4\n1 " +
           zero + " " + zero + " 0\n2 " + one + " " + zero + " 0\n3 " + one +
           " " + one + " 0\n4 " + zero + " " + one +
           " 0\n$EndNodes\n"
           "$Elements\n5\n1 1 2 1 1 4 1\n2 1 2 2 2 1 2\n3 1 2 2 3 2 3\n"
           "4 1 2 4 4 3 4\n5 3 2 3 1 1 2 3 4\n$EndElements\n";
  }

  /// The same in version 4.1.
  std::string
  version_4(const std::string &names)
  {
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names +
           "$Entities\n4 4 1 0\n1 0 0 0 0\n2 1 0 0 0\n3 1 1 0 0\n4 0 1 0 0\n"
           "1 0 0 0 0 1 0 1 1 2 4 -1\n2 0 0 0 1 0 0 1 2 2 1 -2\n"
           "3 1 0 0 1 1 0 1 2 2 2 -3\n4 0 1 0 1 1 0 1 4 2 3 -4\n"
           "1 0 0 0 1 1 0 1 3 4 1 2 3 4\n$EndEntities\n"
           "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
           "$EndNodes\n"
           "$Elements\n5 5 1 5\n1 1 1 1\n1 4 1\n1 2 1 1\n2 1 2\n1 3 1 1\n3 2 "
           "3\n"
           "1 4 1 1\n4 3 4\n2 1 3 1\n5 1 2 3 4\n$EndElements\n";
  }

  struct MeshFile
  {
    explicit MeshFile(const std::string &content)
      : path(own_path("gmsh.msh"))
    {
      std::ofstream(path) << content;
    }

    ~MeshFile()
    {
      std::remove(path.c_str());
    }

    const std::string path;
  };

  BoundaryNames
  names_of(const std::string &content, const std::string &more = "")
  {
    const MeshFile file(content);
    Made<2>        mesh("file", "File name = " + file.path + more);
    mesh.create();
    return mesh.geometry->boundary_names();
  }
} // namespace



TEST(Gmsh, PhysicalGroupsAreBoundaryNames)
{
  const BoundaryNames expected{
    {"1", 1}, {"2", 2}, {"4", 4}, {"inlet", 1}, {"open sky", 4}};
  EXPECT_EQ(names_of(version_2(names_2d)), expected);
  EXPECT_EQ(names_of(version_4(names_2d)), expected);
}



TEST(Gmsh, WithoutNamesThereAreNumbers)
{
  const BoundaryNames expected{{"1", 1}, {"2", 2}, {"4", 4}};
  EXPECT_EQ(names_of(version_2("")), expected);
  EXPECT_EQ(names_of(version_4("")), expected);
}



TEST(Gmsh, GivenNamesCountBeforeThoseOfTheFile)
{
  const auto names =
    names_of(version_2(names_2d), "\nBoundary names = inlet:2, bed:1");
  EXPECT_EQ(names.at("inlet"), 2u);
  EXPECT_EQ(names.at("bed"), 1u);
  EXPECT_EQ(names.at("open sky"), 4u);
}



TEST(Gmsh, NamesOfOtherDimensionsDoNotCount)
{
  auto names = Geometries::read_gmsh(version_2(names_2d), "It").names;
  EXPECT_EQ(names[2], (std::map<std::string, unsigned int>{{"fluid", 3}}));
  EXPECT_EQ(names[1].size(), 3u);
}



TEST(Gmsh, TwoGroupsOfOneNameAreRefused)
{
  EXPECT_TRUE(contains(complaint_of([]() {
                         names_of(version_2("$PhysicalNames\n2\n1 1 \"a\"\n"
                                            "1 2 \"a\"\n$EndPhysicalNames\n"));
                       }),
                       "two physical groups that are called 'a', 1 and 2"));
}



TEST(Gmsh, MeshesFarFromTheOriginAreRead)
{
  const MeshFile file(version_2(names_2d, 1e8));
  Made<2>        mesh("file", "File name = " + file.path);
  EXPECT_EQ(mesh.error(), "");
  EXPECT_EQ(mesh.mesh.n_active_cells(), 1u);
}



TEST(Gmsh, VersionsSayTheSame)
{
  const auto old_outline = Geometries::read_gmsh(version_2(""), "It").outline;
  const auto new_outline = Geometries::read_gmsh(version_4(""), "It").outline;
  dealii::Tensor<1, 3> offset;
  EXPECT_EQ(Geometries::gmsh_text(old_outline, 2, offset),
            Geometries::gmsh_text(new_outline, 2, offset));
  EXPECT_EQ(offset.norm(), 0.);
}



TEST(Gmsh, FaultsAreToldWithTheirLines)
{
  const auto fault = [](const std::string &old, const std::string &other) {
    std::string text = version_4(names_2d);
    text.replace(text.find(old), old.size(), other);
    return complaint_of([&]() { Geometries::read_gmsh(text, "It"); });
  };
  EXPECT_EQ(fault("4.1 0 8", "4.1 1 8"),
            "It: in line 2 it says that it is binary; save it in ASCII (in "
            "Gmsh: 'Mesh.Binary = 0;').");
  EXPECT_EQ(fault("1 4 1 4\n", "1 -4 1 4\n"),
            "It: in line 24 the number of nodes is '-4', but must be a whole "
            "number from 0 to 9223372036854775807.");
  EXPECT_EQ(fault("5 1 2 3 4", "5 1 2 3 3"),
            "It: in line 46 the element 5 has the node 3 twice.");
  EXPECT_EQ(fault("1 0 0\n1 1 0", "1 0\n1 1 0"),
            "It: in line 34 a coordinate is '$EndNodes', but must be a finite "
            "number.");
}
