// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/pattern_words.h>

#include <deal.II/base/patterns.h>

#include <gtest/gtest.h>
#include <limits>

using namespace Thalweg;
using namespace dealii::Patterns;

namespace
{
  std::string
  words(const PatternBase &pattern)
  {
    return in_words(pattern.description());
  }
} // namespace



TEST(PatternWords, Numbers)
{
  EXPECT_EQ(words(Double()), "a number");
  EXPECT_EQ(words(Double(0.)), "a number that is at least 0");
  EXPECT_EQ(words(Double(std::numeric_limits<double>::min())),
            "a number greater than 0");
  EXPECT_EQ(words(Double(-1., 2.5)), "a number from -1 to 2.5");
  EXPECT_EQ(words(Double(Double::min_double_value, 3.)),
            "a number that is at most 3");
  EXPECT_EQ(words(Integer()), "a whole number");
  EXPECT_EQ(words(Integer(1)), "a whole number that is at least 1");
  EXPECT_EQ(words(Integer(2, 3)), "a whole number from 2 to 3");
}


TEST(PatternWords, Names)
{
  EXPECT_EQ(words(Bool()), "'true' or 'false'");
  EXPECT_EQ(words(Selection("a")), "'a'");
  EXPECT_EQ(words(Selection("no slip|slip|open")),
            "'no slip', 'slip' or 'open'");
  EXPECT_EQ(words(Anything()), "any text");
}


TEST(PatternWords, Lists)
{
  EXPECT_EQ(words(List(Double(), 2, 2)),
            "2 items separated by commas, each a number");
  EXPECT_EQ(words(List(Integer(1), 1, 3, ";")),
            "1 to 3 items separated by semicolons, each a whole number that "
            "is at least 1");
  EXPECT_EQ(words(List(Selection("a|b"))),
            "items separated by commas, each 'a' or 'b'");
  EXPECT_EQ(words(List(Anything())), "items separated by commas");
  EXPECT_EQ(words(List(Double(), 1)),
            "at least 1 items separated by commas, each a number");
}


TEST(PatternWords, NestedOnes)
{
  // deal.II's pattern_factory() ends in a segmentation fault over this one.
  const List point(Double(), 2, 2);
  EXPECT_EQ(words(List(Tuple(":", point, point), 0, 5, ";")),
            "0 to 5 items separated by semicolons, each 2 parts separated by "
            "colons, each 2 items separated by commas, each a number");
  EXPECT_EQ(words(Tuple(";", Anything(), Integer(0))),
            "2 parts separated by semicolons: any text; a whole number that "
            "is at least 0");
  EXPECT_EQ(words(Map(Anything(), Integer())),
            "items 'KEY:VALUE' separated by commas, KEY being any text and "
            "VALUE a whole number");
}



TEST(PatternWords, NearestName)
{
  EXPECT_EQ(nearest_in(Selection("box|file").description(), "bxo"), "box");
  EXPECT_EQ(nearest_in(List(Selection("front|forces|probes")).description(),
                       "front, prbes"),
            "probes");
  EXPECT_EQ(nearest_in(List(Selection("front")).description(), "front"), "");
  EXPECT_EQ(nearest_in(Double().description(), "bxo"), "");
}


TEST(PatternWords, NamesThatComeTwice)
{
  const dealii::Patterns::List names{dealii::Patterns::Selection("a|b|c d")};
  EXPECT_EQ(repeated_in(names.description(), "a, c d,b,c d"), "c d");
  EXPECT_EQ(repeated_in(names.description(), "a, b"), "");
  EXPECT_EQ(repeated_in(
              dealii::Patterns::List(dealii::Patterns::Double()).description(),
              "1, 1"),
            "");
}
