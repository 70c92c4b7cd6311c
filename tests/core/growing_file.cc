// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/growing_file.h>

#include <filesystem>
#include <gtest/gtest.h>

#include "support/files.h"

using namespace Thalweg;
namespace fs = std::filesystem;

namespace
{
  /// A path of its own, with what is made of it removed at the end.
  struct Place
  {
    explicit Place(const std::string &name)
      : path(own_path(name))
    {}

    ~Place()
    {
      fs::remove(path);
      fs::remove(path + ".old");
      fs::remove(path + ".old.2");
    }

    const std::string path;
  };
} // namespace



TEST(GrowingFile, IsCutToWhatItWas)
{
  const Place   place("cut.csv");
  std::uint64_t length;
  {
    GrowingFile file;
    file.create(place.path, "a,b\n");
    file.append("1,2\n");
    length = file.length();
    // A whole row, and one that a killed process left.
    file.append("3,4\n5,");
  }
  GrowingFile file;
  EXPECT_EQ(file.reopen(place.path, "a,b\n", length), "");
  EXPECT_EQ(file.length(), length);
  EXPECT_EQ(content(place.path), "a,b\n1,2\n");
  file.append("6,7\n");
  EXPECT_EQ(content(place.path), "a,b\n1,2\n6,7\n");
  EXPECT_EQ(file.length(), 12u);
}



TEST(GrowingFile, BeginsAnewWhereItIsNotWhatItWas)
{
  const Place place("anew.csv");
  GrowingFile file;
  std::string message = file.reopen(place.path, "a\n", 6);
  EXPECT_NE(message.find(place.path + "' that the run had written is missing"),
            std::string::npos)
    << message;
  EXPECT_EQ(content(place.path), "a\n");

  file.append("1\n");
  message = file.reopen(place.path, "a\n", 6);
  EXPECT_NE(message.find("is shorter"), std::string::npos) << message;
  EXPECT_EQ(content(place.path), "a\n");
  EXPECT_EQ(content(place.path + ".old"), "a\n1\n");

  file.append("2\n3\n");
  message = file.reopen(place.path, "b\n", 6);
  EXPECT_NE(message.find("has other columns"), std::string::npos) << message;
  EXPECT_EQ(content(place.path), "b\n");
  EXPECT_EQ(content(place.path + ".old"), "a\n1\n");
  EXPECT_EQ(content(place.path + ".old.2"), "a\n2\n3\n");

  EXPECT_ANY_THROW(file.reopen("/dev/null/file", "a\n", 2));
  EXPECT_ANY_THROW(file.create("/dev/full", "a\n"));
}



TEST(GrowingFile, DoesNotWriteIntoNowhere)
{
  const Place place("removed.csv");
  GrowingFile file;
  file.create(place.path, "a\n");
  fs::remove(place.path);
  try
    {
      file.append("1\n");
      FAIL() << "The file is gone.";
    }
  catch (const std::exception &failure)
    {
      EXPECT_NE(Thalweg::message_of(failure).find(place.path),
                std::string::npos);
    }
}



TEST(GrowingFile, KeepsWhatTheRunDoesNotKnow)
{
  const Place place("unknown.csv");
  GrowingFile file;
  EXPECT_EQ(file.begin_anew(place.path, "a\n"), "");
  file.append("1\n");
  GrowingFile other;
  EXPECT_NE(other.begin_anew(place.path, "a\n").find(place.path + ".old"),
            std::string::npos);
  EXPECT_EQ(content(place.path + ".old"), "a\n1\n");
  EXPECT_EQ(content(place.path), "a\n");
}
