// SPDX-License-Identifier: BSD-3-Clause

// Plans of two arrays with few nodes and long steps: not for their numbers, but for what must hold of
// any plan.

#include "perilymph/planning/Plan.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "PlanFile.h"
#include "SyntheticPlan.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

class SmallPlan : public testing::Test {
protected:
  SmallPlan()
  {
    std::ifstream shipped(resource("resources/scenarios/surgery-flex28.toml"));
    std::string text(std::istreambuf_iterator<char>(shipped), {});
    text = std::regex_replace(text, std::regex("nodes = [0-9]+"), "nodes = 30");
    text = std::regex_replace(text, std::regex("dt_ms = [0-9.]+"), "dt_ms = 10");
    std::ofstream(folder_.path() / "coarse.toml") << text;
    request_.patient = measuredPatient();
    request_.arrays = {"flex24", "hifocus-slimj"};
    request_.scenario = (folder_.path() / "coarse.toml").string();
    request_.draws = 3;
  }
  std::filesystem::path draws() const { return folder_.path() / "draws.sqlite"; }

  /// Everything that a plan writes.
  static std::string textOf(const planning::Plan& plan)
  {
    const auto json = planning::planJson(plan);
    std::string text = json ? *json : json.error().message;
    for (const auto& each : plan.insertions) text += planning::contentOf(each) + '\n';
    return text + planning::arraysCsv(plan) + planning::contactsCsv(plan);
  }

  TemporaryFolder folder_;
  planning::PlanRequest request_;
};

TEST_F(SmallPlan, IsTheSameForOneThreadAndTwoAndAfterAnInterruption)
{
  request_.jobs = 1;
  const auto one = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(one) << one.error().message;
  ASSERT_EQ(one->insertions.size(), 6u);
  request_.jobs = 2;
  request_.draws = 1;
  ASSERT_TRUE(planning::makePlan(request_, draws(), {}));
  request_.draws = 3;
  int calls = 0;
  const auto stopped =
      planning::makePlan(request_, draws(), [&](std::size_t, std::size_t) { return ++calls < 1; });
  EXPECT_FALSE(stopped);
  const auto two = planning::makePlan(request_, draws(), {});
  ASSERT_TRUE(two) << two.error().message;
  EXPECT_EQ(textOf(*one), textOf(*two));
}

TEST_F(SmallPlan, InsertsAllArraysIntoTheSameCochleaByTheSameHand)
{
  const auto plan = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(plan) << plan.error().message;
  for (std::size_t i = 0; i < plan->insertions.size(); i += 2) {
    const auto& a = plan->insertions[i];
    const auto& b = plan->insertions[i + 1];
    EXPECT_EQ(a.a_mm, b.a_mm);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_GT(a.insertion.apical.si(), 0.0);
    EXPECT_FALSE(a.insertion.contacts.empty());
    EXPECT_FALSE(a.insertion.profile.empty());
  }
  EXPECT_NE(plan->insertions[0].a_mm, plan->insertions[2].a_mm);
}

TEST_F(SmallPlan, OfAPatientWithoutABasalTurnIsRefused)
{
  request_.patient.basalTurn.reset();
  const auto plan = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("has no A and B"), std::string::npos);
}

TEST_F(SmallPlan, NamesAnArrayThatIsNotThere)
{
  request_.arrays = {"flex24", "flex99"};
  const auto plan = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("flex99"), std::string::npos) << plan.error().message;
}

TEST_F(SmallPlan, RefusesTheDrawsOfAnotherSeed)
{
  request_.draws = 1;
  ASSERT_TRUE(planning::makePlan(request_, draws(), {}));
  request_.seed = 2;
  const auto plan = planning::makePlan(request_, draws(), {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("another plan"), std::string::npos) << plan.error().message;
}

}  // namespace
}  // namespace perilymph::test
