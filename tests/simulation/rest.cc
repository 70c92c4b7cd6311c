// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "support/input.h"
#include "support/irregular_mesh.h"
#include "support/run_case.h"

namespace
{
  /// A direction in space, upwards from water to air.
  template <int dim>
  using Normal = std::array<double, dim>;

  Normal<2>
  tilted(const double degrees)
  {
    const double angle = degrees * std::acos(-1.) / 180.;
    return {{-std::sin(angle), std::cos(angle)}};
  }

  std::string
  number(const double value)
  {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }

  /// The distance from a plane near the middle of the unit box, as an
  /// expression.
  template <int dim>
  std::string
  plane(const Normal<dim> &normal)
  {
    std::string sum = "-0.51371";
    for (unsigned int d = 0; d < dim; ++d)
      sum += std::string(" + ") + "(" + number(normal[d]) + ")*(" +
             std::string(1, "xyz"[d]) + " - 0.5)";
    return "0.5 + " + sum;
  }

  template <int dim>
  std::string
  gravity(const Normal<dim> &normal)
  {
    std::string components;
    for (unsigned int d = 0; d < dim; ++d)
      components += (d == 0 ? "" : ", ") + number(-9.81 * normal[d]);
    return components;
  }



  /// Water under air for @p n_steps steps, solved tightly.
  template <int dim>
  std::string
  rest(const std::string &mesh,
       const Normal<dim> &normal,
       const unsigned int n_steps   = 10,
       const std::string &level_set = "")
  {
    return mesh +
           section("Time",
                   {"Time step = 0.01",
                    "End time = " + number(.01 * n_steps)}) +
           section("Body forces", {"Gravity = " + gravity<dim>(normal)}) +
           section("Initial conditions",
                   {"Level set = " +
                    (level_set.empty() ? plane<dim>(normal) : level_set)}) +
           tight_solver("1e-13", "1e-13");
  }



  template <int dim>
  double
  largest_speed(const RunCase<dim> &run)
  {
    return std::max(run.last("max velocity 1 [m/s]"),
                    run.last("max velocity 2 [m/s]"));
  }

  template <int dim>
  double
  largest_speed(const std::string &text)
  {
    return largest_speed(RunCase<dim>(text));
  }

  const Normal<3>   flat_3d = {{0., 0., 1.}}, general_3d = {{.36, .48, .8}};
  const std::string no_slip =
    section("Boundary conditions", {"Otherwise = no slip"});
} // namespace



TEST(Rest, FlatInterfaceStaysAtRest)
{
  for (const std::string height : {"0.41", "0.45", "0.4999"})
    EXPECT_LT(largest_speed<2>(rest<2>(
                box_of("10, 10", "0"), tilted(0.), 10, "y - " + height)),
              1e-9)
      << height;
}



TEST(Rest, TiltedPlanesStayAtRest)
{
  for (const double angle : {1., 17., 40., 45.})
    EXPECT_LT(largest_speed<2>(rest<2>(box_of("8, 8", "0"), tilted(angle))),
              1e-9)
      << angle;
}



TEST(Rest, LevelSetsThatAreNoDistancesToo)
{
  for (const std::string level_set : {"y^2 - 0.26", "7*(y - 0.513)"})
    EXPECT_LT(largest_speed<2>(
                rest<2>(box_of("8, 8", "0"), tilted(0.), 5, level_set)),
              1e-9)
      << level_set;
}



TEST(Rest, TiltedPlanesAcrossHangingNodesStayAtRest)
{
  for (const double angle : {0., 17., 45.})
    EXPECT_LT(largest_speed<2>(
                rest<2>(box_of("8, 8", "if(x < 0.4, 1, 0)"), tilted(angle))),
              1e-9)
      << angle;
}



TEST(Rest, TiltedPlanesInCellsOfAnyShapeStayAtRest)
{
  for (const bool triangles : {false, true})
    {
      const IrregularMesh<2> mesh(8, triangles ? .2 : .3, triangles);
      for (const double angle : {0., 17., 40.})
        for (const std::string &walls : {std::string(), no_slip})
          EXPECT_LT(largest_speed<2>(
                      rest<2>(mesh.geometry(triangles), tilted(angle), 5) +
                      walls),
                    1e-9)
            << triangles << angle << walls;
    }
}



TEST(Rest, ATiltedPlaneInADiscStaysAtRest)
{
  const std::string disc =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_ball",
                     "Arguments = 0.5, 0.5 : 0.5 : true"})) +
    section("Refinement", {"Global levels = 2"});
  EXPECT_LT(largest_speed<2>(rest<2>(disc, tilted(20.), 5)), 1e-9);
}



TEST(Rest, ATiltedPlaneAtAnObstacleStaysAtRest)
{
  const std::string box =
    section("Geometry",
            {"Model = box with obstacles"},
            section("box with obstacles",
                    {"Upper corner = 1, 1",
                     "Cell size = 0.125",
                     "Obstacles = 0.25, 0.375 : 0.5, 0.625"}));
  EXPECT_LT(largest_speed<2>(rest<2>(box, tilted(17.), 5)), 1e-9);
}



TEST(Rest, BesideAnOpenHydrostaticSide)
{
  const auto        normal = tilted(17.);
  const std::string phi    = "(" + plane<2>(normal) + ")";
  const std::string open =
    section("Boundary conditions",
            {"Open = right: -9.81*" + phi + "*if(" + phi + " < 0, 1000, 1.2)"});
  EXPECT_LT(largest_speed<2>(
              rest<2>(box_of("8, 8", "if(y < 0.5, 1, 0)"), normal) + open +
              two_fluids(1000., 1.2)),
            1e-9);
}



TEST(Rest, PlanesStayAtRest3d)
{
  for (const std::string levels : {"0", "if(x + y < 0.7, 1, 0)"})
    EXPECT_LT(
      largest_speed<3>(rest<3>(box_of("4, 4, 4", levels), general_3d, 3)), 1e-9)
      << levels;
  for (const bool tetrahedra : {false, true})
    {
      const IrregularMesh<3> mesh(tetrahedra ? 2 : 4, .2, tetrahedra);
      for (const auto &normal : {flat_3d, general_3d})
        EXPECT_LT(
          largest_speed<3>(rest<3>(mesh.geometry(tetrahedra), normal, 2)), 1e-9)
          << tetrahedra << normal[0];
    }
}



TEST(Rest, WithoutEnrichmentItMoves)
{
  // What would be the same in each column of cells does not move a level
  // surface.
  EXPECT_GT(largest_speed<2>(rest<2>(box_of("10, 10", "0"), tilted(17.)) +
                             section("Interface", {"Enrichment = none"})),
            1e-3);
}



TEST(RestMpi, TiltedPlaneOnAMeshThatAdaptsEveryStepStaysAtRest)
{
  const std::string wave = "if(abs(x - 8*t) < 0.2, 1, 0)";
  const std::string mesh =
    section("Geometry", {}, section("box", {"Repetitions = 8, 8"})) +
    adapting_every_step("0",
                        "1",
                        "region",
                        {"At least = " + wave, "At most = " + wave});
  const RunCase<2> run(rest<2>(mesh, tilted(17.)));
  EXPECT_LT(largest_speed(run), 1e-9);
  EXPECT_GT(run.last("adaptations"), 5.);
  EXPECT_EQ(run.last("particles lost"), 0.);
}



TEST(RestMpi, TiltedPlaneOnAMeshThatAdaptsEveryStepStaysAtRest3d)
{
  const std::string wave = "if(abs(x - 8*t) < 0.2, 1, 0)";
  const std::string mesh =
    section("Geometry", {}, section("box", {"Repetitions = 4, 4, 4"})) +
    adapting_every_step("0",
                        "1",
                        "region",
                        {"At least = " + wave, "At most = " + wave});
  const RunCase<3> run(rest<3>(mesh, general_3d));
  EXPECT_LT(largest_speed(run), 1e-9);
  EXPECT_GT(run.last("adaptations"), 2.);
}
