// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/volume_watch.h>

#include <gtest/gtest.h>

using namespace Thalweg;

namespace
{
  /// A cubic metre of water in four of air, with a correction and a debt.
  VolumeWatch::State
  state(const double time, const double correction, const double debt)
  {
    return {time, {{1., 4.}}, correction, debt};
  }
} // namespace



TEST(VolumeWatch, WarnsAboveOnePercentAndAgainWhenItHasDoubled)
{
  const Fluids fluids;
  VolumeWatch  watch;
  EXPECT_EQ(watch.after_step(fluids, state(.1, .009, -.009)).size(), 0u);
  EXPECT_EQ(watch.after_step(fluids, state(.2, -.011, 0.)).size(), 1u);
  EXPECT_EQ(watch.after_step(fluids, state(.3, .021, 0.)).size(), 0u);
  EXPECT_EQ(watch.after_step(fluids, state(.4, .023, .012)).size(), 2u);

  // A run that goes on does not say it again.
  const Archive archive;
  watch.keep(archive);
  VolumeWatch resumed;
  resumed.keep(Archive::restore(archive.bytes()));
  EXPECT_EQ(resumed.after_step(fluids, state(.5, .023, .012)).size(), 0u);
}



TEST(VolumeWatch, WarnsOfWaterThatIsRestoredFast)
{
  const Fluids fluids;
  VolumeWatch  watch;
  EXPECT_EQ(watch.after_step(fluids, state(.5, .015, 0.)).size(), 1u);
  const auto fast = watch.after_step(fluids, state(1.25, .026, 0.));
  ASSERT_EQ(fast.size(), 1u);
  EXPECT_NE(fast[0].find("2.08 %"), std::string::npos) << fast[0];
}
