// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Phase.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace perilymph::analysis {
namespace {

struct Case {
  const char* where;
  double depth_mm, travel_mm, angle_deg;
  std::uint32_t contacts;
  haptics::Workflow workflow;
  Phase phase;
};

TEST(Phase, FollowsTheTipThroughTheCochlea)
{
  using haptics::Workflow;
  const std::vector<Case> cases = {
      {"before the opening", 0.0, 0.0, 0.0, 0, Workflow::inserting, Phase::outside},
      {"touching the rim from outside", 0.0, 0.0, 0.0, 2, Workflow::inserting, Phase::outside},
      {"in the lead-in", 0.5, 0.5, 0.0, 0, Workflow::inserting, Phase::opening},
      {"past the round window, free", 3.0, 1.0, 10.0, 0, Workflow::inserting, Phase::opening},
      {"on the outer wall", 6.0, 4.0, 45.0, 5, Workflow::inserting, Phase::outerWall},
      {"at the published peak", 12.6, 10.6, 160.0, 20, Workflow::inserting, Phase::basalTurn},
      {"at the stop", 18.5, 16.5, 270.0, 60, Workflow::finished, Phase::full},
      {"withdrawn again", 2.0, 0.0, 9.0, 0, Workflow::finished, Phase::opening},
      {"withdrawn, its curve on the wall", 2.0, 0.02, 9.0, 4, Workflow::finished, Phase::opening},
      {"paused on the outer wall", 6.0, 4.0, 45.0, 5, Workflow::paused, Phase::outerWall}};
  for (const Case& c : cases) {
    haptics::TickOutput now;
    now.depth = millimeters(c.depth_mm).si();
    now.travel = millimeters(c.travel_mm).si();
    now.angularDepth = degrees(c.angle_deg).si();
    now.contacts = c.contacts;
    now.workflow = c.workflow;
    EXPECT_STREQ(phaseName(phaseOf(now, millimeters(16.5))), phaseName(c.phase)) << c.where;
  }
}

TEST(Phase, IsNotThatOfFullDepthAfterAnEarlyEnd)
{
  haptics::TickOutput now;
  now.depth = millimeters(23.3).si();
  now.travel = millimeters(22.3).si();
  now.angularDepth = degrees(430.0).si();
  now.contacts = 60;
  now.workflow = haptics::Workflow::finished;
  EXPECT_EQ(phaseOf(now, millimeters(27.0)), Phase::full);
  for (const std::uint32_t end : {haptics::endedBuckled, haptics::endedByResistance,
                                  haptics::endedFoldedTip, haptics::endedJammed}) {
    now.status = end;
    EXPECT_EQ(phaseOf(now, millimeters(27.0)), Phase::basalTurn) << end;
  }
}

}  // namespace
}  // namespace perilymph::analysis
