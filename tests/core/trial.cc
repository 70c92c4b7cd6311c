// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/trial.h>

#include <csignal>
#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>
#include <vector>

using namespace Thalweg;


TEST(Trial, LeavesNothing)
{
  int n = 1;
  EXPECT_EQ(fault_in_trial([&n]() { n = 2; }), "");
  EXPECT_EQ(n, 1);
}


TEST(Trial, TellsExceptions)
{
  EXPECT_EQ(fault_in_trial([]() { throw std::runtime_error("broken"); }),
            "broken");
}


TEST(Trial, SurvivesCrashes)
{
  EXPECT_EQ(fault_in_trial([]() { std::raise(SIGSEGV); }),
            "it crashed (Segmentation fault)");
  EXPECT_EQ(fault_in_trial([]() { ::_exit(3); }), "it ended");
}


TEST(Trial, EndsWhatDoesNotEnd)
{
  EXPECT_EQ(fault_in_trial(
              []() {
                for (volatile bool go = true; go;)
                  ;
              },
              {1, 1.}),
            "it took longer than 1 s");
}


TEST(Trial, KeepsMemory)
{
  EXPECT_NE(fault_in_trial(
              []() {
                std::vector<char> much(2000000000);
                much[much.size() / 2] = 1;
              },
              {5, .1})
              .find("memory"),
            std::string::npos);
}
