// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/WorkflowPredicates.h"

namespace perilymph::gui {

using haptics::Workflow;

InsertionState stateOf(const InsertionControl& control)
{
  const haptics::TickOutput& now = control.now().output;
  return {now.workflow,
          control.input(),
          control.isRunning(),
          control.isMoving(),
          control.isAtDepth(),
          now.travel,
          control.scenario().array().hasStylet,
          control.isStyletPulled(),
          control.isDeviceActive()};
}

bool hasBegun(Workflow workflow)
{
  return workflow != Workflow::idle && workflow != Workflow::armed;
}

bool isOver(Workflow workflow)
{
  return workflow == Workflow::finished || workflow == Workflow::fault;
}

bool isUnderway(const InsertionState& state) { return state.isRunning && hasBegun(state.workflow); }

bool hasArrived(const InsertionState& state)
{
  return isUnderway(state) && state.isAtDepth && !state.isMoving;
}

bool isBetweenInsertions(const InsertionState& state)
{
  return !isUnderway(state) || isOver(state.workflow) || hasArrived(state);
}

bool maySetUp(const InsertionState& state) { return isBetweenInsertions(state) && !state.isMoving; }

bool mayPause(const InsertionState& state)
{
  return state.isDeviceActive || (state.input == InputSource::scripted && state.isMoving);
}

bool mayStart(const InsertionState& state)
{
  if (state.input == InputSource::scripted) return !isOver(state.workflow) && !hasArrived(state);
  const bool isDevice = state.input == InputSource::device;
  return !state.isRunning || (isDevice && state.workflow != Workflow::fault);
}

bool mayWithdraw(const InsertionState& state)
{
  const bool isRequested =
      state.input == InputSource::scripted || state.workflow == Workflow::finished;
  return isUnderway(state) && state.workflow != Workflow::fault && state.travel > 0.0 &&
         isRequested;
}

bool mayPullStylet(const InsertionState& state)
{
  return state.hasStylet && isUnderway(state) && !state.isStyletPulled;
}

bool mayHold(const InsertionState& state)
{
  return state.isRunning && state.workflow != Workflow::fault;
}

}  // namespace perilymph::gui
