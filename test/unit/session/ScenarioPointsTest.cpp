// SPDX-License-Identifier: BSD-3-Clause

// The published model of points is what was published.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/session/Scenario.h"

namespace perilymph::session {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Todd and Naghdy, section II: the array enters straight; 441 and 200 N/m; 0.0605, 0.0395, 0.0185.
TEST(ScenarioModel, OfPointsIsThePublishedOneOrRefused)
{
  EXPECT_TRUE(loadScenario("mean-contour", {{"model", "points"}}));
  EXPECT_TRUE(loadScenario("contour-published", {{"model", "points"}, {"coupling", "spring"}}));
  const Overrides others = {
      {"approach_tilt_deg", "0.1"},   {"approach_turn_deg", "-30"},
      {"wall_stiffness_N_m", "2700"}, {"wall_tangential_stiffness_N_m", "201"},
      {"friction", "endosteum"},      {"friction", "tissue"},
      {"friction_dynamic", "0.0396"}};
  for (const auto& other : others) {
    const Overrides all = {{"model", "points"}, other};
    const auto scenario = loadScenario("mean-contour", all);
    ASSERT_FALSE(scenario) << other.first << " " << other.second;
    EXPECT_THAT(scenario.error().message,
                AllOf(HasSubstr(other.first), HasSubstr("published model of points")));
    const auto changed = loadScenario("mean-contour", {{"model", "points"}})->with({other});
    EXPECT_FALSE(changed) << other.first;
    EXPECT_TRUE(loadScenario("mean-contour", {other})) << "a rod may have it";
  }
  EXPECT_TRUE(loadScenario("mean-contour", {{"model", "points"}, {"dt_ms", "5"}}));
  EXPECT_FALSE(
      loadScenario("mean-contour", {{"model", "points"}, {"dt_ms", "2"}, {"coupling", "spring"}}));
  const Overrides stiff = {
      {"model", "points"}, {"coupling", "spring"}, {"coupling_stiffness_N_m", "500"}};
  const auto other = loadScenario("contour-published", stiff);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("coupling_stiffness_N_m is 500"));
}

// What an older program recorded is replayed.
TEST(ScenarioModel, OfPointsWithOtherNumbersIsReadFromARecording)
{
  const auto read = parseScenario("model = 'points'\napproach_tilt_deg = 28.4\n", "recorded");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_FALSE(read->with({{"speed_mm_s", "1"}}));
}

}  // namespace
}  // namespace perilymph::session
