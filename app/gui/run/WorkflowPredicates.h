// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Permitted actions in the current state: which buttons and input fields are enabled.

#include "gui/run/InsertionControl.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// The state that permissions depend on.
struct InsertionState {
  haptics::Workflow workflow = haptics::Workflow::idle;
  InputSource input = InputSource::scripted;
  bool isRunning = false;  ///< The loop runs.
  bool isMoving = false;   ///< The device has a command to move, or is grasped.
  bool isAtDepth = false;  ///< The stop travel is reached.
  double travel = 0.0;     ///< [m]
  bool hasStylet = false;
  bool isStyletPulled = false;
  bool isDeviceActive = false;  ///< InsertionControl::isDeviceActive().
};

InsertionState stateOf(const InsertionControl& control);

/// True after arming: forces are computed and drawn.
bool hasBegun(haptics::Workflow workflow);

/// True if ended: at full depth, withdrawn, or by a fault.
bool isOver(haptics::Workflow workflow);

/// True if the array has left its start or may leave it.
bool isUnderway(const InsertionState& state);

/// True at full depth and at rest. The loop reports it once (finished); after a withdrawal from
/// there and another way in it does not.
bool hasArrived(const InsertionState& state);

/// True before or after an insertion: device, colors and language may be changed.
bool isBetweenInsertions(const InsertionState& state);

/// The same, and nothing moves: the setup may be changed.
bool maySetUp(const InsertionState& state);

/// The main button pauses; otherwise it starts.
bool mayPause(const InsertionState& state);

/// The main button starts, pauses, or continues with a stopped device.
bool mayStart(const InsertionState& state);

/// A script may withdraw the array; mouse and device may after the insertion has finished.
bool mayWithdraw(const InsertionState& state);

bool mayPullStylet(const InsertionState& state);

/// Mouse and keyboard may grasp the array.
bool mayHold(const InsertionState& state);

}  // namespace perilymph::gui
