// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/archive.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "../support/complaint.h"

namespace
{
  using Thalweg::Archive;
  struct Part
  {
    bool                     flag   = false;
    unsigned int             count  = 0;
    std::uint64_t            large  = 0;
    double                   number = 0;
    std::string              text;
    std::vector<double>      numbers;
    std::vector<std::string> words;

    void
    keep(const Archive &archive)
    {
      archive.value("flag", flag);
      archive.value("count", count);
      archive.value("large", large);
      archive.value("number", number);
      const Archive inner = archive.enter("a/b ~");
      inner.value("text", text);
      inner.value("numbers", numbers);
      inner.value("words", words);
    }
  };
} // namespace



TEST(Archive, GivesBackEveryBit)
{
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  Part             saved{true,
             7,
             1ull << 63,
             1. / 3.,
             "a \"word\"\n",
             {tiny, -0., HUGE_VAL, 0.1 + 0.2},
             {"", "x"}};
  const Archive    archive;
  saved.keep(archive.enter("part"));
  Part restored;
  restored.keep(Archive::restore(archive.bytes()).enter("part"));
  EXPECT_TRUE(restored.flag);
  EXPECT_EQ(restored.count, 7u);
  EXPECT_EQ(restored.large, 1ull << 63);
  EXPECT_EQ(restored.number, 1. / 3.);
  EXPECT_EQ(restored.text, saved.text);
  EXPECT_EQ(restored.numbers, saved.numbers);
  EXPECT_TRUE(std::signbit(restored.numbers[1]));
  EXPECT_EQ(restored.words, saved.words);
}



TEST(Archive, GivesBackNotANumber)
{
  std::vector<double> values{std::nan(""), 1.};
  const Archive       archive;
  archive.value("values", values);
  values.clear();
  Archive::restore(archive.bytes()).value("values", values);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_TRUE(std::isnan(values[0]));
}



TEST(Archive, NowhereLeavesValuesAlone)
{
  Part part;
  part.count = 3;
  part.keep(Archive::nowhere());
  EXPECT_EQ(part.count, 3u);
}



TEST(Archive, SaysWhatIsMissing)
{
  const Archive archive;
  double        value = 1.;
  archive.value("here", value);
  const Archive restored = Archive::restore(archive.bytes());
  EXPECT_TRUE(restored.has("here"));
  EXPECT_FALSE(restored.has("there"));
  EXPECT_NE(complaint_of([&]() {
              restored.value("there", value);
            }).find("'/there'"),
            std::string::npos);
  std::string text;
  EXPECT_NE(complaint_of([&]() {
              restored.value("here", text);
            }).find("'/here'"),
            std::string::npos);
  EXPECT_NE(complaint_of([&]() { restored.enter("inside"); }).find("'/inside'"),
            std::string::npos);
  EXPECT_NE(complaint_of([&]() {
              Archive::restore("no archive");
            }).find("damaged"),
            std::string::npos);
}



TEST(Archive, RefusesWhatIsNestedTooDeep)
{
  // Lists of one list each, which reading would follow until the stack ends.
  EXPECT_ANY_THROW(Archive::restore(std::string(1000000, '\x81')));
  EXPECT_ANY_THROW(Archive::restore("\xa1\x61"
                                    "a" +
                                    std::string(1000000, '\xc1')));
  // A list that says to have more entries than there are bytes.
  EXPECT_ANY_THROW(Archive::restore(std::string("\xa1\x61"
                                                "a\x9b\x7f\xff\xff\xff\xff") +
                                    "\xff\xff\xff"));
}
