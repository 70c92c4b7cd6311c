// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>

#include <gtest/gtest.h>

using namespace Thalweg;


TEST(PlainText, KeepsWhatCanBeRead)
{
  EXPECT_EQ(excerpt("Höhe = 3 µm, 水"), "Höhe = 3 µm, 水");
  EXPECT_EQ(bounded_message("a\n\tb"), "a\n\tb");
}


TEST(PlainText, ShowsControlCharacters)
{
  EXPECT_EQ(excerpt("\x1b[2J\a"), "\\x1b[2J\\x07");
  EXPECT_EQ(excerpt("a\nb"), "a\\x0ab");
  EXPECT_EQ(bounded_message("a\rb"), "a\\x0db");
  EXPECT_EQ(excerpt(std::string("a\0b", 3)), "a\\x00b");
}


TEST(PlainText, ShowsBytesThatAreNoCharacters)
{
  EXPECT_EQ(excerpt("\xff"), "\\xff");
  EXPECT_EQ(excerpt("a\xc3"), "a\\xc3");                 // breaks off
  EXPECT_EQ(excerpt("\xc0\x80"), "\\xc0\\x80");          // too long for a zero
  EXPECT_EQ(excerpt("\xc2\x9b"), "\\xc2\\x9b");          // a control character
  EXPECT_EQ(excerpt("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // half a pair
}


TEST(PlainText, CutsWhatIsTooLong)
{
  const std::string text = std::string(500, 'a') + std::string(500, 'z');
  const std::string cut  = excerpt(text, 40);
  EXPECT_EQ(cut, "aaaaaaaaaaaaaaaaaaaa[... 970 bytes ...]zzzzzzzzzz");
  // What is short, but not when it is shown.
  std::string shown;
  for (unsigned int i = 0; i < 41; ++i)
    shown += "\\x01";
  EXPECT_EQ(excerpt(std::string(41, '\1'), 160), shown);
  EXPECT_EQ(bounded_message(text, 10), "aaaaaaaaaa[... 990 bytes ...]");
  EXPECT_EQ(bounded_message("aaaaaaaaaaä", 11), "aaaaaaaaaa[... 2 bytes ...]");
}
