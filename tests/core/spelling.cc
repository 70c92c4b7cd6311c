// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/spelling.h>

#include <gtest/gtest.h>

using namespace Thalweg;

TEST(Spelling, EditDistance)
{
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("density", "density"), 0u);
  EXPECT_EQ(edit_distance("Density", "density"), 0u);
  EXPECT_EQ(edit_distance("desnity", "density"), 1u);
  EXPECT_EQ(edit_distance("densty", "density"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}


TEST(Spelling, NearestFindsWhatCouldBeMeant)
{
  const std::vector<std::string> names = {"End time", "Time step", "Courant"};
  EXPECT_EQ(nearest("End tme", names), "End time");
  EXPECT_EQ(nearest("end time", names), "End time");
  EXPECT_EQ(nearest("Timestep", names), "Time step");
  EXPECT_EQ(nearest("Viscosity", names), "");
  EXPECT_EQ(nearest("x", {"ab"}), "");
}


TEST(Spelling, TrimmedAndJoined)
{
  EXPECT_EQ(trimmed(" \t a b \r\n"), "a b");
  EXPECT_EQ(trimmed("  "), "");
  EXPECT_EQ(joined({"a", "b", "c"}, "/"), "a/b/c");
  EXPECT_EQ(joined({}, "/"), "");
}
