// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/ValueEdit.h"

#include <QFocusEvent>
#include <QKeyEvent>

namespace perilymph::gui {

ValueEdit::ValueEdit(QWidget* parent) : QLineEdit(parent) {}

void ValueEdit::setHeld(const QString& text)
{
  // edited text is kept while the current value is unchanged
  const bool isKept = isPending() && held_ == text;
  held_ = text;
  isHolding_ = true;
  if (!isKept && this->text() != text) setText(text);
}

void ValueEdit::takeBack()
{
  if (isPending()) setText(held_);
}

void ValueEdit::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape && isPending()) return takeBack();
  const bool isUndo = event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo);
  if (isUndo && isHolding_ && !isPending()) return event->ignore();
  QLineEdit::keyPressEvent(event);
}

void ValueEdit::focusInEvent(QFocusEvent* event)
{
  QLineEdit::focusInEvent(event);
  if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
    selectAll();
}

}  // namespace perilymph::gui
