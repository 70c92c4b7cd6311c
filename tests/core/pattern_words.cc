#include <thalweg/core/pattern_words.h>

#include <gtest/gtest.h>
#include <limits>

using namespace Thalweg;
using namespace dealii::Patterns;

namespace
{
  /// The words for @p pattern, which must be the same for the pattern that
  /// deal.II makes out of its description.
  std::string
  words(const PatternBase &pattern)
  {
    const std::string direct = in_words(pattern);
    EXPECT_EQ(in_words(*pattern_factory(pattern.description())), direct);
    return direct;
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
  EXPECT_EQ(words(List(Double(), 1)),
            "at least 1 items separated by commas, each a number");
}


TEST(PatternWords, NearestName)
{
  EXPECT_EQ(nearest_in(Selection("box|file"), "bxo"), "box");
  EXPECT_EQ(nearest_in(List(Selection("front|forces|probes")), "front, prbes"),
            "probes");
  EXPECT_EQ(nearest_in(List(Selection("front")), "front"), "");
  EXPECT_EQ(nearest_in(Double(), "bxo"), "");
}
