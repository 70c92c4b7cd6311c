// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/body_forces.h>

#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/scene.h"

using namespace Thalweg;



TEST(BodyForces, ReadGravityAndAForceThatDependsOnTime)
{
  Scene<2> scene(
    section("Body forces", {"Gravity = 1, -9.81", "Force density = x*t; -y"}));
  EXPECT_EQ((scene.forces.gravity() - dealii::Tensor<1, 2>({1., -9.81})).norm(),
            0.);
  ASSERT_TRUE(scene.forces.has_density());
  scene.forces.set_time(3.);
  const auto f = scene.forces.density({2., 5.});
  EXPECT_EQ(f[0], 6.);
  EXPECT_EQ(f[1], -5.);
}



TEST(BodyForces, AreNoneUnlessTheyAreGiven)
{
  Scene<3> scene("");
  EXPECT_FALSE(scene.forces.has_density());
  EXPECT_EQ(scene.forces.gravity().norm(), 0.);
}



TEST(BodyForces, SayWhichExpressionIsWrong)
{
  for (const std::string text : {"1", "1; q", "1; 2; 3"})
    EXPECT_NE(complaint_of([&]() {
                Scene<2>(section("Body forces", {"Force density = " + text}));
              }).find("Body forces/Force density"),
              std::string::npos)
      << text;
}



TEST(BodyForces, KnowAccelerationsThatDependOnPlaceAndTime)
{
  Scene<2> scene(
    section("Body forces", {"Gravity = 0, -9.81", "Acceleration = x*t; y"}));
  ASSERT_TRUE(scene.forces.has_field());
  EXPECT_FALSE(scene.forces.has_density());
  scene.forces.set_time(3.);
  const auto a = scene.forces.field({2., 5.});
  EXPECT_EQ(a[0], 6.);
  EXPECT_EQ(a[1], 5.);
  EXPECT_EQ(scene.forces.uniform_acceleration()[1], -9.81);
}
