// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/materials/fluids.h>

#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  /// Reads @p settings and checks them.
  struct Input
  {
    explicit Input(const std::string &settings)
    {
      fluids.declare_parameters(Section(prm));
      prm.parse_input_from_string(settings);
      complaint = complaint_of([&]() { fluids.check(); });
    }

    dealii::ParameterHandler prm;
    Fluids                   fluids;
    std::string              complaint;
  };
} // namespace



TEST(Fluids, AreWaterAndAirUnlessOthersAreGiven)
{
  const Input input("");
  EXPECT_EQ(input.complaint, "");
  ASSERT_EQ(input.fluids.size(), 2u);
  EXPECT_EQ(input.fluids.index("water"), 0u);
  EXPECT_EQ(input.fluids.index("air"), 1u);
  EXPECT_EQ(input.fluids[0].density, 1000.);
  EXPECT_EQ(&input.fluids.at(-1e-30), &input.fluids[0]);
  EXPECT_EQ(&input.fluids.at(0.), &input.fluids[1]);
  EXPECT_EQ(Fluids::sign(0), -1.);
  EXPECT_EQ(Fluids::sign(1), 1.);
}



TEST(Fluids, OfOneNothingElseIsAsked)
{
  const Input input(section("Fluids",
                            {"Number = 1"},
                            section("Second fluid", {"Density = -1"})));
  EXPECT_EQ(input.complaint, "");
  EXPECT_EQ(&input.fluids.at(1.), &input.fluids[0]);
  EXPECT_NE(complaint_of([&]() {
              input.fluids.index("air");
            }).find("There is no fluid 'air'; there is 'water'."),
            std::string::npos);
}



TEST(Fluids, RefuseWhatCannotBe)
{
  const auto complaint = [](const std::string &setting) {
    return Input(section("Fluids", {}, section("Second fluid", {setting})))
      .complaint;
  };
  EXPECT_NE(complaint("Density = 0").find("must be positive"),
            std::string::npos);
  EXPECT_NE(complaint("Viscosity = -1").find("Second fluid/Viscosity"),
            std::string::npos);
  EXPECT_NE(complaint("Name =").find("is empty"), std::string::npos);
  EXPECT_NE(complaint("Name = water").find("different names"),
            std::string::npos);
  EXPECT_EQ(complaint("Viscosity = 0"), "");
}
