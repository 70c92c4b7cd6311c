// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/flux_balance.h>

#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  /// What is said of given velocities at @p time.
  template <int dim>
  std::string
  balance_complaint(const std::string &geometry,
                    const std::string &velocities,
                    const double       time = 0.,
                    const std::string &more = "Slip = ")
  {
    Scene<dim> scene(geometry + section("Boundary conditions",
                                        {"Velocity = " + velocities, more}));
    return complaint_of(
      [&]() { check_flux_balance(*scene.conditions, scene.mesh, time); });
  }

  const std::string profile = "left: 4*y*(1-y); 0 | right: ";
} // namespace



TEST(FluxBalance, LetsWhatBalancesPass)
{
  for (const char *right : {"4*y*(1-y); 0", "2/3; 0", "6*y^2*(1-y)*4/3; 0"})
    EXPECT_EQ(balance_complaint<2>(unit_box<2>(3), profile + right), "")
      << right;
  EXPECT_EQ(balance_complaint<2>(unit_box<2>(4), "top: sin(x); 0"), "");
}



TEST(FluxBalance, LetsVelocitiesThatJumpInsideOfFacesPass)
{
  for (const char *place : {"0.4", "0.5", "0.61"})
    EXPECT_EQ(balance_complaint<2>(unit_box<2>(5),
                                   std::string("left: if(y < ") + place +
                                     ", 1, 0); 0 | right: " + place + "; 0"),
              "")
      << place;
}



TEST(FluxBalance, RefusesANetFluxWithTheNumbers)
{
  const auto text =
    balance_complaint<2>(unit_box<2>(4), "left: 1; 0 | right: 0.999; 0");
  EXPECT_NE(text.find("let 1 m^2/s in and 0.999 m^2/s out (1 in through "
                      "'left', 0.999 out through 'right')"),
            std::string::npos)
    << text;
  EXPECT_NE(
    balance_complaint<3>(unit_box<3>(2), "front: 0; 0; x").find("0.5 m^3/s"),
    std::string::npos);
}



TEST(FluxBalance, AnOpenBoundaryMakesUpForAll)
{
  EXPECT_EQ(
    balance_complaint<2>(unit_box<2>(4), "left: 1; 0", 0., "Open = top: 0"),
    "");
}



TEST(FluxBalance, IsThatOfTheTime)
{
  const std::string velocities = "left: 1; 0 | right: 1 + t; 0";
  EXPECT_EQ(balance_complaint<2>(unit_box<2>(4), velocities, 0.), "");
  EXPECT_NE(
    balance_complaint<2>(unit_box<2>(4), velocities, .5).find("At t = 0.5 s"),
    std::string::npos);
}



TEST(FluxBalance, CountsCurvedSidesAsCurved)
{
  const std::string ring =
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0,0 : 1 : 2 : 7 : true"}));
  const std::string source = "x/(x^2+y^2); y/(x^2+y^2)";
  EXPECT_EQ(balance_complaint<2>(ring, "0: " + source + " | 1: " + source), "");
  EXPECT_EQ(balance_complaint<2>(ring, "0: -y; x"), "");
}
