// SPDX-License-Identifier: BSD-3-Clause
#include "StopLengths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "perilymph/planning/Plan.h"
#include "perilymph/planning/ResistanceGrid.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

planning::PlanRequest smallRequest()
{
  planning::PlanRequest request;
  request.patient = measuredPatient();
  request.arrays = {"flex28", "flex24"};
  request.resolution = planning::Resolution{30, milliseconds(10)};
  request.draws = 3;
  return request;
}

TEST(StopLengths, AreThoseOfThePlansSimulationsAndKeptBesideIt)
{
  const TemporaryFolder folder;
  const planning::PlanRequest request = smallRequest();
  const auto plan = planning::makePlan(request, {}, {});
  ASSERT_TRUE(plan) << plan.error().message;
  std::size_t computed = 0;
  const auto count = [&](std::size_t, std::size_t) { ++computed; };
  const auto lengths = outcome::stopLengths(request, 0, folder.path(), count);
  ASSERT_TRUE(lengths) << lengths.error().message;
  ASSERT_EQ(lengths->size(), 3u);
  EXPECT_GT(computed, 0u);
  for (const planning::UnstoppedDraw& each : *lengths) {
    const auto& planned = plan->insertions[2 * (each.draw - 1)];
    ASSERT_EQ(planned.draw, each.draw);
    ASSERT_EQ(planned.array, 0u);
    EXPECT_DOUBLE_EQ(each.friction, planned.friction);
    EXPECT_DOUBLE_EQ(inMillinewtons(each.stop), planned.stop_mN);
    EXPECT_DOUBLE_EQ(inMillimeters(each.intended), planned.intended_mm);
    if (planned.insertion.end != haptics::InsertionEnd::stoppedByResistance) continue;
    // the same push: where it was stopped, but for the rest, in which the tip goes on by some 0.1 mm
    const auto length = each.curve.lengthAt(each.stop);
    ASSERT_TRUE(length) << each.draw;
    EXPECT_NEAR(inMillimeters(*length), inMillimeters(planned.insertion.depth), 0.4) << each.draw;
  }
  // a second call computes nothing and gives the same bits
  computed = 0;
  const auto again = outcome::stopLengths(request, 0, folder.path(), count);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(computed, 0u);
  for (std::size_t i = 0; i < lengths->size(); ++i) {
    ASSERT_EQ((*again)[i].curve.rises.size(), (*lengths)[i].curve.rises.size());
    EXPECT_EQ((*again)[i].curve.rises.back().force, (*lengths)[i].curve.rises.back().force);
    EXPECT_EQ((*again)[i].curve.depth, (*lengths)[i].curve.depth);
    EXPECT_EQ((*again)[i].curve.end, (*lengths)[i].curve.end);
  }
  // one more simulation is added to those that are there
  planning::PlanRequest longer = request;
  longer.draws = 4;
  const auto more = outcome::stopLengths(longer, 0, folder.path());
  ASSERT_TRUE(more) << more.error().message;
  EXPECT_EQ(more->size(), 4u);
  // the file is of this plan alone
  planning::PlanRequest other = request;
  other.seed = 2;
  const auto refused = outcome::stopLengths(other, 0, folder.path());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("belongs to another plan"), std::string::npos);
}

TEST(StopLengths, RefuseAnArrayThatThePlanHasNotAndAFileThatIsNone)
{
  const TemporaryFolder folder;
  const auto none = outcome::stopLengths(smallRequest(), 2, folder.path());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "The plan has no array 3; it has 2. Choose one of them.");
  std::ofstream(folder.path() / outcome::stopLengthsFile(0)) << "no table";
  EXPECT_FALSE(outcome::stopLengths(smallRequest(), 0, folder.path()));
}

TEST(StopDraw, HasTheDepthAtTheShiftedLimit)
{
  planning::UnstoppedDraw draw;
  draw.friction = std::exp(0.25);
  draw.stop = millinewtons(50);
  draw.intended = millimeters(25);
  draw.curve.end = haptics::InsertionEnd::buckled;
  draw.curve.depth = millimeters(22);
  // one millimeter for each 4 mN
  for (int i = 0; i <= 22; ++i) draw.curve.rises.push_back({millimeters(i), millinewtons(4.0 * i)});
  const planning::StopDraw found = planning::stopDrawOf(draw);
  EXPECT_NEAR(found.logFriction, 0.25, 1e-12);
  constexpr std::size_t middle = (planning::stopShifts - 1) / 2;
  EXPECT_DOUBLE_EQ(found.stop_mm[middle], 13.0);  // 50 mN is reached at the point of 52
  EXPECT_DOUBLE_EQ(found.depth_mm(middle), 13.0);
  // e^0.75 50 mN = 105.9 mN is not reached before it buckles at 22 mm
  EXPECT_TRUE(std::isinf(found.stop_mm[planning::stopShifts - 1]));
  EXPECT_FALSE(found.isFull);
  EXPECT_DOUBLE_EQ(found.depth_mm(planning::stopShifts - 1), 22.0);
}

}  // namespace
}  // namespace perilymph::test
