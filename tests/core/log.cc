// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/files.h>
#include <thalweg/core/log.h>

#include <filesystem>
#include <gtest/gtest.h>

#include "support/files.h"

using namespace Thalweg;



TEST(Log, BoundsWarnings)
{
  const std::string path = own_path("log.txt");
  Log               log(true);
  log.open(path, false);
  log.warning(std::string(1000000, 'x'));
  const std::string text = read_file(path);
  EXPECT_EQ(text.substr(0, 10), "Warning: x");
  EXPECT_LT(text.size(), 4096u);
  std::filesystem::remove(path);
}
