// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanText.h"

#include <gtest/gtest.h>

#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

TEST(PlanText, StatesTheBandsAtTheMedianFrictionWhereItHasASpread)
{
  planning::Plan plan = syntheticPlan(64);
  EXPECT_FALSE(gui::factsOf(plan.arrays[0], plan).contains("median friction"));
  plan.friction = {0.165, 0.165};
  plan.frictionSpread = 0.35;
  planning::addSummary(plan, plannedArrays());
  // all drawn frictions are the median, so nothing is taken out: 3.25 of 301 ... 364
  EXPECT_TRUE(gui::factsOf(plan.arrays[0], plan)
                  .startsWith("At the median friction, 0.165, only: 333 (303–362)°, peak force 33 "
                              "(3–62) mN."))
      << gui::factsOf(plan.arrays[0], plan).toStdString();
}

TEST(PlanText, StatesWhatTheShownArraysDifferBy)
{
  const planning::Plan plan = syntheticPlan(64);
  // 301 ... 364 less 500 degrees; both have the same peak
  EXPECT_EQ(gui::differencesOf(plan, {1, 0}).toStdString(),
            "Differences in the same ear, with the same hand and friction (90 %):\n"
            "FLEX24 against FLEX28: -168 (-197 to -138)°, deeper in 0 %; peak force 0 (0 to 0) mN, "
            "higher in 0 %.");
  EXPECT_TRUE(gui::differencesOf(plan, {0}).isEmpty());
  EXPECT_TRUE(gui::differencesOf(syntheticPlan(16), {0, 1}).contains("(16 simulations)"));
}

}  // namespace
}  // namespace perilymph::test
