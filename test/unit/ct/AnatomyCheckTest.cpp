// SPDX-License-Identifier: BSD-3-Clause

// Ears that are no whole, empty cochlea alone in a volume: each is named. The grid over voxel
// sizes and seeds is in EarGridTest.cpp.

#include <gtest/gtest.h>

#include "perilymph/ct/Measures.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {
namespace {

Result<CochleaMeasures> measuredAt(const test::CtPhantom& phantom, const CtVolume& volume)
{
  MeasureRequest request;
  request.click_P = phantom.inside_P;
  return measureCochlea(volume, request);
}

Result<CochleaMeasures> measured(std::uint64_t seed, const test::PhantomCondition& condition)
{
  const test::CtPhantom phantom = test::makeCtPhantom(seed, test::clinicalScan(), condition);
  return measuredAt(phantom, phantom.volume);
}

TEST(AnatomyCheck, GivesNoDuctLengthForOneAndAHalfTurns)
{
  test::PhantomCondition condition;
  condition.turns = 1.5;
  const auto found = measured(502, condition);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->has(Flag::fewTurns));
  EXPECT_FALSE(found->cdlOc);
  EXPECT_NEAR(found->turnsSeen, 1.5, 0.15);
}

TEST(AnatomyCheck, FlagsABasalTurnThatIsPartlyOssified)
{
  test::PhantomCondition condition;
  condition.ossified = {0.0, 90.0};
  const auto found = measured(502, condition);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->has(Flag::wallWithoutContrast));
}

TEST(AnatomyCheck, NamesMetal)
{
  test::PhantomCondition condition;
  condition.hasImplant = true;
  const auto found = measured(501, condition);
  if (found)
    EXPECT_TRUE(found->has(Flag::metal));
  else
    EXPECT_NE(found.error().message.find("metal"), std::string::npos) << found.error().message;
}

TEST(AnatomyCheck, MeasuresTheSameBesideACornerThatWasNotMeasured)
{
  const test::CtPhantom phantom = test::makeCtPhantom(502, test::clinicalScan());
  const auto whole = measuredAt(phantom, phantom.volume);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_TRUE(whole->cdlOc);
  for (const Flag flag : {Flag::fewTurns, Flag::wallWithoutContrast, Flag::metal, Flag::clipped,
                          Flag::unusualProportions, Flag::secondCochlea})
    EXPECT_FALSE(whole->has(flag)) << nameOf(flag);
  // The corner begins 1 mm behind the far wall.
  const Eigen::Vector3d outward = (*phantom.marks[Mark::farWall] - whole->center_P).normalized();
  const CtVolume cut =
      test::withEmptyCorner(phantom.volume, *phantom.marks[Mark::farWall] + outward, outward, 40);
  const auto found = measuredAt(phantom, cut);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->a.value, whole->a.value, whole->a.sd());
  EXPECT_NEAR(found->b.value, whole->b.value, whole->b.sd());
  EXPECT_NEAR(found->h.value, whole->h.value, whole->h.sd());
}

}  // namespace
}  // namespace perilymph::ct
