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
test::InsertionRig inserting(int ticks = 100)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.start();
  for (int i = 0; i < ticks; ++i) rig.tick();
  return rig;
}

TEST(InsertionWorkflow, DoesNothingBeforeItIsArmed)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.hand().move(ScriptedDevice::Motion::insert);
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

  rig.hand().move(ScriptedDevice::Motion::insert);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
}

TEST(InsertionWorkflow, TravelsAtTheSpeedOfTheHand)
{
  test::InsertionRig rig = inserting(501);
  // 2 mm/s since the tick in which the hand took hold
  EXPECT_NEAR(rig.output().time, 0.5, 1e-12);
  EXPECT_NEAR(rig.output().travel, 2e-3 * 0.5, 1e-9);
  EXPECT_NEAR(rig.output().depth, 2e-3 + 1e-3, 1e-9);
}

TEST(InsertionWorkflow, HoldsTheBaseFromTheTickTheHandLetsGo)
{
  test::InsertionRig rig = inserting();
  const auto before = rig.output().proxy_W;
  rig.hand().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 20; ++i) {
    rig.tick();
    EXPECT_EQ(rig.output().workflow, Workflow::paused);
    EXPECT_EQ(rig.output().proxy_W, before);
  }
}

TEST(InsertionWorkflow, CountsPausesInItsTime)
{
  test::InsertionRig rig = inserting(101);
  rig.hand().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_NEAR(rig.output().time, 0.2, 1e-12);
}

TEST(InsertionWorkflow, ContinuesWhereItPaused)
{
  test::InsertionRig rig = inserting(101);
  const double travel = rig.output().travel;
  rig.hand().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 10; ++i) rig.tick();
  rig.hand().move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 101; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::inserting);
  EXPECT_NEAR(rig.output().travel - travel, 2e-3 * 0.1, 1e-9);
}

TEST(InsertionWorkflow, ResetPutsTheArrayBackToItsStart)
{
  test::InsertionRig fresh(test::insertionInTube());
  test::InsertionRig rig = inserting();
  rig.hand().move(ScriptedDevice::Motion::hold);
  rig.send(Kind::reset);
  rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::idle);
  EXPECT_EQ(rig.output().travel, 0.0);
  EXPECT_EQ(rig.output().time, 0.0);
  EXPECT_EQ(rig.engine().state().fingerprint(), fresh.engine().state().fingerprint());
}

TEST(InsertionWorkflow, RunsTheSameInsertionAgainAfterAReset)
{
  test::InsertionRig rig = inserting(300);
  const auto first = rig.engine().state().fingerprint();
  rig.hand().move(ScriptedDevice::Motion::hold);
  rig.send(Kind::reset);
  rig.tick();
  rig.start();
  for (int i = 0; i < 300; ++i) rig.tick();
  // The hand is at another position now: equal up to the rounding of its position.
  EXPECT_NEAR(rig.output().travel, 2e-3 * 0.299, 1e-9);
  EXPECT_EQ(rig.engine().state().tick, 300u);
  EXPECT_NE(first, 0u);
}

TEST(InsertionWorkflow, StopsAtTheEmergencyStopUntilItIsCleared)
{
  test::InsertionRig rig = inserting();
  rig.send(Kind::requestFault);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::fault);
  const double travel = rig.output().travel;
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::fault);
  EXPECT_EQ(rig.output().travel, travel);

  rig.send(Kind::clearFault);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::idle);
  EXPECT_EQ(rig.output().travel, travel);
}

TEST(InsertionWorkflow, IgnoresRequestsItCannotMeet)
{
  test::InsertionRig rig(test::insertionInTube());
  for (const Kind kind : {Kind::withdraw, Kind::clearFault, Kind::pullStylet, Kind::none}) {
    rig.send(kind, 5e-3);
    EXPECT_EQ(rig.tick().output.workflow, Workflow::idle) << static_cast<int>(kind);
    EXPECT_EQ(rig.output().styletWithdrawal, 0.0);
  }
}

TEST(InsertionWorkflow, PullsTheStyletAtItsSpeedAndNeverPushesItBack)
{
  test::InsertionRig rig = inserting();
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
  test::InsertionRig rig = inserting();
  for (const double bad : {std::nan(""), -1.0, -std::numeric_limits<double>::infinity()}) {
    rig.send(Kind::pullStylet, bad);
    rig.send(Kind::setForceScale, bad);
    rig.tick();
    EXPECT_EQ(rig.output().styletWithdrawal, 0.0) << bad;
    EXPECT_TRUE(std::isfinite(rig.output().wrench_D.force_D[2])) << bad;
  }
  rig.send(static_cast<Kind>(4711));
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
}

}  // namespace
}  // namespace perilymph::haptics
