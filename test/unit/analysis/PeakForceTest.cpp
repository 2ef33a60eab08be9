// SPDX-License-Identifier: BSD-3-Clause

// One definition of the peak force, wherever it is shown.

#include <gtest/gtest.h>

#include <stop_token>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Highlights.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::analysis {
namespace {

using haptics::Workflow;

haptics::TickRecord tick(Workflow workflow, double time, double force)
{
  haptics::TickRecord record;
  record.output.workflow = workflow;
  record.output.time = time;
  record.output.travel = record.output.depth = time * 1e-3;
  record.output.axialForce = force;
  return record;
}

/// The force is largest before the motion, after the reset, and, of those that count, in the tick
/// that ends the insertion.
TEST(PeakForce, IsThatOfTheHandFromTheFirstMotionToTheTickThatEndsIt)
{
  for (const Workflow end : {Workflow::finished, Workflow::fault, Workflow::paused}) {
    ForceProfiler profiler;
    session::Highlights highlights;
    for (const auto& each : {tick(Workflow::armed, 0.0, 5.0), tick(Workflow::inserting, 1.0, -0.1),
                             tick(Workflow::inserting, 2.0, 0.2), tick(end, 3.0, 0.3),
                             tick(Workflow::idle, 4.0, 7.0)}) {
      profiler.add(each);
      highlights.add(each);
    }
    EXPECT_EQ(profiler.profile().peak.force, 0.3);
    EXPECT_EQ(profiler.profile().peak.travel, 3e-3);
    EXPECT_EQ(highlights.peakForce, 0.3);
    EXPECT_EQ(highlights.peakTravel, 3e-3);
  }
}

TEST(PeakForce, IsNoneOfATickThatHasNotFoundItsBalance)
{
  ForceProfiler profiler;
  session::Highlights highlights;
  haptics::TickRecord unbalanced = tick(Workflow::inserting, 2.0, 0.2);
  unbalanced.output.status = haptics::notConverged;
  for (const auto& each :
       {tick(Workflow::inserting, 1.0, 0.05), unbalanced, tick(Workflow::inserting, 3.0, 0.06)}) {
    profiler.add(each);
    highlights.add(each);
  }
  EXPECT_EQ(profiler.profile().peak.force, 0.06);
  EXPECT_EQ(highlights.peakForce, 0.06);
}

TEST(PeakForce, IsNoneOfAHandThatOnlyPulls)
{
  ForceProfiler profiler;
  session::Highlights highlights;
  for (int i = 1; i < 4; ++i) {
    profiler.add(tick(Workflow::inserting, i, -0.1));
    highlights.add(tick(Workflow::inserting, i, -0.1));
  }
  EXPECT_EQ(profiler.profile().peak.force, 0.0);
  EXPECT_EQ(highlights.peakForce, 0.0);
}

TEST(PeakForce, OfOneInsertionIsTheSameInAStudyAChartAndAList)
{
  const auto scenario = session::loadScenario(
      "mean-flex28", {{"nodes", "20"}, {"dt_ms", "10.0"}, {"stop_travel_mm", "12.0"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  auto parameters = scenario->parameters();
  parameters.withdraws = false;
  const auto anatomy = session::buildAnatomy(*scenario);
  ASSERT_TRUE(anatomy) << anatomy.error().message;
  auto insertion = session::Insertion::prepare(
      parameters,
      std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()),
      *anatomy);
  ASSERT_TRUE(insertion) << insertion.error().message;
  ForceProfiler profiler;
  session::Highlights highlights;
  ASSERT_TRUE((*insertion)
                  ->runToEnd(
                      [&](const haptics::TickRecord& record) {
                        profiler.add(record);
                        highlights.add(record);
                        return true;
                      },
                      session::maxTicks(parameters, (*insertion)->model())));
  const InsertionRun full = runInsertion(parameters, *anatomy, millimeters(1), {});
  EXPECT_GT(full.peak.force, millinewtons(1));
  EXPECT_EQ(full.peak.force.si(), profiler.profile().peak.force);
  EXPECT_EQ(full.peak.depth.si(), profiler.profile().peakDepth);
  EXPECT_EQ(full.peak.force.si(), highlights.peakForce);
  EXPECT_EQ(full.peak.depth.si(), highlights.peakDepth);
}

}  // namespace
}  // namespace perilymph::analysis
