// SPDX-License-Identifier: LGPL-2.1-or-later
#include <string>

#include "support/resumed_case.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// A drop a hundred times as dense as the gas, on a mesh that follows it.
  std::string
  adapting_drop(const std::string &level_set)
  {
    return adapting_every_step("3", "5", "interface distance") +
           two_fluids(100., 1., .06, 1e-3) +
           section("Interface",
                   {},
                   section("Surface tension", {"Coefficient = 1"})) +
           section("Initial conditions", {"Level set = " + level_set}) +
           section("Time", {"Time step = 0.02", "End time = 0.4"});
  }
} // namespace



// Fifty times slower than the gas could be, sqrt(sigma / (rho R)) = 2 m/s.
TEST(SurfaceTensionRuns, DropsStayAtRestOnMeshesThatAdapt)
{
  const RunCase<2> run(adapting_drop("sqrt((x-0.513)^2 + (y-0.479)^2) - 0.25"));
  EXPECT_LT(run.last("max velocity 1 [m/s]"), .01);
  EXPECT_LT(run.last("max velocity 2 [m/s]"), .04);
  EXPECT_EQ(run.last("drops of volume 1 [m^d]"), 0.);
}



TEST(SurfaceTensionRuns, ResumedTheyHaveTheSameBits)
{
  const std::string    text = adapting_drop("x^2 + 1.3*y^2 - 0.3");
  const RunCase<2>     whole(text);
  const ResumedCase<2> resumed(text, 7);
  for (const char *column :
       {"kinetic energy [J]", "max velocity 2 [m/s]", "volume 1 [m^d]"})
    EXPECT_EQ(resumed->last(column), whole.last(column)) << column;
  EXPECT_GT(whole.last("kinetic energy [J]"), 0.);
}
