// SPDX-License-Identifier: BSD-3-Clause

// The opening of a scenario: its passage and what goes with it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/session/Scenario.h"

namespace perilymph::session {
namespace {

TEST(ScenarioOpening, RefusesAPassageThatIsNotInAStraightStretch)
{
  const auto longer = loadScenario("contour-published", {{"passage_mm", "2"}, {"lead_in_mm", "1"}});
  ASSERT_FALSE(longer);
  EXPECT_THAT(longer.error().message,
              testing::HasSubstr("passage_mm is 2; the passage lies in the straight stretch before "
                                 "the spiral, whose lead_in_mm is 1."));
  const auto window =
      loadScenario("contour-published", {{"passage_mm", "1"}, {"opening", "round-window"}});
  ASSERT_FALSE(window);
  EXPECT_THAT(window.error().message, testing::HasSubstr("only a drilled opening has a passage"));
}

TEST(ScenarioOpening, LeavesThePassageOutWithAnotherOpening)
{
  const auto drilled = loadScenario("contour-published", {{"passage_mm", "1"}});
  ASSERT_TRUE(drilled) << drilled.error().message;
  EXPECT_EQ(drilled->parameters().opening->passage, millimeters(1));
  const auto window = drilled->with({{"opening", "round-window"}});
  ASSERT_TRUE(window) << window.error().message;
  EXPECT_EQ(window->parameters().opening->passage, millimeters(0));
}

}  // namespace
}  // namespace perilymph::session
