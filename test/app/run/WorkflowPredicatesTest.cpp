// SPDX-License-Identifier: BSD-3-Clause

// The actions that are allowed in each state of an insertion.

#include "gui/run/WorkflowPredicates.h"

#include <gtest/gtest.h>

#include <array>

#include "gui/run/Conclusion.h"

namespace perilymph::test {
namespace {

using gui::InputSource;
using gui::InsertionState;
using haptics::Workflow;

constexpr std::array all{Workflow::idle,   Workflow::armed,    Workflow::inserting,
                         Workflow::paused, Workflow::finished, Workflow::fault};

/// The loop runs, the array is 5 mm in, and no motion is requested.
InsertionState at(Workflow workflow, InputSource input = InputSource::scripted)
{
  InsertionState state;
  state.workflow = workflow;
  state.input = input;
  state.isRunning = true;
  state.travel = 5e-3;
  state.hasStylet = true;
  return state;
}

TEST(TheSetup, MayBeChangedBeforeAnInsertionAndAfterIt)
{
  for (const Workflow workflow : all) {
    const bool isBetween = workflow == Workflow::idle || workflow == Workflow::armed ||
                           workflow == Workflow::finished || workflow == Workflow::fault;
    EXPECT_EQ(gui::maySetUp(at(workflow)), isBetween) << int(workflow);
    EXPECT_EQ(gui::isBetweenInsertions(at(workflow)), isBetween) << int(workflow);
  }
}

TEST(TheSetup, MayNotBeChangedWhileTheHandMoves)
{
  InsertionState state = at(Workflow::armed);
  state.isMoving = true;
  EXPECT_FALSE(gui::maySetUp(state));
  EXPECT_TRUE(gui::isBetweenInsertions(state));
}

TEST(TheSetup, MayBeChangedWhileNoLoopRuns)
{
  for (const Workflow workflow : all) {
    InsertionState state = at(workflow);
    state.isRunning = false;
    EXPECT_TRUE(gui::maySetUp(state)) << int(workflow);
  }
}

TEST(TheScript, MayStartUntilTheInsertionIsOver)
{
  for (const Workflow workflow : all)
    EXPECT_EQ(gui::mayStart(at(workflow)), !gui::isOver(workflow)) << int(workflow);
}

TEST(TheMouse, StartsOnceAndThenMovesTheArrayItself)
{
  InsertionState state = at(Workflow::armed, InputSource::pointer);
  EXPECT_FALSE(gui::mayStart(state));
  EXPECT_FALSE(gui::mayPause(state));
  state.isRunning = false;
  EXPECT_TRUE(gui::mayStart(state));
}

TEST(ADevice, MayBePausedWhileItIsActiveAndThenContinuedUntilAFault)
{
  for (const Workflow workflow : all) {
    InsertionState state = at(workflow, InputSource::device);
    EXPECT_EQ(gui::mayStart(state), workflow != Workflow::fault) << int(workflow);
    EXPECT_FALSE(gui::mayPause(state)) << int(workflow);
    state.isDeviceActive = true;
    EXPECT_TRUE(gui::mayPause(state)) << int(workflow);
  }
}

TEST(Withdrawal, IsForAnArrayThatIsIn)
{
  EXPECT_TRUE(gui::mayWithdraw(at(Workflow::inserting)));
  EXPECT_TRUE(gui::mayWithdraw(at(Workflow::finished)));
  EXPECT_FALSE(gui::mayWithdraw(at(Workflow::armed)));
  EXPECT_FALSE(gui::mayWithdraw(at(Workflow::fault)));
  InsertionState out = at(Workflow::finished);
  out.travel = 0.0;
  EXPECT_FALSE(gui::mayWithdraw(out));
}

TEST(Withdrawal, IsAskedOfMouseAndDeviceOnlyAtTheEnd)
{
  for (const InputSource input : {InputSource::pointer, InputSource::device}) {
    EXPECT_FALSE(gui::mayWithdraw(at(Workflow::inserting, input)));
    EXPECT_TRUE(gui::mayWithdraw(at(Workflow::finished, input)));
  }
}

TEST(TheStylet, IsPulledOnceAndOnlyOutOfAnArrayThatHasOne)
{
  InsertionState state = at(Workflow::inserting);
  EXPECT_TRUE(gui::mayPullStylet(state));
  state.isStyletPulled = true;
  EXPECT_FALSE(gui::mayPullStylet(state));
  state.isStyletPulled = false;
  state.hasStylet = false;
  EXPECT_FALSE(gui::mayPullStylet(state));
  EXPECT_FALSE(gui::mayPullStylet(at(Workflow::armed)));
}

TEST(TheArray, IsHeldWhileTheLoopRunsWithoutAFault)
{
  EXPECT_TRUE(gui::mayHold(at(Workflow::armed)));
  EXPECT_FALSE(gui::mayHold(at(Workflow::fault)));
  InsertionState state = at(Workflow::idle);
  state.isRunning = false;
  EXPECT_FALSE(gui::mayHold(state));
}

TEST(TheRecordingOfAnEndedInsertion, IsClosedWheneverItBeginsToRest)
{
  gui::Conclusion conclusion;
  const auto isDue = [&](Workflow workflow, bool isResting) {
    haptics::TickOutput now;
    now.workflow = workflow;
    now.status = isResting ? haptics::resting : haptics::allWell;
    return conclusion.isDue(now);
  };
  EXPECT_FALSE(isDue(Workflow::inserting, true));  // a pause
  EXPECT_FALSE(isDue(Workflow::finished, false));
  EXPECT_TRUE(isDue(Workflow::finished, true));
  EXPECT_FALSE(isDue(Workflow::finished, true));
  EXPECT_FALSE(isDue(Workflow::finished, false));  // a hand that holds on, moves
  EXPECT_TRUE(isDue(Workflow::finished, true));
  EXPECT_TRUE(conclusion.isRequested());
  EXPECT_FALSE(isDue(Workflow::inserting, false));  // the withdrawal
  EXPECT_FALSE(conclusion.isRequested());
  EXPECT_TRUE(isDue(Workflow::finished, true));
}

}  // namespace
}  // namespace perilymph::test
