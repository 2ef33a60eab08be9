// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Motion of the array by mouse and keyboard.

#include <set>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

class SidePanel;

/// The array follows wheel and arrow keys only while it is grasped: by Space or the button of the
/// panel.
class HeldArray {
public:
  HeldArray(InsertionControl& control, SidePanel& side) : control_(control), side_(side) {}

  /// No effect if a script or device moves the array.
  void hold(bool isHeld);
  /// @param key  Down or Up; moves the array while it is pressed and the array is grasped.
  void press(int key);
  void release(int key);
  /// Positive notches, away from the user, push the array in. False while it is not grasped.
  bool turnWheel(double notches);
  /// Advances the time.
  void step(double elapsed_s);
  /// Releases all keys; the panel shows whether the array is grasped.
  void letGo();

private:
  InsertionControl& control_;
  SidePanel& side_;
  std::set<int> pressed_;
};

}  // namespace perilymph::gui
