// SPDX-License-Identifier: BSD-3-Clause

// Groups, differences and trends of selected insertions.

#include "perilymph/study/StudySummary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace perilymph::study {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double nearby = 1e-9;

/// Two arrays in five cochleae, each with a speed of its own: angles 500, 510 ... and 530, 542 ...
std::vector<StudyResult> tenResults()
{
  std::vector<StudyResult> results(10);
  for (std::size_t i = 0; i < results.size(); ++i) {
    StudyResult& one = results[i];
    const auto cochlea = static_cast<double>(i / 2);
    const bool isFirst = i % 2 == 0;
    one.number = i;
    one.cochlea = "virtual " + std::to_string(i / 2 + 1);
    one.settings = {{"array", isFirst ? "flex24" : "flex28"},
                    {"speed_mm_s", "0.123456789" + std::to_string(i / 2)}};
    one.a_mm = 8.0 + 0.5 * cochlea;
    one.b_mm = 6.8;
    one.insertion.end = i == 3 ? analysis::InsertionEnd::buckled : analysis::InsertionEnd::finished;
    one.insertion.apical = degrees(isFirst ? 500.0 + 10.0 * cochlea : 530.0 + 12.0 * cochlea);
    one.insertion.depth = millimeters(isFirst ? 20.0 : 24.0 + cochlea);
    one.insertion.peak.force = millinewtons(10.0 + static_cast<double>(i));
  }
  return results;
}

class ASummary : public testing::Test {
protected:
  static StudyColumns columnsOf(const std::vector<StudyResult>& results)
  {
    return {{"Ten", "title = 'Ten'", "f00d", "test", results.size(), 0, results.size()}, results};
  }
  static StudySummary summaryOfAll(const StudyColumns& columns, const std::string& group)
  {
    return summaryOf(columns, columns.rows({}), {"A_mm", "angle_deg", group});
  }
};

TEST_F(ASummary, CountsCompleteAndStoppedInsertionsOfEachGroup)
{
  const StudyColumns columns = columnsOf(tenResults());
  const StudySummary summary = summaryOfAll(columns, "array");
  ASSERT_EQ(summary.groups.size(), 2u);
  const StudyGroup& second = summary.groups[1];
  EXPECT_EQ(second.level, "flex28");
  EXPECT_EQ(second.rows.size(), 5u);
  EXPECT_EQ(second.complete(), 4u);
  EXPECT_EQ(second.stopped(), 1u);
  EXPECT_EQ(analysis::shareText(second.rate, second.rows.size()), "4 of 5");
  // the stopped one among them
  ASSERT_TRUE(second.samples.ran.quartiles[0]);
  EXPECT_NEAR(second.samples.ran.quartiles[0]->value, 554.0, nearby);
  EXPECT_NEAR(second.samples.ran.quartiles[0]->low, 542.0, nearby);
  EXPECT_NEAR(second.samples.ran.quartiles[0]->high, 566.0, nearby);
  EXPECT_NEAR(summary.groups[0].samples.ran.quartiles[2]->value, 14.0, nearby);
  EXPECT_NEAR(second.samples.ran.means[0]->mean, 554.0, nearby);
  // without it: 530, 554, 566, 578
  EXPECT_EQ(second.samples.complete.count, 4u);
  EXPECT_NEAR(second.samples.complete.quartiles[0]->value, 560.0, nearby);
  EXPECT_NEAR(second.samples.complete.means[0]->mean, 557.0, nearby);
}

TEST_F(ASummary, PairsInsertionsOfOneDraw)
{
  const StudyColumns columns = columnsOf(tenResults());
  const StudySummary summary = summaryOfAll(columns, "array");
  ASSERT_EQ(summary.differences.size(), 2u);  // of both selections
  const StudyDifference& found = summary.differences[0];
  EXPECT_TRUE(found.isPaired);
  EXPECT_EQ(found.count, 5u);
  // -30, -32, -34, -36, -38: mean -34, deviation sqrt(10), t(4) = 2.776445
  ASSERT_TRUE(found.means[0]);
  EXPECT_NEAR(found.means[0]->value, -34.0, nearby);
  EXPECT_NEAR(found.means[0]->high, -34.0 + 2.7764451052 * std::sqrt(10.0 / 5.0), 1e-6);
  EXPECT_NEAR(found.means[2]->value, -1.0, nearby);  // the same in each pair
  EXPECT_NEAR(found.means[2]->low, -1.0, nearby);
  // complete only: the pair of the buckled one is left out, -30, -34, -36, -38
  const StudyDifference& complete = summary.differences[1];
  EXPECT_EQ(complete.selection, StudySelection::complete);
  EXPECT_EQ(complete.count, 4u);
  EXPECT_NEAR(complete.means[0]->value, -34.5, nearby);
}

TEST_F(ASummary, TakesThePairsOfOneCochleaTogether)
{
  // each insertion twice, with another friction and 4 degrees more: no further information
  auto results = tenResults();
  for (std::size_t i = 0; i < 10; ++i) {
    StudyResult again = results[i];
    again.number += 10;
    again.settings.emplace_back("friction", "tissue");
    again.insertion.apical = again.insertion.apical + degrees(4.0);
    results[i].settings.emplace_back("friction", "soap-10");
    results.push_back(again);
  }
  const StudyColumns columns = columnsOf(results);
  const StudyDifference found = summaryOfAll(columns, "array").differences.at(0);
  EXPECT_EQ(found.count, 10u);
  EXPECT_EQ(found.cochleae, 5u);
  EXPECT_NEAR(found.means[0]->high, -34.0 + 2.7764451052 * std::sqrt(10.0 / 5.0), 1e-6);
  // in one cochlea over the pairs
  const auto one = summaryOf(columns, {0, 1, 10, 11}, {"A_mm", "angle_deg", "array"});
  EXPECT_EQ(one.differences.at(0).cochleae, 1u);
  EXPECT_NEAR(one.differences.at(0).means[0]->value, -30.0, nearby);
}

TEST_F(ASummary, TakesGroupsWithoutCommonDrawsAsIndependent)
{
  auto results = tenResults();
  for (std::size_t i = 1; i < results.size(); i += 2) results[i].cochlea += " of another series";
  const StudyColumns columns = columnsOf(results);
  const StudySummary summary = summaryOfAll(columns, "array");
  ASSERT_EQ(summary.differences.size(), 2u);  // of both selections
  EXPECT_FALSE(summary.differences[0].isPaired);
  EXPECT_EQ(summary.differences[0].otherCount, 5u);
  // variances 250 and 360, equal n: f = 4 (250 + 360)^2 / (250^2 + 360^2) = 7.748178
  EXPECT_NEAR(summary.differences[0].means[0]->value, -34.0, nearby);
  EXPECT_NEAR(summary.differences[0].means[0]->low,
              -34.0 - analysis::studentHalfWidth95(4.0 * 610.0 * 610.0 / (62500.0 + 129600.0)) *
                          std::sqrt(610.0 / 5.0),
              1e-6);
}

TEST_F(ASummary, HasATrendOfEachGroup)
{
  const StudyColumns columns = columnsOf(tenResults());
  const StudySummary summary = summaryOfAll(columns, "array");
  ASSERT_TRUE(summary.groups[0].samples.ran.trend && summary.groups[1].samples.ran.trend);
  EXPECT_NEAR(summary.groups[0].samples.ran.trend->slope().value, 20.0,
              nearby);  // 10 degrees for 0.5 mm
  EXPECT_NEAR(summary.groups[1].samples.ran.trend->slope().value, 24.0, nearby);
  EXPECT_FALSE(
      summaryOf(columns, columns.rows({}), {"array", "angle_deg", ""}).groups[0].samples.ran.trend);
}

TEST_F(ASummary, LeavesOutOfMeansWhatCouldNotBePrepared)
{
  auto results = tenResults();
  results[0].insertion = {};
  results[0].insertion.reason = "no such cochlea";
  const StudyColumns columns = columnsOf(results);
  EXPECT_TRUE(std::isnan(columns.quantity("angle_deg")->values[0]));
  EXPECT_EQ(columns.quantity("A_mm")->values[0], 8.0);
  const StudySummary summary = summaryOfAll(columns, "array");
  EXPECT_EQ(summary.groups[0].rows.size(), 5u);  // it counts in the rate
  EXPECT_EQ(summary.groups[0].complete(), 4u);
  EXPECT_EQ(summary.groups[0].stopped(), 0u);
  EXPECT_EQ(summary.groups[0].notPrepared(), 1u);
  EXPECT_NEAR(summary.groups[0].samples.ran.quartiles[0]->value, 525.0,
              nearby);  // of 510, 520, 530, 540
  EXPECT_EQ(summary.differences[0].count, 4u);
  EXPECT_EQ(summary.groups[0].samples.ran.trend->count(), 4u);
}

TEST_F(ASummary, OfEndingsHasNoDifferences)
{
  const StudyColumns columns = columnsOf(tenResults());
  const StudySummary summary = summaryOfAll(columns, "ending");
  EXPECT_EQ(summary.groups.size(), 2u);
  EXPECT_TRUE(summary.differences.empty());
  EXPECT_EQ(summaryOfAll(columns, "").groups.size(), 1u);
}

TEST_F(ASummary, HasOnlyGroupsThatAFilterLeaves)
{
  const StudyColumns columns = columnsOf(tenResults());
  const StudySummary summary = summaryOf(columns, {1, 3}, {"A_mm", "angle_deg", "array"});
  ASSERT_EQ(summary.groups.size(), 1u);
  EXPECT_EQ(summary.groups[0].level, "flex28");
  EXPECT_FALSE(summary.groups[0].samples.ran.trend);  // of two points
  EXPECT_TRUE(summary.differences.empty());
}

TEST_F(ASummary, IsWrittenWithUnitsInTheHeaders)
{
  const StudyColumns columns = columnsOf(tenResults());
  const auto rows = columns.rows({});
  const auto tables = tablesOf(columns, rows, summaryOfAll(columns, "array"));
  ASSERT_EQ(tables.size(), summaryTables.size());
  EXPECT_THAT(tables[0].second, StartsWith("number,cochlea,A_mm,B_mm,st_length_mm,array,"));
  EXPECT_THAT(tables[1].second, HasSubstr(",angle_median_deg,angle_quartile25_deg,"));
  EXPECT_THAT(tables[1].second, HasSubstr("\nflex28,all that ran,5,4,1,0,80,"));
  EXPECT_THAT(tables[1].second, HasSubstr("\nflex28,complete,5,4,1,0,80,"));
  EXPECT_THAT(tables[2].second, HasSubstr("\nflex24,flex28,all that ran,paired,5,5,5,"));
  EXPECT_THAT(tables[3].second, HasSubstr("\nflex24,all that ran,A_mm,angle_deg,5,"));
}

}  // namespace
}  // namespace perilymph::study
