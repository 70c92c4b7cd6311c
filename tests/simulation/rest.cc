#include <algorithm>
#include <gtest/gtest.h>

#include "run_case.h"

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
    return "subsection Geometry\n subsection box\n  set Repetitions = " +
           repetitions +
           "\n end\nend\n"
           "subsection Refinement\n set Local levels = " +
           local_levels +
           "\nend\n"
           "subsection Time\n set Time step = 0.01\n set End time = 0.1\nend\n"
           "subsection Body forces\n set Gravity = " +
           gravity +
           "\nend\n"
           "subsection Initial conditions\n set Level set = " +
           level_set +
           "\nend\n"
           "subsection Fluid solver\n subsection fractional step\n"
           "  set Pressure tolerance = 1e-13\n"
           "  set Velocity tolerance = 1e-13\n end\nend\n" +
           more;
  }



  template <int dim>
  double
  largest_velocity(const RunCase<dim> &run)
  {
    return std::max(run.last("max velocity 1 [m/s]"),
                    run.last("max velocity 2 [m/s]"));
  }

  const std::string plane =
    "subsection Particles\n set Distance band = 100\nend\n"
    "subsection Projection\n set Model = least squares\nend\n";
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
  const RunCase<2> run(
    rest("y - 0.45",
         "0, -9.81",
         "0",
         "10, 10",
         "subsection Interface\n set Enrichment = none\nend\n"));
  EXPECT_GT(largest_velocity(run), 1e-3);
}
