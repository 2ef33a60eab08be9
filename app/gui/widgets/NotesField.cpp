// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/NotesField.h"

#include <QSignalBlocker>
#include <QStyle>
#include <QTextCursor>
#include <QVariant>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

NotesField::NotesField(const char* name, const QString& hint, QWidget* parent, std::size_t maxBytes)
    : QPlainTextEdit(parent), maxBytes_(maxBytes)
{
  setObjectName(QLatin1String(name));
  setAccessibleName(hint);
  setPlaceholderText(hint);
  setTabChangesFocus(true);
  showHint();
  connect(this, &QPlainTextEdit::textChanged, this, &NotesField::takeChange);
}

void NotesField::setNotes(const QString& notes)
{
  const QSignalBlocker quiet(this);
  setPlainText(notes);
  showHint();
}

void NotesField::takeChange()
{
  if (property("hint").toBool() != document()->isEmpty()) showHint();
  dropExcess();
  Q_EMIT edited();
}

void NotesField::dropExcess()
{
  std::ptrdiff_t excess = toPlainText().toUtf8().size() - std::ptrdiff_t(maxBytes_);
  if (maxBytes_ == 0 || excess <= 0) return;
  // before the cursor is what was just typed or pasted
  const QString text = toPlainText();
  QTextCursor cursor = textCursor();
  int from = cursor.position();
  while (excess > 0 && from > 0) {
    const int length = from > 1 && text[from - 1].isLowSurrogate() ? 2 : 1;
    from -= length;
    excess -= text.mid(from, length).toUtf8().size();
  }
  {
    const QSignalBlocker quiet(this);
    cursor.setPosition(from, QTextCursor::KeepAnchor);
    cursor.removeSelectedText();
  }
  Q_EMIT cut();
}

void NotesField::focusOutEvent(QFocusEvent* event)
{
  QPlainTextEdit::focusOutEvent(event);
  Q_EMIT left();
}

void NotesField::hideEvent(QHideEvent* event)
{
  QPlainTextEdit::hideEvent(event);
  Q_EMIT left();
}

/// The hint of an empty field is quiet and in italics, as in fields of one line.
void NotesField::showHint()
{
  const bool isEmpty = document()->isEmpty();
  setProperty("hint", isEmpty);
  QFont shown = typeface(13);
  shown.setItalic(isEmpty);
  setFont(shown);
  style()->unpolish(this);
  style()->polish(this);
}

}  // namespace perilymph::gui
