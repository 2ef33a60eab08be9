// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/StopTriggers.h"

#include <QApplication>
#include <QKeyEvent>

namespace perilymph::gui {

StopTriggers::StopTriggers(InsertPage& page, QWidget* window)
    : QObject(window), page_(&page), window_(window)
{
  qApp->installEventFilter(this);
}

bool StopTriggers::eventFilter(QObject* target, QEvent* event)
{
  if (page_.isNull()) return false;
  switch (event->type()) {
    case QEvent::ShortcutOverride:  // precedes the key press, and is the only event of a shortcut
    case QEvent::KeyPress: {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Escape || key == Qt::Key_Pause) page_->stopDevice();
      break;
    }
    case QEvent::MouseButtonRelease:
      // Before the button is painted, which may take tens of milliseconds.
      if (target->property(leavesInsertion).toBool()) page_->stopDevice();
      break;
    case QEvent::WindowDeactivate:
      // A key release in another window is not received here: release the array at once.
      if (target == window_) page_->loseKeyboard();
      break;
    case QEvent::WindowActivate:
      if (target == window_) page_->regainKeyboard();
      break;
    default:
      break;
  }
  return QObject::eventFilter(target, event);
}

}  // namespace perilymph::gui
