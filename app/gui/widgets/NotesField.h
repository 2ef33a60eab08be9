// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A field for notes of some lines.

#include <QPlainTextEdit>
#include <cstddef>

namespace perilymph::gui {

/// Text of some lines with a quiet hint while it is empty. Tab leaves it; every change can be undone.
class NotesField : public QPlainTextEdit {
  Q_OBJECT
public:
  /// @param hint      Its name, too, unless another accessible name is set.
  /// @param maxBytes  Length in UTF-8 beyond which nothing is taken; 0: any.
  NotesField(const char* name, const QString& hint, QWidget* parent, std::size_t maxBytes = 0);

  /// Shows other notes, which are not a change.
  void setNotes(const QString& notes);

Q_SIGNALS:
  /// A text was typed or pasted.
  void edited();
  /// What was typed or pasted is longer than what is taken; its end was dropped.
  void cut();
  /// The field lost the focus, or is no longer visible.
  void left();

protected:
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void takeChange();
  void dropExcess();
  void showHint();

  std::size_t maxBytes_;
};

}  // namespace perilymph::gui
