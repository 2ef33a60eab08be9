// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ClinicalPrediction.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stop_token>

#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/Prediction.h"
#include "perilymph/test/TemporaryFolder.h"
#include "validation/VirtualInsertion.h"

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

struct ByHand {
  explicit ByHand(Force stop) : surgeon(drawSurgeon(hand(), 1, 1))
  {
    surgeon.stop = stop;
    auto scenario = fullInsertionOf("surgery-flex28", "flex28", millimeters(1), milliseconds(5),
                                    {{"friction", "tissue"}});
    EXPECT_TRUE(scenario) << scenario.error().message;
    parameters = scenario->parameters();
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

/// Insertions of an array to the given angles.
std::vector<ClinicalInsertion> insertionsTo(const char* array,
                                            std::initializer_list<double> angles_deg)
{
  std::vector<ClinicalInsertion> all;
  for (const double angle : angles_deg) {
    ClinicalInsertion one;
    one.array = array;
    one.apical = degrees(angle);
    one.end = angle > 0.0 ? haptics::InsertionEnd::finished : haptics::InsertionEnd::refused;
    all.push_back(one);
  }
  return all;
}

ClinicalRow rowOf(const std::vector<ClinicalInsertion>& insertions, const std::string& quantity)
{
  const auto rows = clinicalRows(insertions);
  EXPECT_TRUE(rows) << rows.error().message;
  for (const ClinicalRow& row : *rows)
    if (row.quantity == quantity) return row;
  ADD_FAILURE() << "no row " << quantity;
  return {};
}

// O'Connell 2017: FLEX24 373 to 449 degrees
TEST(ClinicalRow, IsHitWithTheMedianAndHalfOfTheRunsInside)
{
  const auto verdict = [](std::initializer_list<double> angles_deg) {
    return rowOf(insertionsTo("flex24", angles_deg), "angular depth of flex24").verdict;
  };
  EXPECT_EQ(verdict({380, 400, 420, 500}), RowVerdict::hit);
  EXPECT_EQ(verdict({300, 410, 500}), RowVerdict::miss);  // one of three inside
  EXPECT_EQ(verdict({300, 310, 410}), RowVerdict::miss);
}

TEST(ClinicalRow, CountsInsertionsThatFailed)
{
  const ClinicalRow row =
      rowOf(insertionsTo("flex24", {0, 0, 0, 400, 410}), "angular depth of flex24");
  EXPECT_EQ(row.runs, 5);
  EXPECT_EQ(row.median, 0.0);
  EXPECT_EQ(row.verdict, RowVerdict::miss);
}

// Canfarotta 2021: 49 of 51, by Wilson's formula 86.8 to 98.9 %
TEST(ClinicalRow, ComparesARateWithTheIntervalOfThePublishedCount)
{
  const ClinicalRow row =
      rowOf(insertionsTo("flexsoft", {600, 610, 620, 0}), "complete insertion of flexsoft");
  EXPECT_NEAR(row.low, 86.8, 0.05);
  EXPECT_NEAR(row.high, 98.9, 0.05);
  EXPECT_DOUBLE_EQ(row.median, 75.0);
  EXPECT_EQ(row.verdict, RowVerdict::miss);
}

TEST(ClinicalRow, GivesNoVerdictOnWhatNobodyHasRead)
{
  const ClinicalRow row =
      rowOf(insertionsTo("flex24", {400, 400}), "rupture of the partition of all arrays");
  EXPECT_EQ(row.confidence, "low");
  EXPECT_EQ(row.verdict, RowVerdict::notJudged);
}

TEST(Prediction, CountsPatientsWhoseInsertionStopsEarly)
{
  const test::TemporaryFolder folder;
  const std::string scenario = (folder / "weak.toml").string();
  const auto weak =
      session::loadScenario("surgery-flex28", {{"stop_force_N", "0.002"}, {"nodes", "30"}});
  ASSERT_TRUE(weak) << weak.error().message;
  std::ofstream(scenario) << weak->text();

  PredictionRequest request;
  request.arrays = {"flex28"};
  request.scenario = scenario;
  request.patients = 2;
  const auto result = predict(request, {});
  ASSERT_TRUE(result) << result.error().message;
  const ArraySummary& summary = result->arrays.front();
  EXPECT_EQ(summary.patients, 2);
  EXPECT_EQ(summary.complete, 0);
  EXPECT_FALSE(summary.mean);
  EXPECT_GT(summary.medianPeak, newtons(0.0019));
  EXPECT_LT(summary.medianPeak, newtons(0.004));
}

}  // namespace
}  // namespace perilymph::analysis
