// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/materials/melting.h>

#include <gtest/gtest.h>

using Thalweg::Melting;

TEST(Melting, AMeltingPointTakesAllTheLatentHeat)
{
  const Melting law{5., 2., 2.};
  EXPECT_EQ(law.value(1.), 1.);
  EXPECT_EQ(law.molten(1.), 0.);
  EXPECT_EQ(law.value(4.), 2.);
  EXPECT_EQ(law.molten(4.), .4);
  EXPECT_EQ(law.value(8.), 3.);
  EXPECT_EQ(law.molten(8.), 1.);
  EXPECT_EQ(law.slope(law.state(4.)), 0.);
  EXPECT_EQ(law.slope(law.state(1.)), 1.);
  EXPECT_EQ(law.slope(law.state(8.)), 1.);
  // A solid at its melting point has not begun to melt.
  EXPECT_EQ(law.molten_at(2.), 0.);
  EXPECT_EQ(law.molten_at(2.1), 1.);
}



TEST(Melting, ARangeIsPassedInAStraightLine)
{
  const Melting law{3., 1., 2.};
  for (double value = 0.; value < 3.; value += .125)
    {
      const double heat = law.heat(value, law.molten_at(value));
      EXPECT_DOUBLE_EQ(law.value(heat), value);
      EXPECT_DOUBLE_EQ(law.molten(heat), law.molten_at(value));
    }
  EXPECT_EQ(law.slope(Melting::State::melting), .25);
}



TEST(Melting, NothingMeltsWithoutLatentHeat)
{
  const Melting law{0., 1., 1.};
  for (const double heat : {-1., 1., 3.})
    {
      EXPECT_EQ(law.value(heat), heat);
      EXPECT_EQ(law.slope(law.state(heat)), 1.);
    }
}
