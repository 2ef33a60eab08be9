// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Overlay.h"

#include <QEvent>

namespace perilymph::gui {

Overlay::Overlay(QWidget* page) : QFrame(page) { page->installEventFilter(this); }

bool Overlay::eventFilter(QObject* target, QEvent* event)
{
  if (event->type() == QEvent::Resize && !isHidden()) place();
  return QFrame::eventFilter(target, event);
}

}  // namespace perilymph::gui
