// SPDX-License-Identifier: LGPL-2.1-or-later
// What a scalar makes of the viscosity of a fluid.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "support/input.h"
#include "support/resumed_case.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// Oil between a plate at rest and one above that moves, which is warmer.
  std::string
  between_plates(const std::string &mesh, const std::string &fluids)
  {
    return section("Geometry",
                   {"Periodic boundaries = left:right"},
                   section("box",
                           {"Repetitions = " + mesh,
                            "Upper corner = 0.25, 1"})) +
           section("Methods",
                   {"Names = oil: pfem2, heat: scalar"},
                   section("oil",
                           {},
                           fluids + section("Boundary conditions",
                                            {"Velocity = top: 1; 0",
                                             "No slip = bottom"})) +
                     section("heat",
                             {"Initial value = y", "Diffusivity = 1"},
                             section("Boundary conditions",
                                     {"Value = bottom: 0 | top: 1"}))) +
           section("Time", {"Time step = 0.1", "End time = 6"});
  }

  std::string
  viscosity(const std::vector<std::string> &law)
  {
    std::vector<std::string> settings{"Between = oil, heat"};
    settings.insert(settings.end(), law.begin(), law.end());
    return section("Couplings",
                   {"Names = softening: viscosity"},
                   section("softening", settings));
  }

  /// The largest difference of nodal velocities from a profile.
  template <typename Profile>
  double
  difference(const RunCase<2> &run, const Profile &profile)
  {
    const auto view    = run.simulation->view();
    const auto flow    = view.flow("oil");
    double     largest = 0.;
    for (unsigned int n = 0; n < flow.space.n_owned_nodes(); ++n)
      largest = std::max(largest,
                         std::abs(flow.velocity.local_element(2 * n) -
                                  profile(flow.space.position(n)[1])));
    return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }
} // namespace



// The stress is the same everywhere: u' = c / mu(y), which for exponentials is
// exact at the nodes.
TEST(ViscosityLawMpi, ShearFlowsHaveTheirProfileAtOnce)
{
  const auto profile = [](const double y) {
    return (std::exp(2. * y) - 1.) / (std::exp(2.) - 1.);
  };
  for (const std::vector<std::string> &law :
       {std::vector<std::string>{"Viscosity = exp(-2*s)"},
        std::vector<std::string>{
          "Table = 0: 1, 0.5: 0.36787944117144233, 1: 0.1353352832366127"}})
    {
      const RunCase<2> run(between_plates("3, 12", one_fluid(1., 7.)) +
                           viscosity(law));
      EXPECT_LT(difference(run, profile), 1e-6) << law[0];
      const double half = 1. / 24.;
      EXPECT_NEAR(run.last("softening: least viscosity [Pa s]"),
                  std::exp(-2. * (1. - half)),
                  1e-9);
      EXPECT_NEAR(run.last("softening: greatest viscosity [Pa s]"),
                  std::exp(-2. * half),
                  1e-9);
    }
}



// Of two layers one is softer where it is warmer; the other is what it is.
TEST(ViscosityLawMpi, ConcernsOneOfTwoFluids)
{
  const RunCase<2> run(
    between_plates("3, 12",
                   two_fluids(1., 1., 7., .5) +
                     section("Initial conditions", {"Level set = y - 0.5"})) +
    viscosity({"Fluid = water", "Viscosity = exp(-2*s)"}));
  // u' mu is the same: below int exp(2 y), above 2 (y - 1/2).
  const double below = .5 * (std::exp(1.) - 1.), above = 1.;
  EXPECT_LT(difference(run,
                       [&](const double y) {
                         return (y < .5 ? .5 * (std::exp(2. * y) - 1.)
                                        : below + 2. * (y - .5)) /
                                (below + above);
                       }),
            1e-3);
}



TEST(ViscosityLawMpi, GoesOnWhereItStopped)
{
  const std::string text =
    adapting_every_step("2", "3", "interface distance") +
    section("Methods",
            {"Names = oil: pfem2, heat: scalar"},
            section("oil",
                    {},
                    two_fluids(1000., 1., 1., .01) +
                      section("Initial conditions",
                              {"Level set = y - 0.4 - 0.2*x"})) +
              section("heat",
                      {"Initial value = x",
                       "Diffusivity = 0.01",
                       "Latent heat = water: 1, air: 0",
                       "Solidus = 0.5",
                       "Liquidus = 0.6"})) +
    viscosity({"Viscosity = if(f < 0.5, 100, 1)"}) +
    section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Time", {"Time step = 0.02", "End time = 0.2"});
  const RunCase<2>     whole(text);
  const ResumedCase<2> resumed(text, 4);
  for (const char *column : {"oil: kinetic energy [J]",
                             "heat: content",
                             "softening: greatest viscosity [Pa s]"})
    EXPECT_EQ(resumed->last(column), whole.last(column)) << column;
  EXPECT_EQ(whole.last("softening: greatest viscosity [Pa s]"), 100.);
  EXPECT_GT(whole.last("oil: kinetic energy [J]"), 0.);
}
