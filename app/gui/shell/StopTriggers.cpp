// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/StopTriggers.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace perilymph::gui {

StopTriggers::StopTriggers(InsertionController& insertion, QWidget* window)
    : QObject(window), insertion_(&insertion), window_(window)
{
  qApp->installEventFilter(this);
}

bool StopTriggers::eventFilter(QObject* target, QEvent* event)
{
  if (insertion_.isNull()) return false;
  switch (event->type()) {
    case QEvent::ShortcutOverride:  // precedes the key press, and is the only event of a shortcut
    case QEvent::KeyPress: {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Escape || key == Qt::Key_Pause) insertion_->stopDevice();
      break;
    }
    case QEvent::MouseButtonRelease:
      // Before the button is painted, which may take tens of milliseconds.
      if (target->property(leavesInsertion).toBool()) insertion_->stopDevice();
      break;
    case QEvent::WindowDeactivate:
      // A key release in another window is not received here: release the array at once.
      if (target == window_) insertion_->loseKeyboard();
      break;
    case QEvent::WindowActivate:
      if (target == window_) insertion_->safety().regainKeyboard();
      break;
    default:
      break;
  }
  return QObject::eventFilter(target, event);
}

}  // namespace perilymph::gui
