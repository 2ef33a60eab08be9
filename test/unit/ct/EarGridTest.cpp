// SPDX-License-Identifier: BSD-3-Clause

// Malformed, ossified and implanted ears, cut ones and two in one volume, on three scanners: each
// is measured rightly, flagged by name, or refused with a true sentence.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "perilymph/ct/Measures.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {
namespace {

struct Case {
  const char* name;
  test::PhantomScan scan;
};

class EarGrid : public testing::TestWithParam<Case> {
protected:
  static constexpr std::uint64_t first = 501, last = 506;

  test::CtPhantom phantom(std::uint64_t seed, const test::PhantomCondition& condition = {}) const
  {
    return test::makeCtPhantom(seed, GetParam().scan, condition);
  }
  static Result<CochleaMeasures> measuredAt(const test::CtPhantom& phantom, const CtVolume& volume,
                                            std::uint64_t seed)
  {
    MeasureRequest request;
    request.click_P = test::jitteredClick(phantom, seed);
    return measureCochlea(volume, request);
  }
  static bool isRefusedAs(const Result<CochleaMeasures>& found, const char* word)
  {
    return !found && found.error().message.find(word) != std::string::npos;
  }
};

TEST_P(EarGrid, NormalEarsCarryNoneOfTheFlags)
{
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const test::CtPhantom ear = phantom(seed);
    const auto found = measuredAt(ear, ear.volume, seed);
    if (!found) continue;
    EXPECT_TRUE(found->cdlOc) << seed;
    for (const Flag flag : {Flag::fewTurns, Flag::wallWithoutContrast, Flag::metal, Flag::clipped,
                            Flag::unusualProportions, Flag::secondCochlea})
      EXPECT_FALSE(found->has(flag)) << seed << nameOf(flag);
  }
}

TEST_P(EarGrid, ShortLumensHaveNoDuctLength)
{
  for (const double turns : {1.5, 1.75, 2.0})
    for (std::uint64_t seed = first; seed < last; ++seed) {
      test::PhantomCondition condition;
      condition.turns = turns;
      const test::CtPhantom ear = phantom(seed, condition);
      const auto found = measuredAt(ear, ear.volume, seed);
      if (isRefusedAs(found, "malformed")) continue;
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::fewTurns)) << seed << " " << turns;
      EXPECT_FALSE(found->cdlOc);
      EXPECT_NEAR(found->turnsSeen, turns, 0.2) << seed;
    }
}

TEST_P(EarGrid, OssifiedEarsAreNamed)
{
  struct Part {
    double from_deg, to_deg;
  };
  for (const Part part : {Part{0.0, 120.0}, Part{0.0, 435.0}, Part{0.0, 1000.0}})
    for (std::uint64_t seed = first; seed < last; ++seed) {
      test::PhantomCondition condition;
      condition.ossified = {part.from_deg, part.to_deg};
      const test::CtPhantom ear = phantom(seed, condition);
      const auto found = measuredAt(ear, ear.volume, seed);
      if (isRefusedAs(found, "ossified")) continue;
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::wallWithoutContrast) || found->has(Flag::fewTurns) ||
                  found->has(Flag::poorFit))
          << seed << " to " << part.to_deg;
    }
}

TEST_P(EarGrid, ImplantsAreNamed)
{
  for (const bool isExtended : {false, true})
    for (std::uint64_t seed = first; seed < last; ++seed) {
      test::PhantomCondition condition;
      condition.hasImplant = true;
      condition.isExtended = isExtended;
      const test::CtPhantom ear = phantom(seed, condition);
      const auto found = measuredAt(ear, ear.volume, seed);
      if (isRefusedAs(found, "metal")) continue;
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_TRUE(found->has(Flag::metal)) << seed << isExtended;
    }
}

TEST_P(EarGrid, CornersOfAnyValueChangeNoMeasureWithoutAFlag)
{
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const test::CtPhantom ear = phantom(seed);
    const auto whole = measuredAt(ear, ear.volume, seed);
    if (!whole) continue;
    for (const std::int16_t value : {std::int16_t{0}, std::int16_t{-2000}, unmeasured})
      for (const double beyond_mm : {1.0, -1.0}) {
        const Eigen::Vector3d far = *ear.marks[Mark::farB];
        const Eigen::Vector3d outward = (far - whole->center_P).normalized();
        const auto found = measuredAt(
            ear, test::withEmptyCorner(ear.volume, far + beyond_mm * outward, outward, value),
            seed);
        if (!found || found->has(Flag::clipped) || found->has(Flag::poorFit)) continue;
        EXPECT_NEAR(found->a.value, whole->a.value, whole->a.sd() + found->a.sd()) << seed;
        EXPECT_NEAR(found->b.value, whole->b.value, whole->b.sd() + found->b.sd()) << seed;
      }
  }
}

TEST_P(EarGrid, ACochleaThatTheVolumeCutsOffIsNamed)
{
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const test::CtPhantom ear = phantom(seed);
    const Eigen::Vector3d apex = *ear.marks[Mark::apex];
    const Eigen::Vector3d up = (apex - *ear.marks[Mark::floor]).normalized();
    const auto found =
        measuredAt(ear, test::withEmptyCorner(ear.volume, apex - 1.5 * up, up, 0), seed);
    EXPECT_TRUE(!found || found->has(Flag::clipped)) << seed;
  }
}

TEST_P(EarGrid, BothEarsOfAVolumeAreMeasured)
{
  for (const double apart_mm : {45.0, 100.0}) {
    const test::TwoEars head = test::makeTwoEars(601, GetParam().scan, apart_mm);
    const auto any = measureCochlea(head.volume, {});
    ASSERT_TRUE(any) << any.error().message;
    EXPECT_TRUE(any->has(Flag::secondCochlea));
    ASSERT_TRUE(any->otherCochlea_P);
    const test::CtPhantom& other = any->side == anatomy::Side::right ? head.left : head.right;
    EXPECT_LT((*any->otherCochlea_P - other.inside_P).norm(), 8.0);
    const auto both = measureBothCochleae(head.volume, {});
    ASSERT_TRUE(both) << both.error().message;
    EXPECT_NEAR((*both)[0].a.value, head.right.a, 3.0 * (*both)[0].a.sd());
    EXPECT_NEAR((*both)[1].a.value, head.left.a, 3.0 * (*both)[1].a.sd());
    EXPECT_FALSE((*both)[0].has(Flag::mirrored) || (*both)[1].has(Flag::mirrored));
  }
}

TEST_P(EarGrid, OneEarIsNotMeasuredTwice)
{
  const test::CtPhantom ear = phantom(502);
  EXPECT_TRUE(isRefusedAs(
      [&]() -> Result<CochleaMeasures> {
        const auto both = measureBothCochleae(ear.volume, {});
        if (!both) return both.error();
        return (*both)[0];
      }(),
      "cochlea was found"));
}

INSTANTIATE_TEST_SUITE_P(Scanners, EarGrid,
                         testing::Values(Case{"coneBeam", test::coneBeamScan()},
                                         Case{"highResolution", test::highResolutionScan()},
                                         Case{"clinical", test::clinicalScan()}),
                         [](const auto& scanner) { return std::string(scanner.param.name); });

}  // namespace
}  // namespace perilymph::ct
