#include <cmath>
#include <gtest/gtest.h>

#include "run_case.h"

namespace
{
  /// A column that collapses, solved tightly, for twenty steps.
  std::string
  collapse(const std::string &repetitions,
           const std::string &local_levels,
           const std::string &gravity,
           const std::string &level_set)
  {
    return "subsection Geometry\n subsection box\n  set Repetitions = " +
           repetitions +
           "\n end\nend\n"
           "subsection Refinement\n set Local levels = " +
           local_levels +
           "\nend\n"
           "subsection Time\n set Time step = 0.01\n set End time = 0.2\nend\n"
           "subsection Body forces\n set Gravity = " +
           gravity +
           "\nend\n"
           "subsection Initial conditions\n set Level set = " +
           level_set +
           "\nend\n"
           "subsection Boundary conditions\n set Open = top: 0\nend\n"
           "subsection Fluid solver\n subsection fractional step\n"
           "  set Pressure tolerance = 1e-11\n"
           "  set Velocity tolerance = 1e-12\n end\nend\n";
  }



  /// Every process also runs the case alone; both must agree.
  template <int dim>
  void
  compare_with_one_process(const std::string &text)
  {
    const RunCase<dim> together(text), alone(text, MPI_COMM_SELF);
    for (const std::string column : {"kinetic energy [J]",
                                     "potential energy [J]",
                                     "volume 1 before shift [m^d]",
                                     "volume 1 [m^d]",
                                     "max velocity 1 [m/s]",
                                     "max velocity 2 [m/s]"})
      EXPECT_NEAR(together.last(column),
                  alone.last(column),
                  1e-6 * std::abs(alone.last(column)))
        << column;
    EXPECT_EQ(together.last("particles"), alone.last("particles"));
    EXPECT_EQ(together.last("particles lost"), 0.);
  }
} // namespace



TEST(RanksMpi, DamBreak2d)
{
  compare_with_one_process<2>(collapse(
    "12, 12", "if(y < 0.3, 1, 0)", "0, -9.81", "max(x - 0.31, y - 0.62)"));
}



TEST(RanksMpi, DamBreak3d)
{
  compare_with_one_process<3>(collapse(
    "6, 6, 6", "if(x < 0.5, 1, 0)", "0, -9.81, 0", "max(x - 0.31, y - 0.62)"));
}



TEST(Ranks, TwoRunsAgreeToTheLastBit)
{
  const std::string text =
    collapse("12, 12", "0", "0, -9.81", "max(x - 0.31, y - 0.62)");
  const RunCase<2> first(text), second(text);
  for (const std::string column : {"kinetic energy [J]",
                                   "volume 1 before shift [m^d]",
                                   "max velocity 2 [m/s]",
                                   "particles"})
    EXPECT_EQ(first.last(column), second.last(column)) << column;
}
