#include <algorithm>
#include <gtest/gtest.h>

#include "run_case.h"
#include "support/input.h"

namespace
{
  /// Water under air in a closed box for ten steps, solved tightly.
  std::string
  rest(const std::string &level_set,
       const std::string &gravity,
       const std::string &local_levels,
       const std::string &repetitions,
       const std::string &more = "")
  {
    return box_of(repetitions, local_levels) +
           section("Time", {"Time step = 0.01", "End time = 0.1"}) +
           section("Body forces", {"Gravity = " + gravity}) +
           section("Initial conditions", {"Level set = " + level_set}) +
           tight_solver("1e-13", "1e-13") + more;
  }



  template <int dim>
  double
  largest_velocity(const RunCase<dim> &run)
  {
    return std::max(run.last("max velocity 1 [m/s]"),
                    run.last("max velocity 2 [m/s]"));
  }

  const std::string plane = section("Particles", {"Distance band = 100"}) +
                            section("Projection", {"Model = least squares"});
} // namespace



TEST(Rest, FlatInterfaceStaysAtRest)
{
  for (const std::string height : {"0.41", "0.45", "0.4999"})
    {
      const RunCase<2> run(rest("y - " + height, "0, -9.81", "0", "10, 10"));
      EXPECT_LT(largest_velocity(run), 1e-9) << height;
    }
}



TEST(Rest, TiltedPlaneStaysAtRest)
{
  const RunCase<2> run(
    rest("-0.3*(x - 0.5) + 0.95*(y - 0.47)", "3, -9.5", "0", "8, 8", plane));
  EXPECT_LT(largest_velocity(run), 1e-9);
}



TEST(Rest, TiltedPlaneAcrossHangingNodesStaysAtRest)
{
  const RunCase<2> run(rest("-0.3*(x - 0.5) + 0.95*(y - 0.47)",
                            "3, -9.5",
                            "if(x < 0.4, 1, 0)",
                            "8, 8",
                            plane));
  EXPECT_LT(largest_velocity(run), 1e-9);
}



TEST(Rest, TiltedPlaneAcrossHangingNodesStaysAtRest3d)
{
  const RunCase<3> run(rest("-0.3*(x - 0.5) + 0.95*(z - 0.47)",
                            "3, 0, -9.5",
                            "if(x + y < 0.7, 1, 0)",
                            "4, 4, 4",
                            plane));
  EXPECT_LT(largest_velocity(run), 1e-9);
}



TEST(Rest, WithoutEnrichmentItMoves)
{
  const RunCase<2> run(rest("y - 0.45",
                            "0, -9.81",
                            "0",
                            "10, 10",
                            section("Interface", {"Enrichment = none"})));
  EXPECT_GT(largest_velocity(run), 1e-3);
}



TEST(RestMpi, TiltedPlaneOnAMeshThatAdaptsEveryStepStaysAtRest)
{
  const std::string wave = "if(abs(x - 8*t) < 0.2, 1, 0)";
  const RunCase<2>  run(
    rest("-0.3*(x - 0.5) + 0.95*(y - 0.47)", "3, -9.5", "0", "8, 8", plane) +
    adapting_every_step(
      "0", "1", "region", {"At least = " + wave, "At most = " + wave}));
  EXPECT_LT(largest_velocity(run), 1e-9);
  EXPECT_GT(run.last("adaptations"), 5.);
  EXPECT_EQ(run.last("particles lost"), 0.);
}



TEST(RestMpi, TiltedPlaneOnAMeshThatAdaptsEveryStepStaysAtRest3d)
{
  const std::string wave = "if(abs(x - 8*t) < 0.2, 1, 0)";
  const RunCase<3>  run(
    rest(
      "-0.3*(x - 0.5) + 0.95*(z - 0.47)", "3, 0, -9.5", "0", "4, 4, 4", plane) +
    adapting_every_step(
      "0", "1", "region", {"At least = " + wave, "At most = " + wave}));
  EXPECT_LT(largest_velocity(run), 1e-9);
  EXPECT_GT(run.last("adaptations"), 2.);
}
