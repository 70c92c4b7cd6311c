// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/section.h>

#include <gtest/gtest.h>
#include <sstream>

using namespace Thalweg;

namespace
{
  struct Fluid
  {
    double       density = 1000.;
    unsigned int count   = 2;

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
  Fluid                    fluid;
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
  Fluid                    fluid;
  fluid.declare(Section(prm));
  std::ostringstream text;
  prm.print_parameters(text, dealii::ParameterHandler::Text);
  EXPECT_NE(text.str().find("set Density = 1000"), std::string::npos);
  EXPECT_NE(text.str().find("Mass by volume. [kg/m^3]"), std::string::npos);
  EXPECT_NE(text.str().find("# How many there are.\n"), std::string::npos);
}


TEST(Section, SeveralMayBeInUseAtTheSameTime)
{
  dealii::ParameterHandler prm;
  double                   a = 1., b = 2., c = 3.;
  const Section            root(prm);
  const Section            first  = root.enter("First");
  const Section            second = root.enter("Second");
  const Section            inner  = first.enter("Inner");
  second.add("B", b, "", "");
  first.add("A", a, "", "");
  inner.add("C", c, "", "");
  EXPECT_TRUE(prm.subsection_path_exists({"Second"}));
  prm.parse_input_from_string(
    "subsection First\n set A = 5\n subsection Inner\n set C = 6\n end\nend\n"
    "subsection Second\n set B = 7\nend\n");
  EXPECT_EQ(a, 5.);
  EXPECT_EQ(b, 7.);
  EXPECT_EQ(c, 6.);
}


TEST(Section, ExistsEvenIfNothingIsDeclaredInIt)
{
  dealii::ParameterHandler prm;
  Section(prm).enter("Model").enter("without parameters");
  EXPECT_TRUE(prm.subsection_path_exists({"Model", "without parameters"}));
}
