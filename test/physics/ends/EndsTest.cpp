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

/// The edge of the wall is that of the duct: bone beside the opening has its full stiffness.
TEST(Insertion, OfATipBesideTheOpeningMeetsBoneOfFullStiffness)
{
  const ScenarioRun run = runScenario("contour-published", {{"array", "slim-modiolar"},
                                                            {"anatomy", "mean"},
                                                            {"opening", "none"},
                                                            {"friction", "tissue"},
                                                            {"approach_tilt_deg", "30"},
                                                            {"approach_turn_deg", "-20"},
                                                            {"speed_mm_s", "17"},
                                                            {"nodes", "120"},
                                                            {"start_inside_mm", "1.7"},
                                                            {"stop_travel_mm", "16.3"},
                                                            {"dt_ms", "2"}});
  EXPECT_STREQ(nameOf(run.end), "buckled") << run.error;
  EXPECT_GT(run.penetration, 0.1 * millimeter);
  EXPECT_LT(run.unexplained, 0.1 * millimeter);
}

class OffAxis : public testing::TestWithParam<std::string> {};

/// An array turned by 15 degrees goes into the round window and out again.
ScenarioRun runOffAxis(const std::string& array, const char* anatomy, Push push)
{
  const ScenarioRun run =
      runScenario("contour-published",
                  {{"anatomy", anatomy},
                   {"array", array},
                   {"opening", "round-window"},
                   {"withdraw", "true"},
                   {"speed_mm_s", "8"},
                   {"friction", "paper"},
                   {"approach_tilt_deg", "-5"},
                   {"approach_turn_deg", "15"},
                   {"stop_travel_mm", std::to_string(maxStopTravel_mm(array, 2.0))}},
                  push);
  std::cout << anatomy << ": " << nameOf(run.end) << ", work " << run.work / microjoule
            << " uJ, peak " << run.peakForce << " N, in bone " << run.penetration / millimeter
            << " mm, beyond its compliance " << run.unexplained / millimeter << " mm, tweezers "
            << run.lowestTweezers / millimeter << " mm\n";
  return run;
}

TEST_P(OffAxis, InsertionAndWithdrawalReturnNoEnergyToTheHand)
{
  for (const char* anatomy : {"published", "mean", "clark"}) {
    const ScenarioRun run = runOffAxis(GetParam(), anatomy, Push::alongApproach);
    EXPECT_STREQ(nameOf(run.end), "finished") << anatomy << run.error;
    EXPECT_GE(run.work, -microjoule) << anatomy;
    EXPECT_LE(run.peakForce, 2.0 + forceOfOneTick) << anatomy;
    EXPECT_LT(run.unexplained, 0.1 * millimeter) << anatomy;
  }
}

/// The tweezers end 6 mm beside the opening, at the bone, with the array bent over the rim.
TEST_P(OffAxis, PushBesideTheOpeningEndsWithANameAndReturnsNoEnergy)
{
  for (const char* anatomy : {"published", "mean", "clark"}) {
    const ScenarioRun run = runOffAxis(GetParam(), anatomy, Push::alongOpening);
    EXPECT_NE(run.end, InsertionEnd::none) << anatomy;
    EXPECT_NE(run.end, InsertionEnd::fault) << anatomy << run.error;
    EXPECT_GE(run.work, -microjoule) << anatomy;
    EXPECT_LE(run.peakForce, 2.0 + forceOfOneTick) << anatomy;
    EXPECT_LT(run.unexplained, 0.1 * millimeter) << anatomy;
    EXPECT_GT(run.lowestTweezers, 0.1 * millimeter) << anatomy;
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

/// A scenario drawn at random, run with two time steps.
class RandomScenarios {
public:
  explicit RandomScenarios(std::array<const char*, 2> steps_ms) : steps_ms_(steps_ms) {}

  void run(const session::Overrides& keys)
  {
    std::array<InsertionEnd, 2> ends{};
    for (std::size_t k = 0; k < steps_ms_.size(); ++k) {
      session::Overrides own = keys;
      own.emplace_back("dt_ms", steps_ms_[k]);
      const ScenarioRun run = runScenario("contour-published", own);
      const bool isWithdrawn = run.depth < 0.5 * run.deepest && run.end == InsertionEnd::finished;
      const std::string about = textOf(own) + ": " + nameOf(run.end) + " " + run.error;
      EXPECT_NE(run.end, InsertionEnd::none) << about;
      EXPECT_NE(run.end, InsertionEnd::fault) << about;
      EXPECT_NE(run.end, InsertionEnd::refused) << about;
      // An array that is bent at its start may give that energy to the hand; over a closed loop it
      // may not.
      if (isWithdrawn) {
        EXPECT_GE(run.work, -microjoule) << about;
      }
      EXPECT_GT(run.lowestTweezers, 0.1 * millimeter) << about;
      EXPECT_LT(run.unexplained, 0.1 * millimeter) << about;
      ends[k] = run.end;
    }
    ++all_;
    if (ends[0] == ends[1]) return;
    ++different_;
    std::cout << textOf(keys) << ": " << nameOf(ends[0]) << " with " << steps_ms_[0] << " ms, "
              << nameOf(ends[1]) << " with " << steps_ms_[1] << " ms\n";
  }

  double differentFraction() const { return static_cast<double>(different_) / all_; }

private:
  std::array<const char*, 2> steps_ms_;
  int all_ = 0, different_ = 0;
};

#ifdef ENDS_ALL
TEST(RandomScenario, EndsAtTheStopOrWithANameTheSameForEveryStep)
{
  RandomScenarios scenarios({"0.5", "2"});
  for (std::uint64_t number = 0; number < 1000; ++number) scenarios.run(randomScenario(1, number));
  EXPECT_LE(scenarios.differentFraction(), 0.02);
}
#else
TEST(RandomScenario, EndsAtTheStopOrWithANameTheSameForEveryStep)
{
  RandomScenarios scenarios({"1", "2"});
  for (std::uint64_t number = 0; number < 24; ++number) {
    session::Overrides coarse = randomScenario(1, number);
    coarse.emplace_back("nodes", "30");
    coarse.emplace_back("speed_mm_s", "30");
    scenarios.run(coarse);
  }
  EXPECT_LE(scenarios.differentFraction(), 0.05);
}
#endif

}  // namespace
}  // namespace perilymph::test
