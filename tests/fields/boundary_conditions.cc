// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  /// What is said of boundary conditions for the unit box.
  std::string
  condition_complaint(const std::vector<std::string> &settings,
                      const std::string              &pairs = "")
  {
    return complaint_of([&]() {
      Scene<2>(unit_box<2>(2, "0", {"Periodic boundaries = " + pairs}) +
               section("Boundary conditions", settings));
    });
  }


  void
  expect(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos)
      << "'" << part << "' is not in: " << text;
  }
} // namespace



TEST(BoundaryConditions, ReadsKindsFunctionsAndInflowFluids)
{
  Scene<2>    scene(unit_box<2>(2) +
                 section("Boundary conditions",
                         {"No slip = bottom",
                             "Velocity = left: y*t; 0 | right: 1; x",
                             "Open = top: 100*x + t",
                             "Inflow fluids = left: water, top: air"}));
  auto       &conditions = *scene.conditions;
  const auto &at         = [&](const std::string &name) -> const auto &
  {
    return conditions.at(scene.mesh.boundary_id(name));
  };
  conditions.set_time(2.);
  EXPECT_EQ(at("bottom").kind, BoundaryKind::no_slip);
  EXPECT_EQ(at("left").kind, BoundaryKind::velocity);
  EXPECT_EQ(at("left").function->value({0., 3.}, 0), 6.);
  EXPECT_EQ(at("right").function->value({4., 3.}, 1), 4.);
  EXPECT_EQ(at("top").kind, BoundaryKind::open);
  EXPECT_EQ(at("top").function->value({.5, 1.}), 52.);
  EXPECT_EQ(at("left").inflow_fluid, "water");
  EXPECT_EQ(at("right").inflow_fluid, "");
  EXPECT_TRUE(conditions.has_open_boundary());
}



TEST(BoundaryConditions, AFlowRateIsAUniformVelocityNormalToTheBoundary)
{
  Scene<2> scene(
    unit_box<2>(2) +
    section("Boundary conditions", {"Flow rate = left: 0.3*t | top: -0.2"}));
  auto       &conditions = *scene.conditions;
  const auto &left       = conditions.at(scene.mesh.boundary_id("left"));
  const auto &top        = conditions.at(scene.mesh.boundary_id("top"));
  conditions.set_time(2.);
  EXPECT_EQ(left.kind, BoundaryKind::velocity);
  EXPECT_NEAR(left.function->value({0., .7}, 0), .6, 1e-14);
  EXPECT_NEAR(left.function->value({0., .7}, 1), 0., 1e-14);
  EXPECT_NEAR(top.function->value({.4, 1.}, 1), .2, 1e-14);
}



TEST(BoundaryConditions, WhatComesInMayBeALevel)
{
  Scene<2>    scene(unit_box<2>(2) +
                 section("Boundary conditions",
                         {"Velocity = left: 1; 0 | right: -1; 0",
                             "Open = top: 0 | bottom: 0",
                             "Inflow fluids = left: max(y-0.5,-t), top: air | "
                                "right: water | bottom: -1"}));
  auto       &conditions = *scene.conditions;
  const auto &left       = conditions.at(scene.mesh.boundary_id("left"));
  conditions.set_time(.1);
  ASSERT_TRUE(left.inflow_level_set);
  EXPECT_NEAR(left.inflow_level_set->value({0., .75}), .25, 1e-14);
  EXPECT_NEAR(left.inflow_level_set->value({0., .25}), -.1, 1e-14);
  EXPECT_EQ(conditions.at(scene.mesh.boundary_id("top")).inflow_fluid, "air");
  EXPECT_EQ(conditions.at(scene.mesh.boundary_id("right")).inflow_fluid,
            "water");
  EXPECT_TRUE(conditions.at(scene.mesh.boundary_id("bottom")).inflow_level_set);
}



TEST(BoundaryConditions, OtherwiseIsAsItIsSaid)
{
  Scene<2> slip(unit_box<2>(2));
  for (const auto &[id, condition] : slip.conditions->all())
    EXPECT_EQ(condition.kind, BoundaryKind::slip);
  EXPECT_EQ(slip.conditions->all().size(), 4u);
  EXPECT_FALSE(slip.conditions->has_open_boundary());

  Scene<2> no_slip(
    unit_box<2>(2, "0", {"Periodic boundaries = left:right"}) +
    section("Boundary conditions", {"Otherwise = no slip", "Slip = top"}));
  EXPECT_EQ(no_slip.conditions->all().size(), 2u);
  EXPECT_EQ(no_slip.conditions->at(no_slip.mesh.boundary_id("bottom")).kind,
            BoundaryKind::no_slip);
  EXPECT_EQ(no_slip.conditions->at(no_slip.mesh.boundary_id("top")).kind,
            BoundaryKind::slip);
}



TEST(BoundaryConditions, SaysWhatIsWrong)
{
  expect(condition_complaint({"No slip = floor"}),
         "There is no boundary 'floor'");
  expect(condition_complaint({"No slip = top", "Slip = top"}),
         "'top' has two conditions");
  expect(condition_complaint({"Slip = left"}, "left:right"),
         "'left' is periodic");
  expect(condition_complaint({"Otherwise = fault", "Slip = left, right, top"}),
         "'bottom' has no condition");
  expect(condition_complaint({"Velocity = left 1; 0"}), "no colon");
  expect(condition_complaint({"Velocity = left: 1"}),
         "Boundary conditions/Velocity");
  expect(condition_complaint({"Open = top: 1; 2"}), "Boundary conditions/Open");
  expect(condition_complaint({"Open = top: q"}), "cannot be understood");
  expect(condition_complaint({"Inflow fluids = left"}), "'boundary: fluid'");
  expect(condition_complaint({"Inflow fluids = left: water"}),
         "neither open nor has a velocity");
  expect(condition_complaint({"Open = top: 0", "Inflow fluids = top: y-q"}),
         "Boundary conditions/Inflow fluids");
  expect(condition_complaint({"Flow rate = left"}), "no colon");
  expect(condition_complaint({"Flow rate = left: 1; 0"}),
         "Boundary conditions/Flow rate");
  expect(condition_complaint({"Flow rate = left: y"}), "not on x, y or z");
  expect(condition_complaint({"Flow rate = left: 1", "Slip = left"}),
         "'left' has two conditions");
}
