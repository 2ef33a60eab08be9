// SPDX-License-Identifier: BSD-3-Clause

// No insertion ends quietly wrong: it reaches its stop, or its end has a name.

#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "RandomScenario.h"
#include "ScenarioRun.h"

namespace perilymph::test {
namespace {

using haptics::InsertionEnd;

constexpr double microjoule = 1e-6;
constexpr double millimeter = 1e-3;

/// One tick may end above the limit; by as much as it adds at these speeds.
constexpr double forceOfOneTick = 0.1;  // [N]

void expectOutside(const ScenarioRun& run, InsertionEnd end)
{
  EXPECT_STREQ(nameOf(run.end), nameOf(end)) << run.error;
  EXPECT_GT(run.lowestTweezers, 10.0 * millimeter);
  EXPECT_LT(run.peakForce, 0.5);
  EXPECT_LT(run.unexplained, 0.01 * millimeter);
}

TEST(Insertion, OfACurvedArraySlipsOutOfTheOpeningAndNothingEntersBone)
{
  for (const char* residual : {"0.1", "0.15"})
    expectOutside(runScenario("contour-published", {{"start_inside_mm", "1"},
                                                    {"approach_turn_deg", "-5"},
                                                    {"residual_curvature_fraction", residual}}),
                  InsertionEnd::outOfOpening);
}

TEST(Insertion, WithRoughWallsBucklesInFrontOfTheOpeningAndNothingEntersBone)
{
  expectOutside(runScenario("contour-published", {{"array", "flex28"},
                                                  {"anatomy", "mean"},
                                                  {"friction_static", "0.4"},
                                                  {"friction_dynamic", "0.4"},
                                                  {"stop_travel_mm", "26"}}),
                InsertionEnd::buckled);
}

TEST(Insertion, StopsAtTheSurgeonsForceLimit)
{
  const ScenarioRun run = runScenario("contour-published", {{"stop_force_N", "0.1"}});
  EXPECT_EQ(run.end, InsertionEnd::stoppedByResistance);
  EXPECT_NEAR(run.endForce, 0.1, 1e-3);
  EXPECT_EQ(runScenario("contour-published", {{"stop_force_N", "0.5"}}).end,
            InsertionEnd::finished);
}

TEST(Insertion, JamsAtTwoNewtons)
{
  const ScenarioRun run = runScenario("contour-published", {{"array", "slim-modiolar"},
                                                            {"opening", "round-window"},
                                                            {"friction", "tissue"},
                                                            {"speed_mm_s", "10"},
                                                            {"stop_travel_mm", "16"}});
  EXPECT_STREQ(nameOf(run.end), "jammed") << run.error;
  EXPECT_GT(run.peakForce, 2.0);
  EXPECT_LT(run.peakForce, 2.0 + forceOfOneTick);
}

class OffAxis : public testing::TestWithParam<std::string> {};

TEST_P(OffAxis, InsertionAndWithdrawalReturnNoEnergyToTheHand)
{
  for (const char* anatomy : {"published", "mean", "clark"}) {
    const ScenarioRun run =
        runScenario("contour-published",
                    {{"anatomy", anatomy},
                     {"array", GetParam()},
                     {"opening", "round-window"},
                     {"withdraw", "true"},
                     {"speed_mm_s", "8"},
                     {"friction", "paper"},
                     {"approach_tilt_deg", "-5"},
                     {"approach_turn_deg", "15"},
                     {"stop_travel_mm", std::to_string(maxStopTravel_mm(GetParam(), 2.0))}});
    EXPECT_EQ(run.end, InsertionEnd::finished) << anatomy << ": " << nameOf(run.end) << run.error;
    EXPECT_GE(run.work, -microjoule) << anatomy;
    EXPECT_LE(run.peakForce, 2.0 + forceOfOneTick) << anatomy;
    EXPECT_LT(run.unexplained, 0.1 * millimeter) << anatomy;
    std::cout << anatomy << ": work " << run.work / microjoule << " uJ, peak " << run.peakForce
              << " N, in bone " << run.penetration / millimeter << " mm, beyond its compliance "
              << run.unexplained / millimeter << " mm\n";
  }
}

#ifdef ENDS_ALL
INSTANTIATE_TEST_SUITE_P(, OffAxis, testing::ValuesIn(shippedArrays()), [](const auto& about) {
  std::string name = about.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});
#else
INSTANTIATE_TEST_SUITE_P(, OffAxis, testing::Values("contour", "flex20"));
#endif

/// Counts of one sample of scenarios.
struct Count {
  int named = 0, sameEnd = 0, all = 0;
};

TEST(RandomScenarios, EndAtTheStopOrWithAName)
{
  Count count;
  for (std::uint64_t number = 0; number < ENDS_SCENARIOS; ++number) {
    session::Overrides keys = randomScenario(1, number);
    std::array<ScenarioRun, 2> runs;
    const std::array<const char*, 2> steps = {"0.5", "2"};
    for (std::size_t k = 0; k < steps.size(); ++k) {
      session::Overrides own = keys;
      own.emplace_back("dt_ms", steps[k]);
      runs[k] = runScenario("contour-published", own);
      const ScenarioRun& run = runs[k];
      const std::string about =
          std::to_string(number) + " " + textOf(own) + ": " + nameOf(run.end) + " " + run.error;
      EXPECT_NE(run.end, InsertionEnd::none) << about;
      EXPECT_NE(run.end, InsertionEnd::fault) << about;
      EXPECT_NE(run.end, InsertionEnd::refused) << about;
      EXPECT_GE(run.work, run.end == InsertionEnd::finished ? -microjoule : -1.0) << about;
      EXPECT_GT(run.lowestTweezers, 0.0) << about;
    }
    ++count.all;
    if (runs[0].end == runs[1].end)
      ++count.sameEnd;
    else
      std::cout << number << " " << textOf(keys) << ": " << nameOf(runs[0].end) << " with 0.5 ms, "
                << nameOf(runs[1].end) << " with 2 ms\n";
  }
  EXPECT_GE(count.sameEnd, 0.98 * count.all - 1.0);
}

}  // namespace
}  // namespace perilymph::test
