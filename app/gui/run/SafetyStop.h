// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Removal of the force by the window, in every situation.

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// Time for which the window may lack the keyboard focus before a device is stopped: long enough for
/// a notification that takes the focus and returns it, short enough that nobody has left the device
/// (chosen; no source).
inline constexpr Duration focusPatience = milliseconds(1000);

/// Handles all events of the window that must release the array or stop the device: Pause, Esc, the
/// Stop button, page left, keyboard focus lost, screen locked, window closed, signal. After each of
/// them the haptic loop removes the device's force within 5 ms, even if the window's thread is
/// blocked and the queue of commands is full. UI thread only.
class SafetyStop {
public:
  explicit SafetyStop(InsertionControl& control) : control_(control) {}

  /// Pause, Esc, the Stop button, or a locked screen: stops a device; does not affect scripts and
  /// the pointer.
  /// @return Whether a device moved the array or was ready to.
  bool stopDevice();

  /// The window lost the keyboard focus and will not receive key releases. Releases an array
  /// grasped by mouse and keyboard; stops a device after `focusPatience`; does not affect scripts.
  void loseKeyboard();
  /// The window has the keyboard focus again.
  void regainKeyboard();

  /// Another page is shown and the array is not visible: pauses it.
  /// @return Whether it moved, was grasped, or was moved by a device.
  bool onPageHidden();

  /// The window ends: stops the loop, which sets the device's force to zero. Call before saving
  /// settings and files, which may take time. The recording is closed with the insertion.
  /// @return Timing of the loop.
  haptics::LoopStatistics end();

private:
  InsertionControl& control_;
};

}  // namespace perilymph::gui
