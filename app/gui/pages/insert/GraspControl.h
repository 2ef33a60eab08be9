// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Motion of the array by mouse and keyboard.

#include <QObject>
#include <QStringList>
#include <set>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// Values of the setting "hold": the array is held while Space or the button is pressed, or from one
/// press to the next, for one-handed use.
QStringList holdText();

/// The array follows wheel and arrow keys only while it is grasped: by Space or the button of the
/// panel.
class GraspControl : public QObject {
  Q_OBJECT
public:
  explicit GraspControl(InsertionControl& control) : control_(control) {}

  /// No effect if a script or device moves the array.
  void hold(bool isHeld);
  /// @param key  Down or Up; moves the array while it is pressed and the array is grasped.
  void press(int key);
  void release(int key);
  /// As with the arrow keys, down is in: negative notches, towards the user, push the array in.
  /// False while it is not grasped.
  bool turnWheel(double notches);
  /// Moves the array at the scenario's speed while a key is pressed. To be repeated in every frame.
  void drive();
  /// Releases all keys.
  void letGo();

Q_SIGNALS:
  /// Whether the array is grasped.
  void heldChanged(bool isHeld);

private:
  InsertionControl& control_;
  std::set<int> pressed_;
};

}  // namespace perilymph::gui
