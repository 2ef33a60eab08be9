// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanSummary.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

/// Draws of two arrays. The logarithm of the friction is 0.1 or 0.5, the ear adds 0 or 200 degrees,
/// and each array adds 0 to 7 degrees of its own; all in every combination, so none explains another.
planning::Plan crossedPlan()
{
  planning::Plan plan = syntheticPlan(1);
  plan.friction = {0.165, 0.165};
  plan.frictionSpread = 0.35;
  plan.insertions.clear();
  for (std::size_t draw = 0; draw < 64; ++draw)
    for (std::size_t array = 0; array < 2; ++array) {
      planning::PlannedInsertion one;
      one.draw = draw + 1;
      one.array = array;
      const double log = draw % 2 == 0 ? 0.1 : 0.5, ear = draw / 2 % 2 == 0 ? 0.0 : 200.0;
      const auto own = static_cast<double>(draw / 4 % 8);
      one.friction = std::exp(log);
      one.insertion.end = haptics::InsertionEnd::finished;
      one.insertion.apical = degrees(300.0 + ear - 100.0 * log + (array == 0 ? own : 30.0));
      one.insertion.depth = millimeters(20.0 - 2.0 * log);
      one.insertion.peak = millinewtons(50.0 + 20.0 * log + (array == 0 ? 0.0 : own - 2.0));
      one.insertion.endForce = millinewtons(40.0 + 30.0 * log);
      plan.insertions.push_back(one);
    }
  planning::addSummary(plan, plannedArrays());
  return plan;
}

TEST(AtMedianFriction, TakesOutWhatFollowsTheFrictionAndNothingElse)
{
  const planning::Plan plan = crossedPlan();
  const auto& found = plan.arrays[1].atMedianFriction;
  ASSERT_TRUE(found);
  // at the median, whose logarithm is 0, although all drawn frictions are above it
  EXPECT_NEAR(found->angle_deg.low, 330.0, 1e-9);
  EXPECT_NEAR(found->angle_deg.high, 530.0, 1e-9);  // the ear stays
  EXPECT_NEAR(found->depth_mm.median, 20.0, 1e-9);
  EXPECT_NEAR(found->depth_mm.high - found->depth_mm.low, 0.0, 1e-9);
  EXPECT_NEAR(found->end_mN.low, 40.0, 1e-9);
  EXPECT_NEAR(found->peak_mN.low, 48.0, 1e-9);
  EXPECT_NEAR(found->peak_mN.high, 55.0, 1e-9);
  EXPECT_NEAR(plan.arrays[1].end_mN.low, 43.0, 1e-9);  // the total band keeps the friction
  EXPECT_NEAR(plan.arrays[1].end_mN.high, 55.0, 1e-9);
}

TEST(AtMedianFriction, IsNotBelowZeroAndAbsentWhereTheFrictionStatesNoSpread)
{
  planning::Plan plan = crossedPlan();
  for (auto& each : plan.insertions)
    each.insertion.endForce = millinewtons(30.0 * std::log(each.friction) - 10.0);
  planning::addSummary(plan, plannedArrays());
  EXPECT_EQ(plan.arrays[0].atMedianFriction->end_mN.median, 0.0);
  plan.frictionSpread = 0.0;
  planning::addSummary(plan, plannedArrays());
  EXPECT_FALSE(plan.arrays[0].atMedianFriction);
}

TEST(ArrayDifference, HasNothingOfWhatBothArraysShare)
{
  const planning::Plan plan = crossedPlan();
  ASSERT_EQ(plan.differences.size(), 1u);
  const planning::ArrayDifference& found = plan.differences[0];
  EXPECT_EQ(found.draws, 64u);
  EXPECT_GT(plan.arrays[0].angle_deg.high - plan.arrays[0].angle_deg.low, 240.0);
  EXPECT_NEAR(found.angle_deg.low, -30.0, 1e-9);  // own - 30
  EXPECT_NEAR(found.angle_deg.high, -23.0, 1e-9);
  EXPECT_NEAR(found.depth_mm.high, 0.0, 1e-12);
  EXPECT_NEAR(found.peak_mN.low, -5.0, 1e-9);  // 2 - own
  EXPECT_NEAR(found.peak_mN.high, 2.0, 1e-9);
  EXPECT_EQ(found.deeper.value, 0.0);
  EXPECT_GT(found.deeper.high, 0.03);
  EXPECT_NEAR(found.harder.value, 0.25, 1e-12);  // own 0 and 1 of 0 to 7; 2 is equal
}

TEST(ArrayDifference, LeavesOutDrawsInWhichOneCouldNotBePrepared)
{
  planning::Plan plan = crossedPlan();
  plan.insertions[0].insertion = {};
  plan.insertions[3].insertion = {};
  planning::addSummary(plan, plannedArrays());
  EXPECT_EQ(plan.differences[0].draws, 62u);
  EXPECT_NEAR(plan.differences[0].angle_deg.low, -30.0, 1e-9);
}

TEST(PlanReport, WritesAndReadsBandsAtTheMedianFrictionAndDifferences)
{
  const planning::Plan plan = crossedPlan();
  const auto text = planning::planJson(plan);
  ASSERT_TRUE(text) << text.error().message;
  const auto stored = planning::planIn(*text, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  const planning::ArrayDifference &written = plan.differences[0],
                                  &read = stored->plan.differences[0];
  EXPECT_EQ(read.first, 0u);
  EXPECT_EQ(read.second, 1u);
  EXPECT_EQ(read.draws, written.draws);
  EXPECT_NEAR(read.angle_deg.lowerQuartile, written.angle_deg.lowerQuartile, 1e-3);
  EXPECT_NEAR(read.peak_mN.upperQuartile, written.peak_mN.upperQuartile, 1e-4);
  EXPECT_NEAR(read.harder.high, written.harder.high, 1e-5);
  EXPECT_NEAR(stored->plan.arrays[0].atMedianFriction->angle_deg.median,
              plan.arrays[0].atMedianFriction->angle_deg.median, 1e-3);

  std::istringstream table(planning::differencesCsv(plan));
  std::string head, row;
  std::getline(table, head);
  std::getline(table, row);
  EXPECT_EQ(std::ranges::count(head, ','), std::ranges::count(row, ','));
  EXPECT_EQ(row.substr(0, 17), "flex24,flex28,64,");
  EXPECT_EQ(std::ranges::count(planning::arraysCsv(plan), '\n'), 3);

  auto other = nlohmann::json::parse(*text);
  other["differences"][0]["second"] = "flex20";
  const auto refused = planning::planIn(other.dump(), "plan.json");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("second is none of its arrays"), std::string::npos);
  // a file of a version without them
  other.erase("differences");
  for (auto& array : other["arrays"]) array.erase("at_median_friction");
  const auto former = planning::planIn(other.dump(), "plan.json");
  ASSERT_TRUE(former) << former.error().message;
  EXPECT_TRUE(former->plan.differences.empty());
  EXPECT_FALSE(former->plan.arrays[0].atMedianFriction);
}

}  // namespace
}  // namespace perilymph::test
