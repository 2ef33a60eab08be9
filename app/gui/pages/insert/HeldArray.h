#pragma once

// The array moved by mouse and keyboard.

#include <set>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

class SidePanel;

/// The array follows wheel and arrow keys only while it is held: with Space or the button of the
/// panel.
class HeldArray {
public:
  HeldArray(InsertionControl& control, SidePanel& side) : control_(control), side_(side) {}

  /// Without effect where script or device move the array.
  void hold(bool isHeld);
  /// @param key  Down or Up; moves the array while it is pressed and the array is held.
  void press(int key);
  void release(int key);
  /// Positive notches, away from oneself, push the array in. False while it is not held.
  bool turnWheel(double notches);
  /// Lets the time go by.
  void step(double elapsed_s);
  /// No key is pressed any more, and the panel says whether the array is held.
  void letGo();

private:
  InsertionControl& control_;
  SidePanel& side_;
  std::set<int> pressed_;
};

}  // namespace perilymph::gui
