// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An input field for one number, committed when it loses focus.

#include <QLineEdit>

namespace perilymph::gui {

/// Editing alone changes nothing. Return and losing focus commit the text; Esc reverts it; undo is
/// passed to the window if the field has nothing to undo.
class ValueEdit : public QLineEdit {
  Q_OBJECT
public:
  explicit ValueEdit(QWidget* parent);

  /// Sets the text of the current value.
  void setHeld(const QString& text);
  const QString& held() const { return held_; }
  /// The text was edited and not committed.
  bool isPending() const { return isHolding_ && text() != held_; }
  /// Reverts the text.
  void takeBack();

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

private:
  QString held_;
  bool isHolding_ = false;
};

}  // namespace perilymph::gui
