#pragma once

// How the window takes the force off the hand, whatever else it is doing.

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// The one way from events of the window (keyboard lost, page left, window closed, signal) to an
/// array that rests or a loop that has stopped. UI thread only.
class SafetyStop {
public:
  explicit SafetyStop(InsertionControl& control) : control_(control) {}

  /// The window lost the keyboard: the release of a key is no longer told to it. An array held by
  /// mouse and keyboard is let go of; script and device have no part in this.
  void loseKeyboard();

  /// Another page is shown, and nobody sees where the array goes: it rests.
  /// @return Whether it moved or was held.
  bool leaveSight();

  /// The window ends: stops the loop, which leaves a force of zero on the device. Comes before
  /// settings and files, which may take a moment. The recording is closed with the insertion.
  void end();

private:
  InsertionControl& control_;
};

}  // namespace perilymph::gui
