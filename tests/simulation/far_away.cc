// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/run_case.h"

namespace
{
  /// Offsets that positions of a few binary digits can bear exactly: what
  /// differs is round-off of the run alone.
  constexpr double near = 1048576., far = 8388608.;

  /// One that most positions cannot bear.
  constexpr double rounded = 1000000.3;

  const std::array<const char *, 7> columns{{"volume 1 [m^d]",
                                             "volume 2 [m^d]",
                                             "kinetic energy [J]",
                                             "potential energy [J]",
                                             "momentum x [kg m/s]",
                                             "max velocity 1 [m/s]",
                                             "max velocity 2 [m/s]"}};



  template <int dim>
  void
  expect_same(const RunCase<dim> &at_origin,
              const RunCase<dim> &away,
              const double        tolerance)
  {
    for (const char *column : columns)
      EXPECT_NEAR(away.last(column),
                  at_origin.last(column),
                  tolerance * std::abs(at_origin.last(column)))
        << column;
    EXPECT_EQ(away.last("particles"), at_origin.last("particles"));
    EXPECT_EQ(away.last("particles lost in all"), 0.);
  }



  /// A coordinate that is counted from @p offset.
  std::string
  from(const std::string &axis, const double offset)
  {
    return "(" + axis + " - " + std::to_string(offset) + ")";
  }



  std::string
  point(const double x, const double y, const double offset)
  {
    return std::to_string(x + offset) + "," + std::to_string(y - offset);
  }



  const std::string few_steps =
    section("Time", {"Time step = 0.0078125", "End time = 0.0625"});



  /// A column of water that begins to fall, with its lower corner at
  /// (offset, -offset).
  std::string
  dam_break(const double                    offset,
            const std::vector<std::string> &refinement,
            const std::string              &repetitions = "16, 8",
            const std::string              &width       = "0.26",
            const std::string              &height      = "0.31")
  {
    return section("Geometry",
                   {},
                   section("box",
                           {"Lower corner = " + point(0., 0., offset),
                            "Upper corner = " + point(1., .5, offset),
                            "Repetitions = " + repetitions})) +
           section("Refinement", refinement) + few_steps +
           section("Body forces", {"Gravity = 0, -9.81"}) +
           section("Initial conditions",
                   {"Level set = max(" + from("x", offset) + " - " + width +
                    ", " + from("y", -offset) + " - " + height + ")"}) +
           tight_solver("1e-12", "1e-12");
  }



  std::string
  dam_break_3d(const double offset)
  {
    const std::string x = std::to_string(offset),
                      z = std::to_string(offset / 2.);
    return section("Geometry",
                   {},
                   section("box",
                           {"Lower corner = " + x + ", -" + x + ", " + z,
                            "Upper corner = " + std::to_string(offset + 1.) +
                              ", " + std::to_string(.25 - offset) + ", " +
                              std::to_string(offset / 2. + .5),
                            "Repetitions = 8, 2, 4"})) +
           few_steps + section("Body forces", {"Gravity = 0, 0, -9.81"}) +
           section("Initial conditions",
                   {"Level set = max(" + from("x", offset) + " - 0.26, " +
                    from("z", offset / 2.) + " - 0.31)"}) +
           tight_solver("1e-12", "1e-12");
  }



  /// The same in cells without right angles.
  std::string
  skew_dam_break(const double       offset,
                 const std::string &width,
                 const bool         is_binary = true)
  {
    const auto corner = [&](const double x, const double y, const double more) {
      return is_binary ? point(x, y, offset)
                       : point(x + more, y - more, offset);
    };
    return section("Geometry",
                   {"Model = generator"},
                   section("generator",
                           {"Function = general_cell",
                            "Arguments = " + corner(0., 0., 0.) + ";" +
                              corner(1., .125, .1) + ";" +
                              corner(.125, .75, .04) + ";" +
                              corner(1.25, .625, -.02) + ": false"})) +
           section("Refinement", {"Global levels = 3"}) + few_steps +
           section("Body forces", {"Gravity = 0, -9.81"}) +
           section("Initial conditions",
                   {"Level set = max(" + from("x", offset) + " - " + width +
                    ", " + from("y", -offset) + " - 0.4)"}) +
           tight_solver("1e-12", "1e-12");
  }



  /// One fluid under a moving lid.
  std::string
  cavity(const double offset)
  {
    return section("Geometry",
                   {},
                   section("box",
                           {"Lower corner = " + point(0., 0., offset),
                            "Upper corner = " + point(1., 1., offset),
                            "Repetitions = 8, 8"})) +
           few_steps + section("Method", {"Model = single fluid pfem2"}) +
           one_fluid(1., .01) +
           section("Boundary conditions",
                   {"Velocity = top: 1; 0", "Otherwise = no slip"});
  }
} // namespace



TEST(FarAway, DamBreakIsAsAtTheOrigin)
{
  const RunCase<2> origin(dam_break(0., {}));
  expect_same(origin, RunCase<2>(dam_break(near, {})), 1e-6);
  expect_same(origin, RunCase<2>(dam_break(far, {})), 1e-5);
}



TEST(FarAway, DamBreakOnHangingNodesIsAsAtTheOrigin)
{
  const auto levels = [](const double offset) {
    return std::vector<std::string>{"Local levels = if(" + from("x", offset) +
                                    " < 0.5, 1, 0)"};
  };
  const RunCase<2> origin(dam_break(0., levels(0.)));
  expect_same(origin, RunCase<2>(dam_break(near, levels(near))), 1e-6);
}



TEST(FarAway, SkewCellsAreAsAtTheOrigin)
{
  const RunCase<2> origin(skew_dam_break(0., "0.5"));
  for (const double offset : {near, rounded})
    expect_same(origin, RunCase<2>(skew_dam_break(offset, "0.5")), 1e-6);
}



TEST(FarAway, SkewCellsOfAnyDigitsAreAsAtTheOrigin)
{
  for (const char *width : {"0.45", "0.5"})
    {
      const RunCase<2> origin(skew_dam_break(0., width, false));
      for (const double offset : {near, rounded})
        expect_same(origin,
                    RunCase<2>(skew_dam_break(offset, width, false)),
                    1e-6);
    }
}



// Nodes, edges and particles of the cells lie on the interface: round-off must
// not decide on which side of it.
TEST(FarAway, InterfacesAlongCellsAreAsAtTheOrigin)
{
  const auto run = [](const double       offset,
                      const bool         along_edges,
                      const std::string &levels = "0") {
    return RunCase<2>(dam_break(offset,
                                {"Local levels = " + levels},
                                "20, 10",
                                along_edges ? "0.25" : "0.275",
                                along_edges ? "0.3" : "0.325"));
  };
  for (const bool along_edges : {true, false})
    {
      const RunCase<2> origin(run(0., along_edges));
      for (const double offset : {rounded, 5. * rounded})
        expect_same(origin, run(offset, along_edges), 1e-6);
    }
  const auto left = [](const double offset) {
    return "if(" + from("x", offset) + " < 0.51, 1, 0)";
  };
  expect_same(run(0., true, left(0.)), run(near, true, left(near)), 1e-6);
}



TEST(FarAway, DamBreakIsAsAtTheOrigin3d)
{
  const RunCase<3> origin(dam_break_3d(0.));
  expect_same(origin, RunCase<3>(dam_break_3d(near)), 1e-6);
}



TEST(FarAway, OneFluidIsAsAtTheOrigin)
{
  const RunCase<2> origin(cavity(0.)), away(cavity(near));
  for (const char *column : {"kinetic energy [J]", "momentum x [kg m/s]"})
    EXPECT_NEAR(away.last(column),
                origin.last(column),
                1e-6 * std::abs(origin.last("kinetic energy [J]")))
      << column;
}
