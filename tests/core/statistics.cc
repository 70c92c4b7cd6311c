#include <thalweg/core/statistics.h>

#include <deal.II/base/exceptions.h>

#include <cstdio>
#include <gtest/gtest.h>

#include "support/files.h"

using namespace Thalweg;


TEST(Statistics, AddsWithinARowAndRemembersTheLast)
{
  Statistics statistics;
  EXPECT_FALSE(statistics.has("lost"));
  EXPECT_ANY_THROW(statistics.get("lost"));
  statistics.add("lost", 1.);
  statistics.add("lost", 2.);
  EXPECT_EQ(statistics.get("lost"), 3.);
  statistics.end_row();
  EXPECT_TRUE(statistics.has("lost"));
  EXPECT_EQ(statistics.get("lost"), 3.);
  statistics.add("lost", 5.);
  EXPECT_EQ(statistics.get("lost"), 5.);
}


TEST(Statistics, WritesHeaderAndRows)
{
  const std::string path = own_path("statistics.csv");
  Statistics        statistics;
  statistics.open(path);
  statistics.set("step", 1.);
  statistics.set("time [s]", 0.125);
  statistics.end_row();
  statistics.set("time [s]", 0.25);
  statistics.end_row();
  EXPECT_EQ(content(path), "step,time [s]\n1,0.125\n,0.25\n");
  std::remove(path.c_str());
}


TEST(Statistics, RefusesAPathThatCannotBeWritten)
{
  Statistics statistics;
  EXPECT_THROW(statistics.open("/nonexistent/statistics.csv"),
               dealii::StandardExceptions::ExcMessage);
}


TEST(Statistics, BeginsWithTheDeclaredColumnsThatTheFirstRowHas)
{
  const std::string path = own_path("ordered.csv");
  Statistics        statistics;
  statistics.declare({"step", "time [s]", "particles"});
  statistics.open(path);
  statistics.set("iterations", 7.);
  statistics.set("time [s]", 0.125);
  statistics.set("step", 1.);
  statistics.end_row();
  statistics.set("particles", 3.);
  statistics.set("step", 2.);
  statistics.end_row();
  EXPECT_EQ(content(path), "step,time [s],iterations\n1,0.125,7\n2,,\n");
  std::remove(path.c_str());
}
