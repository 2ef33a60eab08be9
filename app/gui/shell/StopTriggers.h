// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys and focus changes that stop a haptic device, whatever has the keyboard focus.

#include <QObject>
#include <QPointer>

#include "gui/pages/insert/InsertionController.h"

namespace perilymph::gui {

/// Property of a button that shows another page, which stops a device.
inline constexpr const char* leavesInsertion = "leavesInsertion";

/// Watches all events of the application. Esc and the key Pause stop a device before anything else
/// handles them, even in a dialog or a list, and are then handled as usual. If the window loses the
/// keyboard focus, an array held by mouse and keyboard is released, and a device is stopped after a
/// second.
class StopTriggers : public QObject {
  Q_OBJECT
public:
  /// @param window  Its focus counts; the owner of this object.
  StopTriggers(InsertionController& insertion, QWidget* window);

  bool eventFilter(QObject* target, QEvent* event) override;

private:
  QPointer<InsertionController> insertion_;  ///< Null while the window is destroyed.
  QWidget* window_;
};

}  // namespace perilymph::gui
