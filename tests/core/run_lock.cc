// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/results.h>
#include <thalweg/core/run_lock.h>

#include <filesystem>
#include <gtest/gtest.h>
#include <memory>

#include "support/files.h"

using namespace Thalweg;
namespace fs = std::filesystem;

namespace
{
  /// An empty directory that is removed at the end.
  struct Directory
  {
    explicit Directory(const std::string &name)
      : path(own_path(name))
    {
      fs::remove_all(path);
      fs::create_directories(path);
    }

    ~Directory()
    {
      fs::remove_all(path);
    }

    void
    write(const std::string &name, const std::string &text) const
    {
      fs::create_directories(fs::path(path + "/" + name).parent_path());
      std::ofstream(path + "/" + name) << text;
    }

    std::string
    read(const std::string &name) const
    {
      return content(path + "/" + name);
    }

    const std::string path;
  };
} // namespace



TEST(RunLock, KeepsADirectoryForOneRun)
{
  const Directory directory("locked");
  auto            first = std::make_unique<RunLock>(directory.path);
  try
    {
      const RunLock second(directory.path);
      FAIL() << "Two runs have one directory.";
    }
  catch (const std::exception &failure)
    {
      const std::string message = message_of(failure);
      EXPECT_NE(message.find(directory.path), std::string::npos);
      EXPECT_NE(message.find("process " + std::to_string(::getpid())),
                std::string::npos)
        << message;
    }
  first->expect_directory();
  first.reset();
  EXPECT_FALSE(fs::exists(directory.path + "/lock"));
}



TEST(RunLock, OfAProcessThatIsGoneIsVoid)
{
  const Directory directory("stale");
  directory.write("lock", "elsewhere 12345\n");
  const RunLock lock(directory.path);
  EXPECT_NE(directory.read("lock").find(std::to_string(::getpid())),
            std::string::npos);
}



TEST(RunLock, NoticesThatTheDirectoryIsGone)
{
  const Directory directory("vanishing");
  {
    const RunLock lock(directory.path);
    fs::rename(directory.path, directory.path + ".moved");
    EXPECT_ANY_THROW(lock.expect_directory());
    fs::create_directories(directory.path);
    EXPECT_ANY_THROW(lock.expect_directory());
  }
  fs::remove_all(directory.path + ".moved");
}



TEST(Results, OfAnEarlierRunAreMovedAside)
{
  const Directory directory("rerun");
  const auto      run = [&](const std::string &text) {
    Results results;
    results.open(directory.path);
    results.add("front.csv");
    results.add("fields");
    directory.write("front.csv", text);
    directory.write("fields/fields_0000.vtu", text);
    directory.write("statistics.csv", text);
  };
  run("first");
  directory.write("notes.txt", "of the user");
  EXPECT_EQ(Results::set_aside(directory.path), directory.path + "/old");
  EXPECT_FALSE(fs::exists(directory.path + "/fields"));
  EXPECT_FALSE(fs::exists(directory.path + "/front.csv"));
  EXPECT_EQ(directory.read("old/fields/fields_0000.vtu"), "first");
  EXPECT_EQ(directory.read("old/statistics.csv"), "first");
  EXPECT_EQ(directory.read("notes.txt"), "of the user");

  run("second");
  EXPECT_EQ(Results::set_aside(directory.path), directory.path + "/old.2");
  EXPECT_EQ(directory.read("old/front.csv"), "first");
  EXPECT_EQ(directory.read("old.2/front.csv"), "second");

  // A run that came to nothing leaves nothing.
  run("");
  EXPECT_EQ(Results::set_aside(directory.path), "");
  EXPECT_FALSE(fs::exists(directory.path + "/front.csv"));
  EXPECT_EQ(directory.read("notes.txt"), "of the user");
}
