// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/ClinicalPrediction.h"

#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/validation/Prediction.h"

namespace perilymph::validation {
namespace {

/// Insertions of an array to the given angles.
std::vector<analysis::ClinicalInsertion> insertionsTo(const char* array,
                                                      std::initializer_list<double> angles_deg)
{
  std::vector<analysis::ClinicalInsertion> all;
  for (const double angle : angles_deg) {
    analysis::ClinicalInsertion one;
    one.array = array;
    one.apical = degrees(angle);
    one.end = angle > 0.0 ? haptics::InsertionEnd::finished : haptics::InsertionEnd::refused;
    all.push_back(one);
  }
  return all;
}

ClinicalRow rowOf(const std::vector<analysis::ClinicalInsertion>& insertions,
                  const std::string& quantity)
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

TEST(ClinicalAngles, HoldTheirMediansWithinTheirRanges)
{
  const auto angles = clinicalAngles();
  ASSERT_TRUE(angles) << angles.error().message;
  ASSERT_EQ(angles->size(), 5u);
  for (const ClinicalAngle& angle : *angles) {
    EXPECT_LE(angle.low, angle.median) << angle.array;
    EXPECT_LE(angle.median, angle.high) << angle.array;
  }
  // FLEX28: median 575, interquartile range 465 to 584 degrees (O'Connell 2017)
  EXPECT_NEAR(inDegrees(angles->at(1).median), 575.0, 1e-9);
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
}  // namespace perilymph::validation
