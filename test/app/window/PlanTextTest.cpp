// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanText.h"

#include <gtest/gtest.h>

#include <memory>

#include "gui/pages/plan/PlanTable.h"
#include "perilymph/analysis/ClinicalReports.h"
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
  EXPECT_TRUE(gui::differencesOf(syntheticPlan(16), {0, 1})
                  .contains("(lowest to highest of 16 simulations)"));
}

TEST(PlanTable, StatesWhatClinicsReportBesideItsValues)
{
  planning::Plan plan = syntheticPlan(64);
  const char* arrays[] = {"flex24", "contour"};
  for (std::size_t i = 0; i < 2; ++i) plan.arrays[i].array = arrays[i];
  gui::PlanTable table(nullptr);
  table.setPlan(std::make_shared<const planning::Plan>(plan));
  const auto angle = [&](int row, int role) {
    return table.index(row, int(gui::PlanColumn::angle)).data(role).toString();
  };
  // O'Connell et al. 2017
  EXPECT_TRUE(angle(0, Qt::AccessibleTextRole).endsWith("clinics report 408 (IQR 373–449)°"))
      << angle(0, Qt::AccessibleTextRole).toStdString();
  EXPECT_TRUE(angle(0, Qt::ToolTipRole).contains("n = 48"));
  EXPECT_FALSE(angle(1, Qt::AccessibleTextRole).contains("clinics"));
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  ASSERT_TRUE(evidence) << evidence.error().message;
  for (int row = 0; row < 2; ++row)
    EXPECT_EQ(angle(row, Qt::ToolTipRole).contains("Not validated"),
              evidence->verdictOf(arrays[row]) == analysis::ArrayVerdict::miss);
}

}  // namespace
}  // namespace perilymph::test
