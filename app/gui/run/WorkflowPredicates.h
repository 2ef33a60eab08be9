#pragma once

// What may be done with an insertion now: which buttons can be pressed, which fields be changed.

#include "gui/run/InsertionControl.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// What the answers depend on.
struct InsertionState {
  haptics::Workflow workflow = haptics::Workflow::idle;
  InputSource input = InputSource::scripted;
  bool isRunning = false;  ///< The loop runs.
  bool isMoving = false;   ///< The hand is asked to move, or held.
  double travel = 0.0;     ///< [m]
  bool hasStylet = false;
  bool isStyletPulled = false;
};

InsertionState stateOf(const InsertionControl& control);

/// Past arming: forces are computed and drawn.
bool hasBegun(haptics::Workflow workflow);

/// Ended: at full depth, out again, or stopped by a fault.
bool isOver(haptics::Workflow workflow);

/// The array has left its start, or may leave it.
bool isUnderway(const InsertionState& state);

/// Before an insertion or after it: device, colors and language may be chosen.
bool isBetweenInsertions(const InsertionState& state);

/// The same, and nothing moves: the setup may be changed.
bool maySetUp(const InsertionState& state);

/// The main button starts, or pauses what the script moves.
bool mayStart(const InsertionState& state);

/// The script may pull the array out; mouse and device may once the insertion has finished.
bool mayWithdraw(const InsertionState& state);

bool mayPullStylet(const InsertionState& state);

/// Mouse and keyboard may hold the array.
bool mayHold(const InsertionState& state);

}  // namespace perilymph::gui
