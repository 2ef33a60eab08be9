// SPDX-License-Identifier: BSD-3-Clause

// The workflow as the user sees it: commands and hand as input, states and motion as output.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

using device::ScriptedDevice;
using Kind = Command::Kind;

/// A rig that has inserted for some ticks.
test::InsertionRig rigInserting(int ticks = 100)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.start();
  for (int i = 0; i < ticks; ++i) rig.tick();
  return rig;
}

TEST(InsertionWorkflow, DoesNothingBeforeItIsArmed)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.device().move(ScriptedDevice::Motion::insert);
  const std::uint64_t before = rig.engine().state().fingerprint();
  for (int i = 0; i < 50; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::idle);
  EXPECT_EQ(rig.engine().state().fingerprint(), before);
}

TEST(InsertionWorkflow, WaitsForTheGraspOnceArmed)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.send(Kind::arm);
  for (int i = 0; i < 50; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::armed);
  EXPECT_NEAR(rig.output().travel, 0.0, 1e-15);
  EXPECT_EQ(rig.output().time, 0.0);
  EXPECT_EQ(rig.engine().state().tick, 50u);  // time runs for the rod

  rig.device().move(ScriptedDevice::Motion::insert);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
}

TEST(InsertionWorkflow, TravelsAtTheSpeedOfTheHand)
{
  test::InsertionRig rig = rigInserting(501);
  // 2 mm/s since the tick in which the hand took hold
  EXPECT_NEAR(rig.output().time, 0.5, 1e-12);
  EXPECT_NEAR(rig.output().travel, 2e-3 * 0.5, 1e-9);
  EXPECT_NEAR(rig.output().depth, 2e-3 + 1e-3, 1e-9);
}

TEST(InsertionWorkflow, HoldsTheBaseFromTheTickTheHandLetsGo)
{
  test::InsertionRig rig = rigInserting();
  const auto before = rig.output().proxy_W;
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 20; ++i) {
    rig.tick();
    EXPECT_EQ(rig.output().workflow, Workflow::paused);
    EXPECT_EQ(rig.output().proxy_W, before);
  }
}

TEST(InsertionWorkflow, CountsPausesInItsTime)
{
  test::InsertionRig rig = rigInserting(101);
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_NEAR(rig.output().time, 0.2, 1e-12);
}

TEST(InsertionWorkflow, ContinuesWhereItPaused)
{
  test::InsertionRig rig = rigInserting(101);
  const double travel = rig.output().travel;
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 10; ++i) rig.tick();
  rig.device().move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 101; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::inserting);
  EXPECT_NEAR(rig.output().travel - travel, 2e-3 * 0.1, 1e-9);
}

/// A rig whose hand feels a force and holds on.
test::InsertionRig feeling(EngineSettings settings = {})
{
  settings.forceScale = 100.0;  // the clamp acts: the largest force there is
  test::InsertionRig rig(test::insertionInRing(), settings);
  rig.start();
  EXPECT_TRUE(rig.runUntilTravel(millimeters(8), 10'000));
  return rig;
}

double shown(const test::InsertionRig& rig)
{
  const auto& force = rig.output().wrench_D.force_D;
  return std::hypot(force[0], force[1], force[2]);
}

TEST(Stop, TakesTheLargestForceAwayWithinFourTicksThoughTheHandHoldsOn)
{
  test::InsertionRig rig = feeling();
  ASSERT_NEAR(shown(rig), SafetyLimits{}.maxForce, 1e-9);
  rig.loop().requestStop();
  for (int i = 0; i < 4; ++i) rig.tick();
  EXPECT_EQ(shown(rig), 0.0);
  EXPECT_EQ(rig.output().workflow, Workflow::paused);
  EXPECT_NE(rig.output().status & stopped, 0u);
}

TEST(Stop, LastsUntilItIsTakenBackAndThenTheForceFadesIn)
{
  test::InsertionRig rig = feeling();
  rig.loop().requestStop();
  for (int i = 0; i < 3000; ++i) {
    rig.tick();
    if (i >= 4) {
      ASSERT_EQ(shown(rig), 0.0) << i;
    }
    ASSERT_EQ(rig.output().workflow, Workflow::paused) << i;
  }
  // Releasing the button and pressing it again does not continue either.
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 10; ++i) rig.tick();
  rig.device().move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 10; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::paused);

  rig.send(Kind::resume);
  double before = 0.0;
  const double maxStep = SafetyLimits{}.maxForce * 1e-3 / SafetyLimits{}.rampTime;
  for (int i = 0; i < 400; ++i) {
    rig.tick();
    EXPECT_EQ(rig.output().workflow, Workflow::inserting);
    EXPECT_EQ(rig.output().status & stopped, 0u);
    // A tick of passing time adds at most its part of the fade-in of the clamped force.
    EXPECT_LE(shown(rig) - before, maxStep * 1.001) << i;
    before = shown(rig);
  }
  EXPECT_GT(before, 0.0);
}

TEST(Stop, WinsOverAFullQueueAndWhatWaitsThereIsForgotten)
{
  test::InsertionRig rig = feeling();
  for (int i = 0; i < maxCommandsPerTick; ++i) rig.send(i % 2 == 0 ? Kind::resume : Kind::withdraw);
  rig.loop().requestStop();
  rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::paused);
  for (int i = 0; i < 20; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::paused);
  EXPECT_EQ(shown(rig), 0.0);
}

TEST(Stop, KeepsAnArmedLoopFromBeingGrasped)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.send(Kind::arm);
  rig.tick();
  rig.loop().requestStop();
  rig.device().move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(rig.tick().output.workflow, Workflow::armed);
  rig.send(Kind::resume);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
}

TEST(Stop, AtFullDepthTakesTheForceAndLeavesTheInsertionFinished)
{
  EngineSettings settings;
  settings.stopTravel = 8e-3;
  test::InsertionRig rig = feeling(settings);
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 1000));
  ASSERT_GT(shown(rig), 0.0);
  rig.loop().requestStop();
  for (int i = 0; i < 4; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::finished);
  EXPECT_EQ(shown(rig), 0.0);
}

TEST(Stop, EndsTheWithdrawalOfTheStylet)
{
  test::InsertionRig rig = rigInserting();
  rig.send(Kind::pullStylet, 5e-3);
  for (int i = 0; i < 100; ++i) rig.tick();
  rig.loop().requestStop();
  const double withdrawn = rig.tick().output.styletWithdrawal;
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_EQ(rig.output().styletWithdrawal, withdrawn);
  EXPECT_LT(withdrawn, 1e-3);
}

TEST(InsertionWorkflow, IgnoresRequestsItCannotMeet)
{
  test::InsertionRig rig(test::insertionInTube());
  for (const Kind kind : {Kind::withdraw, Kind::resume, Kind::pullStylet, Kind::none}) {
    rig.send(kind, 5e-3);
    EXPECT_EQ(rig.tick().output.workflow, Workflow::idle) << static_cast<int>(kind);
    EXPECT_EQ(rig.output().styletWithdrawal, 0.0);
  }
}

TEST(InsertionWorkflow, PullsTheStyletAtItsSpeedAndNeverPushesItBack)
{
  test::InsertionRig rig = rigInserting();
  rig.send(Kind::pullStylet, 2e-3);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_NEAR(rig.output().styletWithdrawal, 5e-3 * 0.1, 1e-12);
  for (int i = 0; i < 400; ++i) rig.tick();
  EXPECT_EQ(rig.output().styletWithdrawal, 2e-3);
  rig.send(Kind::pullStylet, 0.0);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_EQ(rig.output().styletWithdrawal, 2e-3);
}

TEST(InsertionWorkflow, RejectsInvalidCommands)
{
  test::InsertionRig rig = rigInserting();
  for (const double bad : {std::nan(""), -1.0, -std::numeric_limits<double>::infinity()}) {
    rig.send(Kind::pullStylet, bad);
    rig.tick();
    EXPECT_EQ(rig.output().styletWithdrawal, 0.0) << bad;
    EXPECT_TRUE(std::isfinite(rig.output().wrench_D.force_D[2])) << bad;
  }
  rig.send(static_cast<Kind>(4711));
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
}

}  // namespace
}  // namespace perilymph::haptics
