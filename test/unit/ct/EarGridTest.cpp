// SPDX-License-Identifier: BSD-3-Clause

// Malformed, ossified and implanted ears, cut ones and two in one volume, on three scanners: each
// is measured rightly, flagged by name, or refused with a true sentence.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/ct/Measures.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {
namespace {

class EarGrid : public testing::TestWithParam<test::PhantomScan> {
protected:
  static constexpr std::uint64_t first = 501;

  static test::CtPhantom phantom(std::uint64_t seed, const test::PhantomCondition& condition = {})
  {
    return test::makeCtPhantom(seed, GetParam(), condition);
  }
  static Result<CochleaMeasures> measuredAt(const test::CtPhantom& phantom, const CtVolume& volume,
                                            std::uint64_t seed)
  {
    MeasureRequest request;
    request.click_P = test::jitteredClick(phantom, seed);
    return measureCochlea(volume, request);
  }
  /// What is found in an ear with a condition.
  static Result<CochleaMeasures> measured(std::uint64_t seed,
                                          const test::PhantomCondition& condition)
  {
    const test::CtPhantom ear = phantom(seed, condition);
    return measuredAt(ear, ear.volume, seed);
  }
  struct Ear {
    test::CtPhantom phantom;
    Result<CochleaMeasures> found;
    std::uint64_t seed;
  };
  /// Three normal ears on this scanner, measured once for every case.
  static const std::vector<Ear>& normalEars()
  {
    static std::map<double, std::vector<Ear>> known;
    std::vector<Ear>& ears = known[GetParam().spacing_mm.x()];
    for (std::uint64_t seed = first; ears.size() < 3; ++seed) {
      test::CtPhantom ear = phantom(seed);
      auto found = measuredAt(ear, ear.volume, seed);
      ears.push_back({std::move(ear), std::move(found), seed});
    }
    return ears;
  }
  template <class Found>
  static bool isRefusedAs(const Result<Found>& found, const char* word)
  {
    return !found && found.error().message.find(word) != std::string::npos;
  }
};

TEST_P(EarGrid, NormalEarsCarryNoneOfTheFlags)
{
  for (const Ear& ear : normalEars()) {
    ASSERT_TRUE(ear.found) << ear.found.error().message;
    EXPECT_TRUE(ear.found->cdlOc) << ear.seed;
    for (const Flag flag :
         {Flag::fewTurns, Flag::cysticApex, Flag::apexNotJudged, Flag::wallWithoutContrast,
          Flag::metal, Flag::clipped, Flag::unusualProportions, Flag::secondCochlea})
      EXPECT_FALSE(ear.found->has(flag)) << ear.seed << nameOf(flag);
  }
}

TEST_P(EarGrid, ShortLumensHaveNoDuctLength)
{
  std::uint64_t seed = first;
  for (const double turns : {1.5, 1.75, 2.0, 1.5, 2.0}) {
    test::PhantomCondition condition;
    condition.turns = turns;
    const auto found = measured(seed, condition);
    if (!isRefusedAs(found, "malformed")) {
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::fewTurns)) << seed << " " << turns;
      EXPECT_FALSE(found->cdlOc);
      EXPECT_NEAR(found->turnsSeen, turns, 0.2) << seed;
    }
    ++seed;
  }
}

TEST_P(EarGrid, CavitiesInsteadOfUpperTurnsAreNamedOrNotJudged)
{
  std::uint64_t seed = first + 10;  // a constant was chosen with some of those before
  int named = 0;
  for (const double turns : {1.4, 1.5, 1.6, 1.5, 1.5}) {
    test::PhantomCondition condition;
    condition.turns = turns;
    condition.isCystic = true;
    const auto found = measured(seed, condition);
    if (!isRefusedAs(found, "malformed")) {
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::cysticApex) || found->has(Flag::apexNotJudged))
          << seed << " " << turns;
      EXPECT_FALSE(found->has(Flag::cysticApex) && found->cdlOc) << seed;
    }
    named += !found || found->has(Flag::cysticApex) ? 1 : 0;
    ++seed;
  }
  EXPECT_GE(named, 3);
}

TEST_P(EarGrid, OssifiedEarsAreNamed)
{
  std::uint64_t seed = first;
  for (const double to_deg : {120.0, 435.0, 1000.0, 435.0}) {
    test::PhantomCondition condition;
    condition.ossified = {0.0, to_deg};
    const auto found = measured(seed, condition);
    if (!isRefusedAs(found, "ossified")) {
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::wallWithoutContrast) || found->has(Flag::fewTurns) ||
                  found->has(Flag::poorFit))
          << seed << " to " << to_deg;
    }
    ++seed;
  }
}

TEST_P(EarGrid, ImplantsAreNamed)
{
  std::uint64_t seed = first;
  for (const bool isExtended : {false, true, false, true}) {
    test::PhantomCondition condition;
    condition.hasImplant = true;
    condition.isExtended = isExtended;
    const auto found = measured(seed, condition);
    if (!isRefusedAs(found, "metal")) {
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::metal)) << seed << isExtended;
    }
    ++seed;
  }
}

TEST_P(EarGrid, CornersOfAnyValueChangeNoMeasureWithoutAFlag)
{
  const std::vector<std::int16_t> values{0, -2000, unmeasured};
  for (const Ear& ear : normalEars()) {
    ASSERT_TRUE(ear.found) << ear.found.error().message;
    const CochleaMeasures& whole = *ear.found;
    for (const double beyond_mm : {1.0, -1.0}) {
      const Eigen::Vector3d far = *ear.phantom.marks[Mark::farB];
      const Eigen::Vector3d outward = (far - whole.center_P).normalized();
      const auto found =
          measuredAt(ear.phantom,
                     test::withEmptyCorner(ear.phantom.volume, far + beyond_mm * outward, outward,
                                           values[ear.seed % values.size()]),
                     ear.seed);
      if (!found || found->has(Flag::clipped) || found->has(Flag::poorFit)) continue;
      EXPECT_NEAR(found->a.value, whole.a.value, whole.a.sd() + found->a.sd()) << ear.seed;
      EXPECT_NEAR(found->b.value, whole.b.value, whole.b.sd() + found->b.sd()) << ear.seed;
    }
  }
}

TEST_P(EarGrid, ACochleaThatTheVolumeCutsOffIsNamed)
{
  for (const Ear& ear : normalEars()) {
    const Eigen::Vector3d apex = *ear.phantom.marks[Mark::apex];
    const Eigen::Vector3d up = (apex - *ear.phantom.marks[Mark::floor]).normalized();
    const auto found = measuredAt(
        ear.phantom, test::withEmptyCorner(ear.phantom.volume, apex - 1.5 * up, up, 0), ear.seed);
    EXPECT_TRUE(!found || found->has(Flag::clipped)) << ear.seed;
  }
}

TEST_P(EarGrid, BothEarsOfAVolumeAreMeasured)
{
  const test::TwoEars head = test::makeTwoEars(601, GetParam(), 100.0);
  const auto both = measureBothCochleae(head.volume, {});
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_NEAR((*both)[0].a.value, head.right.a, 3.0 * (*both)[0].a.sd());
  EXPECT_NEAR((*both)[1].a.value, head.left.a, 3.0 * (*both)[1].a.sd());
  EXPECT_FALSE((*both)[0].has(Flag::mirrored) || (*both)[1].has(Flag::mirrored));
}

TEST_P(EarGrid, ASearchThatFindsTwoCochleaeNamesTheOther)
{
  const test::TwoEars head = test::makeTwoEars(601, GetParam(), 45.0);
  const auto any = measureCochlea(head.volume, {});
  ASSERT_TRUE(any) << any.error().message;
  EXPECT_TRUE(any->has(Flag::secondCochlea));
  ASSERT_TRUE(any->otherCochlea_P);
  const test::CtPhantom& other = any->side == anatomy::Side::right ? head.left : head.right;
  EXPECT_LT((*any->otherCochlea_P - other.inside_P).norm(), 8.0);
}

TEST_P(EarGrid, OneEarIsNotMeasuredTwice)
{
  EXPECT_TRUE(
      isRefusedAs(measureBothCochleae(normalEars()[1].phantom.volume, {}), "cochlea was found"));
}

// A suite each, so that they run at once.
INSTANTIATE_TEST_SUITE_P(ConeBeam, EarGrid, testing::Values(test::coneBeamScan()));
INSTANTIATE_TEST_SUITE_P(HighResolution, EarGrid, testing::Values(test::highResolutionScan()));
INSTANTIATE_TEST_SUITE_P(Clinical, EarGrid, testing::Values(test::clinicalScan()));

}  // namespace
}  // namespace perilymph::ct
