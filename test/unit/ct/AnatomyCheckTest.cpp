// SPDX-License-Identifier: BSD-3-Clause

// Ears that are no whole, empty cochlea alone in a volume: each is named. The grid over voxel
// sizes and seeds is in EarGridTest.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "MeasuredPhantom.h"
#include "RaisedFlags.h"
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

/// Incomplete partition of type II: one and a half turns, and a cavity instead of the others.
test::PhantomCondition incompletePartition()
{
  test::PhantomCondition condition;
  condition.turns = 1.5;
  condition.isCystic = true;
  return condition;
}

TEST(AnatomyCheck, NamesACavityInsteadOfTheUpperTurns)
{
  // A spiral that falls explains this ear as well: it is the mirror image, of the other side.
  const test::CtPhantom ear = test::makeCtPhantom(502, test::clinicalScan(), incompletePartition());
  const auto found = measuredAt(ear, ear.volume);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->side == anatomy::Side::right, ear.isRight);
  EXPECT_TRUE(found->has(Flag::cysticApex));
  EXPECT_FALSE(found->has(Flag::apexNotJudged));
  EXPECT_FALSE(found->cdlOc);
}

TEST(AnatomyCheck, TellsWhereACavityCannotBeToldFromTurns)
{
  const test::PhantomScan blurred{{0.6, 0.6, 0.6}, 0.55, 0.55, 80.0, false};
  const test::CtPhantom ear = test::makeCtPhantom(502, blurred, incompletePartition());
  const auto found = measuredAt(ear, ear.volume);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->has(Flag::apexNotJudged));
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
  for (const Flag flag :
       {Flag::fewTurns, Flag::cysticApex, Flag::apexNotJudged, Flag::wallWithoutContrast,
        Flag::metal, Flag::clipped, Flag::unusualProportions, Flag::secondCochlea})
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

/// The phantom's volume in a space that is stretched along a direction.
CtVolume stretched(const CtVolume& volume, const Eigen::Vector3d& direction_P, double by)
{
  const Eigen::Vector3d along = direction_P.normalized();
  Eigen::Matrix4d lps = volume.lpsFromIndex();
  lps.topRows<3>() += (by - 1.0) * along * (along.transpose() * lps.topRows<3>());
  return *CtVolume::make(volume.size(), lps, {volume.voxels().begin(), volume.voxels().end()});
}

TEST(AnatomyCheck, FlagsACochleaThatIsHigherThanAny)
{
  EXPECT_FALSE(measures().has(Flag::unusualProportions));
  const test::CtPhantom& ear = phantom();
  constexpr double by = 1.3;
  const CtVolume high = stretched(ear.volume, ear.axis_P, by);
  MeasureRequest request;
  request.click_P = high.toLps(ear.volume.toIndex(ear.inside_P));
  const auto found = measureCochlea(high, request);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->h.value, by * ear.h, 3.0 * found->h.sd());
  EXPECT_TRUE(found->has(Flag::unusualProportions));
}

/// The flags of the shared phantom's measures once they are changed, without another fit.
bool isFlagged(Flag flag, const CochleaMeasures& changed)
{
  const auto flags = raisedFlags(changed, {phantom().volume, {}, {}, {}, {}, false});
  return std::find(flags.begin(), flags.end(), flag) != flags.end();
}

TEST(AnatomyCheck, FlagsASeriesThatContradictsItself)
{
  const CtVolume& volume = phantom().volume;
  for (const bool isInDoubt : {false, true}) {
    CtProvenance provenance = volume.provenance();
    provenance.isInDoubt = isInDoubt;
    const auto read = *CtVolume::make(volume.size(), volume.lpsFromIndex(),
                                      {volume.voxels().begin(), volume.voxels().end()}, provenance);
    const auto flags = raisedFlags(measures(), {read, {}, {}, {}, {}, false});
    EXPECT_EQ(std::find(flags.begin(), flags.end(), Flag::seriesInDoubt) != flags.end(), isInDoubt);
  }
}

TEST(AnatomyCheck, FlagsAnEarWhoseFilesStateTheOther)
{
  const CtVolume& volume = phantom().volume;
  for (const anatomy::Side side : {anatomy::Side::right, anatomy::Side::left}) {
    CtProvenance provenance = volume.provenance();
    provenance.side = side;
    const auto read = *CtVolume::make(volume.size(), volume.lpsFromIndex(),
                                      {volume.voxels().begin(), volume.voxels().end()}, provenance);
    const auto flags = raisedFlags(measures(), {read, {}, {}, {}, {}, false});
    EXPECT_EQ(std::find(flags.begin(), flags.end(), Flag::mirrored) != flags.end(),
              (side == anatomy::Side::right) != phantom().isRight);
  }
}

TEST(AnatomyCheck, FlagsADiameterBThatFitsNoAAsLong)
{
  // Pietsch et al. 2017: where A is its mean of 9.23 mm, B has a mean of 6.80 and a standard deviation
  // of 0.22 mm, computed by hand from their covariances.
  for (const double b_mm : {5.0, 5.7, 6.3, 6.8, 7.3, 7.9, 8.6}) {
    CochleaMeasures changed = measures();
    changed.a.value = 9.23;
    changed.b.value = b_mm;
    changed.h.value = 3.5;
    EXPECT_EQ(isFlagged(Flag::unusualProportions, changed), std::fabs(b_mm - 6.8) > 1.0) << b_mm;
  }
}

bool landmarksDisagree(const Marks& marks)
{
  CochleaMeasures changed = measures();
  changed.marksByHand = marks;
  return isFlagged(Flag::landmarksDisagree, changed);
}

TEST(AnatomyCheck, FlagsLandmarksWhoseDistanceIsNoneOfTheFittedMeasures)
{
  const Marks& right = phantom().marks;
  EXPECT_FALSE(landmarksDisagree(right));
  const auto apart = [&right](Mark from, Mark to, double by_mm) {
    Marks moved = right;
    *moved[to] += by_mm * (*right[to] - *right[from]).normalized();
    return moved;
  };
  const std::array<std::array<Mark, 2>, 3> lines{
      {{Mark::roundWindow, Mark::farWall}, {Mark::nearB, Mark::farB}, {Mark::floor, Mark::apex}}};
  for (const auto& [from, to] : lines) {
    for (const double by_mm : {-3.5, 3.5, 20.0})
      EXPECT_TRUE(landmarksDisagree(apart(from, to, by_mm))) << nameOf(to) << " " << by_mm;
    for (const double by_mm : {-0.5, 0.5})  // as a person places them
      EXPECT_FALSE(landmarksDisagree(apart(from, to, by_mm))) << nameOf(to) << " " << by_mm;
  }
}

}  // namespace
}  // namespace perilymph::ct
