// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/text_file.h>

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/complaint.h"
#include "support/files.h"

using namespace Thalweg;

namespace
{
  std::string
  complaint_about(const std::string &path)
  {
    return complaint_of([&path]() { read_text_file(path, "The file", 10); });
  }
} // namespace


TEST(TextFile, IsReadWhole)
{
  const std::string path = own_path("text_file");
  std::ofstream(path) << "0123456789";
  EXPECT_EQ(read_text_file(path, "It", 10).content, "0123456789");
  std::ofstream(path, std::ios::app) << "x";
  EXPECT_EQ(complaint_about(path),
            "The file cannot be read: it has 11 bytes, more than the 10 that "
            "such a file can have. Is it the right one?");
  std::remove(path.c_str());
  EXPECT_EQ(complaint_about(path),
            "The file cannot be read: No such file or directory");
}


TEST(TextFile, MustBePlain)
{
  EXPECT_EQ(complaint_about("/"),
            "The file cannot be read: it is a directory, not a file.");
  EXPECT_EQ(complaint_about("/dev/zero")
              .find("The file cannot be read: it is a pipe or a device"),
            0u);
  const std::string path = own_path("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_NE(complaint_about(path).find("pipe"), std::string::npos);
  std::remove(path.c_str());
}


TEST(TextFile, ThatBreaksOffIsRefused)
{
  // Nothing is at the address 0 of this process.
  EXPECT_EQ(complaint_about("/proc/self/mem"),
            "The file cannot be read: after 0 bytes: Input/output error");
}


TEST(TextFile, LineEndsOfOtherSystems)
{
  EXPECT_EQ(plain_lines("a\r\nb\rc\n", "It"), "a\nb\nc\n");
  EXPECT_EQ(plain_lines("\xEF\xBB\xBF"
                        "a",
                        "It"),
            "a");
  EXPECT_NE(complaint_of([]() {
              plain_lines("\xFF\xFEx", "It");
            }).find("It is not plain text"),
            std::string::npos);
  EXPECT_NE(complaint_of([]() {
              plain_lines(std::string("a\0", 2), "It");
            }).find("It is not plain text"),
            std::string::npos);
}


TEST(TextFile, HomeDirectories)
{
  const char *const before = std::getenv("HOME");
  const std::string home   = before == nullptr ? "" : before;
  setenv("HOME", "/home/a", 1);
  EXPECT_EQ(with_home("~"), "/home/a");
  EXPECT_EQ(with_home("~/b"), "/home/a/b");
  EXPECT_EQ(with_home("b/~"), "b/~");
  EXPECT_EQ(with_home("~b"), "~b");
  EXPECT_NE(complaint_of([]() { with_home("~b/c"); }).find("'~b/c'"),
            std::string::npos);
  unsetenv("HOME");
  EXPECT_NE(complaint_of([]() { with_home("~/b"); }).find("HOME"),
            std::string::npos);
  if (before != nullptr)
    setenv("HOME", home.c_str(), 1);
}
