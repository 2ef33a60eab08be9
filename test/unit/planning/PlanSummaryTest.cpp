// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "SyntheticPlan.h"
#include "perilymph/analysis/Tonotopy.h"

namespace perilymph::test {
namespace {

using planning::ArrayPlan;

TEST(PlanSummary, GivesTheQuantilesOfEachArraysDraws)
{
  const auto arrays = syntheticPlan(101).arrays;
  ASSERT_EQ(arrays.size(), 2u);
  EXPECT_EQ(arrays[0].draws, 101u);
  EXPECT_NEAR(arrays[0].angle_deg.median, 351.0, 1e-9);
  EXPECT_NEAR(arrays[0].angle_deg.low, 306.0, 1e-9);
  EXPECT_NEAR(arrays[0].angle_deg.high, 396.0, 1e-9);
  EXPECT_NEAR(arrays[1].angle_deg.low, 500.0, 1e-9);
  EXPECT_NEAR(arrays[0].peak_mN.lowerQuartile, 26.0, 1e-9);
  EXPECT_NEAR(arrays[0].end_mN.upperQuartile, 38.0, 1e-9);
  EXPECT_NEAR(arrays[0].coverage_percent.median, 50.0, 1e-9);
}

TEST(PlanSummary, CountsEveryEnd)
{
  const ArrayPlan array = syntheticPlan(100).arrays[0];
  EXPECT_NEAR(array.full.value, 0.75, 1e-12);
  EXPECT_NEAR(array.resisted.value, 0.25, 1e-12);
  EXPECT_NEAR(array.buckled.value, 0.0, 1e-12);
  EXPECT_GT(array.buckled.high, 0.03);  // none in a hundred is no proof of none
  EXPECT_NEAR(array.ruptured.value, 0.1, 1e-12);
}

TEST(PlanSummary, LeavesAnInsertionThatCouldNotBePreparedOutOfTheBandsButNotOutOfTheCount)
{
  auto insertions = syntheticInsertions(100);
  insertions[0].insertion = {};  // refused, without values
  const auto arrays =
      planning::summarize(syntheticPlan(1).request, {"FLEX24", "FLEX28"}, insertions);
  EXPECT_NEAR(arrays[0].other.value, 0.01, 1e-12);
  EXPECT_GT(arrays[0].angle_deg.low, 305.0);
}

TEST(PlanSummary, GivesAForceBandOnlyWhereEnoughDrawsCame)
{
  const auto arrays = syntheticPlan(101).arrays;
  ASSERT_EQ(arrays[0].force.size(), 4u);
  EXPECT_EQ(arrays[0].force[3].draws, 10u);
  EXPECT_NEAR(arrays[0].force[3].depth_mm, 1.5, 1e-12);
  EXPECT_NEAR(arrays[0].force[3].force_mN.median, 5.5, 1e-9);
  EXPECT_EQ(arrays[1].force.size(), 3u);
  EXPECT_TRUE(syntheticPlan(7).arrays[0].force.empty());
}

TEST(PlanSummary, CountsAContactWhereItIsInserted)
{
  const ArrayPlan array = syntheticPlan(101).arrays[0];
  ASSERT_EQ(array.contacts.size(), 2u);
  EXPECT_EQ(array.contacts[0].draws, 101u);
  EXPECT_EQ(array.contacts[1].draws, 51u);
  EXPECT_NEAR(array.contacts[0].toModiolus_mm.median, 1.0, 1e-12);
  EXPECT_NEAR(array.contacts[0].greenwood_Hz, analysis::greenwoodFrequency(0.5), 1e-9);
}

TEST(PlanSummary, RanksWhatExplainsTheAngle)
{
  const auto arrays = syntheticPlan(101).arrays;
  EXPECT_EQ(arrays[0].influences.front().input, "A");
  EXPECT_NEAR(arrays[0].influences.front().onAngle, 1.0, 1e-9);
  EXPECT_NEAR(arrays[0].influences.front().onPeak, 1.0, 1e-9);
  // an angle that does not vary is explained by nothing
  for (const auto& each : arrays[1].influences) EXPECT_EQ(each.onAngle, 0.0) << each.input;
}

TEST(PlanSummary, FindsThatBandsStandWithEnoughDraws)
{
  EXPECT_FALSE(planning::bandsStand(syntheticPlan(16).arrays));
  EXPECT_FALSE(
      planning::bandsStand(syntheticPlan(200).arrays));  // its angles spread by 200 degrees
  auto steady = syntheticInsertions(64);
  for (auto& each : steady) {
    each.insertion.apical = degrees(400.0 + static_cast<double>(each.draw % 8));
    each.insertion.peak = millinewtons(80.0 + static_cast<double>(each.draw % 8));
  }
  EXPECT_TRUE(planning::bandsStand(
      planning::summarize(syntheticPlan(1).request, {"FLEX24", "FLEX28"}, steady)));
}

}  // namespace
}  // namespace perilymph::test
