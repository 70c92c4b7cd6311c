#include <thalweg/core/section.h>

#include <gtest/gtest.h>
#include <sstream>

using namespace Thalweg;

namespace
{
  struct Fluid
  {
    double density     = 1000.;
    unsigned int count = 2;

    void
    declare(const Section &root)
    {
      const Section section = root.enter("Fluids");
      section.add("Count", count, "", "How many there are.");
      const Section water = section.enter("Water");
      water.add("Density", density, "kg/m^3", "Mass by volume.");
    }
  };
} // namespace


TEST(Section, NestsAndWritesIntoTheVariables)
{
  dealii::ParameterHandler prm;
  Fluid fluid;
  fluid.declare(Section(prm));
  // All sections were left again, so this path starts at the root.
  prm.parse_input_from_string(
    "subsection Fluids\nsubsection Water\nset Density = 998.5\nend\nend\n");
  EXPECT_EQ(fluid.density, 998.5);
  EXPECT_EQ(fluid.count, 2u);
}


TEST(Section, DefaultComesFromTheVariableAndTheUnitEndsTheText)
{
  dealii::ParameterHandler prm;
  Fluid fluid;
  fluid.declare(Section(prm));
  std::ostringstream text;
  prm.print_parameters(text, dealii::ParameterHandler::Text);
  EXPECT_NE(text.str().find("set Density = 1000"), std::string::npos);
  EXPECT_NE(text.str().find("Mass by volume. [kg/m^3]"), std::string::npos);
  EXPECT_NE(text.str().find("# How many there are.\n"), std::string::npos);
}


TEST(Section, LeavesOnlyOnceWhenMoved)
{
  dealii::ParameterHandler prm;
  double value = 1.;
  {
    const Section root(prm);
    const Section outer = root.enter("A");
    {
      Section first        = outer.enter("B");
      const Section second = std::move(first);
      second.add("Inner", value, "", "");
    }
    outer.add("Outer", value, "", "");
  }
  EXPECT_TRUE(prm.subsection_path_exists({"A", "B"}));
  prm.parse_input_from_string("subsection A\nset Outer = 2\nend\n");
  EXPECT_EQ(value, 2.);
}
