// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/InsertionByHand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/analysis/StopCurve.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {
namespace {

HandDistribution hand()
{
  auto loaded = shippedHand();
  EXPECT_TRUE(loaded) << loaded.error().message;
  return *loaded;
}

TEST(DrawnSurgeon, HasASpeedTremorAndForceWithinTheirRanges)
{
  const HandDistribution all = hand();
  double sum = 0.0;
  constexpr int draws = 2000;
  for (std::uint64_t number = 1; number <= draws; ++number) {
    const Surgeon one = drawSurgeon(all, 1, number);
    EXPECT_GE(one.stop, all.stopLow);
    EXPECT_LE(one.stop, all.stopHigh);
    EXPECT_GE(one.tremor, all.tremorLow);
    EXPECT_LE(one.tremor, all.tremorHigh);
    EXPECT_GE(one.rupture, all.ruptureLow);
    EXPECT_LE(one.rupture, all.ruptureHigh);
    sum += inMillimetersPerSecond(one.speed);
  }
  // 0.66 +- 0.31 mm/s within 0.1 to 1.5: the lower limit takes away more, so the mean is a little
  // higher
  EXPECT_NEAR(sum / draws, 0.69, 0.03);
}

TEST(DrawnSurgeon, IsTheSameForTheSameSeedAndAnotherForTheNext)
{
  EXPECT_EQ(drawSurgeon(hand(), 3, 5).stop, drawSurgeon(hand(), 3, 5).stop);
  EXPECT_NE(drawSurgeon(hand(), 3, 5).stop, drawSurgeon(hand(), 3, 6).stop);
  EXPECT_NE(drawSurgeon(hand(), 3, 5).stop, drawSurgeon(hand(), 4, 5).stop);
}

TEST(DrawnSurgeon, HasTheFrictionsSpreadAroundItsMedian)
{
  const HandDistribution all = hand();
  constexpr int draws = 2000;
  std::vector<double> spread, ofTheHand;
  for (std::uint64_t number = 1; number <= draws; ++number) {
    spread.push_back(std::log(drawSurgeon(all, 1, number, {0.283, 0.2}).frictionFactor));
    ofTheHand.push_back(drawSurgeon(all, 1, number).frictionFactor);
  }
  const SampleStatistics logs = statisticsOf(spread);
  EXPECT_NEAR(logs.mean, 0.0, 4.0 * 0.3465 / std::sqrt(draws));
  // sqrt(0.283^2 + 0.2^2); its standard error is 1 / sqrt(2 n) of it, and 3 SD are the limit
  EXPECT_NEAR(logs.standardDeviation, 0.3465, 0.02);
  // without a spread, mean 1 and the hand's 25 %
  const SampleStatistics factors = statisticsOf(ofTheHand);
  EXPECT_NEAR(factors.mean, 1.0, 4.0 * 0.25 / std::sqrt(draws));
  EXPECT_NEAR(factors.standardDeviation, all.frictionDeviation, 0.02);
}

struct ByHand {
  explicit ByHand(Force stop) : surgeon(drawSurgeon(hand(), 1, 1))
  {
    surgeon.stop = stop;
    auto scenario = session::loadScenario(
        "surgery-flex28", {{"friction", "tissue"}, {"start_inside_mm", "1"}, {"dt_ms", "5"}});
    EXPECT_TRUE(scenario) << scenario.error().message;
    parameters = scenario->parameters();
    parameters.stopTravel = session::fullTravel(parameters.array, parameters.startInside);
    anatomy = *session::buildAnatomy(parameters);
  }
  ClinicalInsertion insert()
  {
    return insertByHand(parameters, anatomy, hand(), surgeon, millimeters(1), {});
  }
  Surgeon surgeon;
  session::InsertionParameters parameters;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
};

TEST(InsertionByHand, StopsAtTheSurgeonsForceAndRests)
{
  ByHand test(newtons(0.02));
  const ClinicalInsertion done = test.insert();
  EXPECT_EQ(done.end, haptics::InsertionEnd::stoppedByResistance);
  EXPECT_LT(done.depth, millimeters(20));
  EXPECT_GT(done.depth, millimeters(8));
  EXPECT_GE(done.peak, newtons(0.02));
  // a mean over half a second of a rising force: below its last value, and not far below
  EXPECT_LT(done.endForce, done.peak);
  EXPECT_GT(done.endForce, 0.5 * done.peak);
  // a point of the profile at every millimeter from the start on
  ASSERT_GE(done.profile.size(), 7u);
  EXPECT_NEAR(inMillimeters(done.profile[3].depth), 4.0, 1e-9);
  EXPECT_TRUE(done.contacts.front().isInserted);
  // at rest the force falls, and it still presses on the hand
  ASSERT_TRUE(done.forceAfter1s && done.forceAfter10s);
  EXPECT_LT(*done.forceAfter1s, done.endForce);
  EXPECT_LE(*done.forceAfter10s, *done.forceAfter1s);
  EXPECT_GT(*done.forceAfter10s, newtons(0));
}

TEST(StopCurve, HoldsTheDepthAtWhichTheSameSurgeonStopsAtAnyForce)
{
  ByHand test(newtons(0.02));
  const StopCurve curve = pushWithoutStop(test.parameters, test.anatomy, hand(), test.surgeon, {});
  // at rest the tip goes on: the depth of a stop is that before it
  HandDistribution restless = hand();
  restless.rest = milliseconds(5);
  for (const double stop_mN : {5.0, 10.0, 20.0, 40.0}) {
    test.surgeon.stop = millinewtons(stop_mN);
    test.surgeon.intended = 1.0;
    const ClinicalInsertion stopped =
        insertByHand(test.parameters, test.anatomy, restless, test.surgeon, Length{}, {});
    ASSERT_EQ(stopped.end, haptics::InsertionEnd::stoppedByResistance) << stop_mN;
    // the same ticks: the points of the curve around the limit enclose the depth of the stop
    const auto before = curve.lengthAt(test.surgeon.stop - stopResolution);
    const auto after = curve.lengthAt(test.surgeon.stop);
    ASSERT_TRUE(before && after) << stop_mN;
    EXPECT_LE(*before, stopped.depth) << stop_mN;
    // in the tick of rest the array follows the hand by what it moved in one tick, and tremor
    EXPECT_GE(*after, stopped.depth - millimeters(0.02)) << stop_mN;
    EXPECT_LT(inMillimeters(*after - *before), 1.0) << stop_mN;
  }
  EXPECT_FALSE(curve.lengthAt(newtons(2.0)));
}

TEST(StopCurve, RisesOnlyAndEndsByName)
{
  ByHand test(newtons(0.02));
  const StopCurve curve = pushWithoutStop(test.parameters, test.anatomy, hand(), test.surgeon, {});
  ASSERT_GE(curve.rises.size(), 100u);
  for (std::size_t i = 1; i < curve.rises.size(); ++i)
    EXPECT_GE(curve.rises[i].force, curve.rises[i - 1].force + stopResolution) << i;
  EXPECT_NE(curve.end, haptics::InsertionEnd::refused);
  EXPECT_NE(curve.end, haptics::InsertionEnd::none);
  EXPECT_GT(curve.depth, curve.rises[curve.rises.size() / 2].depth);
}

TEST(InsertionByHand, EndsBetweenTheLastContactInsideAndTheGreatestDepth)
{
  const HandDistribution all = hand();
  double lowest = 1.0, highest = 0.0;
  for (std::uint64_t number = 1; number <= 200; ++number) {
    const double intended = drawSurgeon(all, 1, number).intended;
    EXPECT_TRUE(0.0 <= intended && intended <= 1.0) << intended;
    lowest = std::min(lowest, intended);
    highest = std::max(highest, intended);
  }
  EXPECT_LT(lowest, 0.05);
  EXPECT_GT(highest, 0.95);

  ByHand test(newtons(1.0));
  // the last contact of FLEX28 is centered at 24.1 mm and 0.5 mm long, its greatest depth is 28 mm
  test.surgeon.intended = 0.0;
  EXPECT_NEAR(inMillimeters(intendedDepth(test.parameters, test.surgeon)), 24.35, 1e-9);
  test.surgeon.intended = 1.0;
  EXPECT_NEAR(inMillimeters(intendedDepth(test.parameters, test.surgeon)), 28.0, 1e-9);
  test.surgeon.intended = 0.5;
  EXPECT_NEAR(inMillimeters(intendedDepth(test.parameters, test.surgeon)), 26.175, 1e-9);
  // no deeper than the scenario allows, and with no contact there
  test.parameters.stopTravel = millimeters(20) - test.parameters.startInside;
  EXPECT_NEAR(inMillimeters(intendedDepth(test.parameters, test.surgeon)), 20.0, 1e-9);
  test.parameters.array.contactsFromTip.clear();
  test.parameters.stopTravel = millimeters(28) - test.parameters.startInside;
  EXPECT_NEAR(inMillimeters(intendedDepth(test.parameters, test.surgeon)), 28.0, 1e-9);
}

TEST(InsertionByHand, StopsWhereTheSurgeonMeansTo)
{
  ByHand test(newtons(1.0));
  test.surgeon.frictionFactor = 0.05;
  test.surgeon.intended = 0.0;
  test.parameters.array.contactsFromTip.resize(5);  // up to 9.4 mm
  const ClinicalInsertion done = test.insert();
  EXPECT_EQ(done.end, haptics::InsertionEnd::finished);
  EXPECT_NEAR(inMillimeters(done.depth), 9.65, 0.3);  // the tremor goes on at rest
  for (const ContactPosition& each : done.contacts) EXPECT_TRUE(each.isInserted) << each.number;
}

TEST(InsertionByHand, StatesNoForceOfARestThatWasShorter)
{
  ByHand test(newtons(0.02));
  HandDistribution shorter = hand();
  shorter.rest = seconds(2);
  const ClinicalInsertion done =
      insertByHand(test.parameters, test.anatomy, shorter, test.surgeon, Length{}, {});
  EXPECT_TRUE(done.forceAfter1s);
  EXPECT_FALSE(done.forceAfter10s);
  EXPECT_GT(done.endForce, newtons(0));  // of the push, so no rest changes it
  shorter.rest = seconds(0.1);
  const ClinicalInsertion brief =
      insertByHand(test.parameters, test.anatomy, shorter, test.surgeon, Length{}, {});
  EXPECT_FALSE(brief.forceAfter1s);
  EXPECT_EQ(brief.endForce, done.endForce);
}

TEST(InsertionByHand, GoesDeeperWithLessFriction)
{
  ByHand rough(newtons(0.02)), smooth(newtons(0.02));
  smooth.surgeon.frictionFactor = 0.3 * rough.surgeon.frictionFactor;
  EXPECT_GT(smooth.insert().apical, rough.insert().apical);
}

}  // namespace
}  // namespace perilymph::analysis
