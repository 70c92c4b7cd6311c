// SPDX-License-Identifier: LGPL-2.1-or-later
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
  EXPECT_THROW(statistics.open("/dev/null/statistics.csv"),
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


namespace
{
  /// Fills and ends the row of a step.
  void
  end_step(Statistics &statistics, const unsigned int step)
  {
    statistics.set("step", step);
    statistics.set("time [s]", step / 3.);
    if (step % 2 == 0)
      statistics.add("seldom", 1.);
    statistics.end_row();
  }


  void
  begin(Statistics &statistics, const std::string &path, const bool resumed)
  {
    statistics.declare({"time [s]", "nowhere"});
    statistics.open(path, resumed);
  }
} // namespace


TEST(Statistics, GoOnAfterACheckpointAsIfNothingHadHappened)
{
  const std::string straight_path = own_path("straight.csv");
  Statistics        straight;
  begin(straight, straight_path, false);
  for (unsigned int step = 2; step < 9; ++step)
    end_step(straight, step);

  Log               log(true);
  const std::string path = own_path("resumed.csv");
  for (const unsigned int stop : {2u, 3u, 6u})
    {
      const Archive archive;
      {
        Statistics statistics;
        begin(statistics, path, false);
        for (unsigned int step = 2; step < stop; ++step)
          end_step(statistics, step);
        statistics.keep(archive, log);
        // Until it was killed.
        for (unsigned int step = stop; step < 8; ++step)
          end_step(statistics, step);
        std::ofstream(path, std::ios::app) << "0.3";
      }
      Statistics statistics;
      begin(statistics, path, true);
      statistics.set("only at the start", 1.);
      statistics.keep(Archive::restore(archive.bytes()), log);
      EXPECT_FALSE(statistics.has("only at the start"));
      EXPECT_EQ(statistics.has("time [s]"), stop > 2);
      for (unsigned int step = stop; step < 9; ++step)
        end_step(statistics, step);
      EXPECT_EQ(content(path), content(straight_path));
      EXPECT_EQ(statistics.column_names(), straight.column_names());
    }
  std::remove(path.c_str());
  std::remove(straight_path.c_str());
}


TEST(Statistics, BeginAnewWhereTheFileIsGone)
{
  const std::string path = own_path("gone.csv");
  const std::string said = own_path("gone.txt");
  const Archive     archive;
  Log               log(true);
  log.open(said);
  {
    Statistics statistics;
    begin(statistics, path, false);
    end_step(statistics, 2);
    statistics.keep(archive, log);
  }
  EXPECT_EQ(content(said), "");
  std::remove(path.c_str());
  Statistics statistics;
  begin(statistics, path, true);
  statistics.keep(Archive::restore(archive.bytes()), log);
  end_step(statistics, 3);
  EXPECT_EQ(content(path), "time [s],step,seldom\n1,3,\n");
  EXPECT_NE(content(said).find("Warning: The file '" + path),
            std::string::npos);
  std::remove(path.c_str());
  std::remove(said.c_str());
}
