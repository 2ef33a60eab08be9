// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Removal of the force by the window, in every situation.

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// Handles all events of the window (keyboard focus lost, page left, window closed, signal) that
/// must release the array or stop the loop. UI thread only.
class SafetyStop {
public:
  explicit SafetyStop(InsertionControl& control) : control_(control) {}

  /// The window lost the keyboard focus and will not receive key releases. Releases an array
  /// grasped by mouse and keyboard; does not affect scripts and devices.
  void loseKeyboard();

  /// Another page is shown and the array is not visible: pauses it.
  /// @return Whether it moved or was grasped.
  bool leaveSight();

  /// The window ends: stops the loop, which sets the device's force to zero. Call before saving
  /// settings and files, which may take time. The recording is closed with the insertion.
  void end();

private:
  InsertionControl& control_;
};

}  // namespace perilymph::gui
