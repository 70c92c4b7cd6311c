// SPDX-License-Identifier: LGPL-2.1-or-later
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <string>

TEST(MpiSession, SleepsWhereOpenMpiYields)
{
  Dl_info     place;
  void *const function = dlsym(RTLD_DEFAULT, "sched_yield");
  ASSERT_NE(function, nullptr);
  ASSERT_NE(dladdr(function, &place), 0);
  EXPECT_NE(std::string(place.dli_fname).find("libthalweg"), std::string::npos)
    << place.dli_fname;
}
