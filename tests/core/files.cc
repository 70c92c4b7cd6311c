// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/files.h"

#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>

using namespace Thalweg;
namespace fs = std::filesystem;

namespace
{
  /// As long as it lives, files cannot grow beyond so many bytes: writing
  /// fails as on a full disk.
  class SmallDisk
  {
  public:
    explicit SmallDisk(const rlim_t n_bytes)
      : old_handler(std::signal(SIGXFSZ, SIG_IGN))
    {
      ::getrlimit(RLIMIT_FSIZE, &old);
      const struct rlimit limit = {n_bytes, old.rlim_max};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~SmallDisk()
    {
      ::setrlimit(RLIMIT_FSIZE, &old);
      std::signal(SIGXFSZ, old_handler);
    }

  private:
    void (*old_handler)(int);
    struct rlimit old;
  };



  std::string
  failure_of(const std::function<void()> &work)
  {
    try
      {
        work();
      }
    catch (const std::exception &failure)
      {
        return message_of(failure);
      }
    return "";
  }
} // namespace



TEST(Files, AreWrittenWhollyOrNotAtAll)
{
  const std::string path = own_path("whole.txt");
  write_file(path, "before");
  {
    const SmallDisk   disk(1000);
    const std::string failure =
      failure_of([&]() { write_file(path, std::string(2000, 'x')); });
    EXPECT_NE(failure.find(path), std::string::npos) << failure;
    EXPECT_NE(failure.find("File too large"), std::string::npos) << failure;
  }
  EXPECT_EQ(content(path), "before");
  EXPECT_FALSE(fs::exists(path + ".part"));
  write_file(path, std::string(2000, 'x'), Durability::on_disk);
  EXPECT_EQ(read_file(path), std::string(2000, 'x'));
  fs::remove(path);
}



TEST(Files, ChecksumIsThatOfThePieces)
{
  const std::string path = own_path("pieces");
  const std::string a = "some ", b = "bytes";
  write_file(path, {bytes_of(a), bytes_of(b)}, Durability::on_disk);
  EXPECT_EQ(content(path), "some bytes");
  EXPECT_EQ(checksum_of({bytes_of(a), bytes_of(b)}), checksum_of_file(path));
  char three[3];
  read_range(path, 2, three, 3);
  EXPECT_EQ(std::string(three, 3), "me ");
  EXPECT_NE(failure_of([&]() { read_range(path, 8, three, 3); }).find(path),
            std::string::npos);
  fs::remove(path);
  EXPECT_NE(failure_of([&]() { read_file(path); }).find("No such file"),
            std::string::npos);
}



TEST(Files, AreMovedAsideToFreeNames)
{
  const std::string path = own_path("aside");
  for (const std::string name : {".old", ".old.2", ".old.3"})
    {
      write_file(path, name);
      EXPECT_EQ(move_aside(path), path + name);
      EXPECT_FALSE(fs::exists(path));
    }
  for (const std::string name : {".old", ".old.2", ".old.3"})
    {
      EXPECT_EQ(content(path + name), name);
      fs::remove(path + name);
    }
}
