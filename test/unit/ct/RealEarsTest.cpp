// SPDX-License-Identifier: BSD-3-Clause

// Real ears with manually drawn labels, in the folder that the environment variable PERILYMPH_EARS
// names. The project ships none.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "perilymph/foundation/Units.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/RealEarTruth.h"

namespace perilymph::ct {
namespace {

struct Measured {
  test::RealEar ear;
  CochleaMeasures found;
};

/// Every ear of the folder with its measures, computed once.
const std::vector<Measured>& measuredEars()
{
  static const std::vector<Measured> all = [] {
    std::vector<Measured> made;
    const auto folder = test::realEarFolder();
    for (const std::string& name : test::realEarNames(*folder)) {
      test::RealEar ear = test::loadRealEar(*folder, name);
      MeasureRequest request;
      request.click_P = test::clickOf(ear);
      auto found = measureCochlea(ear.ct, request);
      if (!found) throw std::runtime_error(name + ": " + found.error().message);
      made.push_back({std::move(ear), std::move(*found)});
    }
    return made;
  }();
  return all;
}

class RealEars : public testing::Test {
protected:
  void SetUp() override
  {
    if (!test::realEarFolder())
      GTEST_SKIP() << "PERILYMPH_EARS names no folder with real ears: set it to test on them.";
  }
};

bool isAirFilled(const Measured& each) { return each.found.has(Flag::airInCochlea); }

TEST_F(RealEars, HaveTheirSide)
{
  for (const Measured& each : measuredEars())
    EXPECT_EQ(each.found.side == anatomy::Side::right, each.ear.isRight) << each.ear.name;
}

TEST_F(RealEars, HaveDiametersWithin0p3MillimetersWhereFluidFillsThem)
{
  double squaresA = 0.0, squaresB = 0.0, count = 0.0;
  for (const Measured& each : measuredEars()) {
    if (isAirFilled(each)) continue;
    const test::LabelMeasures label = test::measureLabel(each.ear);
    squaresA += std::pow(each.found.a.value - label.a, 2);
    squaresB += std::pow(each.found.b.value - label.b, 2);
    count += 1.0;
  }
  ASSERT_GT(count, 0.0);
  EXPECT_LT(std::sqrt(squaresA / count), 0.30);
  EXPECT_LT(std::sqrt(squaresB / count), 0.30);
}

TEST_F(RealEars, AreOfFullLengthAndWithoutMetal)
{
  int notJudged = 0;
  for (const Measured& each : measuredEars()) {
    EXPECT_TRUE(each.found.cdlOc) << each.ear.name << " " << each.found.turnsSeen;
    for (const Flag flag :
         {Flag::fewTurns, Flag::cysticApex, Flag::metal, Flag::unusualProportions})
      EXPECT_FALSE(each.found.has(flag)) << each.ear.name << " " << nameOf(flag);
    notJudged += each.found.has(Flag::apexNotJudged) ? 1 : 0;
  }
  EXPECT_LE(notJudged, 1);  // T06, whose modiolus is faint
}

TEST_F(RealEars, AreNoCavitiesOnCoarserScannersEither)
{
  for (const test::PhantomScan& scan : {test::highResolutionScan(), test::clinicalScan()})
    for (const Measured& each : measuredEars()) {
      MeasureRequest request;
      request.click_P = test::clickOf(each.ear);
      // The ears have a blur of 0.15 mm.
      const auto found = measureCochlea(test::coarser(each.ear.ct, scan, 0.15), request);
      ASSERT_TRUE(found) << each.ear.name << found.error().message;
      EXPECT_FALSE(found->has(Flag::cysticApex)) << each.ear.name << scan.spacing_mm.x();
    }
}

TEST_F(RealEars, HaveAnAxisWithin6DegreesInTheMedian)
{
  std::vector<double> errors;
  for (const Measured& each : measuredEars())
    errors.push_back(inDegrees(
        radians(std::acos(std::min(1.0, each.found.axis_P.dot(each.ear.axes_PW.col(2)))))));
  std::sort(errors.begin(), errors.end());
  ASSERT_FALSE(errors.empty());
  EXPECT_LT(errors[errors.size() / 2], 6.0);
}

TEST_F(RealEars, HaveAWallWithin0p25MillimetersOfTheLabel)
{
  for (const Measured& each : measuredEars())
    EXPECT_LT(test::meanDistanceToLabel(each.ear, each.found), 0.25) << each.ear.name;
}

TEST_F(RealEars, CarryAFlagWhereADiameterIsBeyondThreeSigmas)
{
  for (const Measured& each : measuredEars()) {
    const test::LabelMeasures label = test::measureLabel(each.ear);
    const bool isBeyond = std::fabs(each.found.a.value - label.a) > 3.0 * each.found.a.sd() ||
                          std::fabs(each.found.b.value - label.b) > 3.0 * each.found.b.sd();
    EXPECT_TRUE(!isBeyond || !each.found.flags.empty()) << each.ear.name;
  }
}

}  // namespace
}  // namespace perilymph::ct
