#pragma once

// A field for one number: what is typed becomes a change once it is left.

#include <QLineEdit>

namespace perilymph::gui {

/// Typing alone changes nothing. Return and leaving the field send the text off; Esc takes it back;
/// undo goes to the window where the field itself has nothing to take back.
class ValueEdit : public QLineEdit {
  Q_OBJECT
public:
  explicit ValueEdit(QWidget* parent);

  /// The text that holds now.
  void setHeld(const QString& text);
  const QString& held() const { return held_; }
  /// Something else than what holds was typed and not sent off.
  bool isPending() const { return isHolding_ && text() != held_; }
  /// Forgets what was typed.
  void takeBack();

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

private:
  QString held_;
  bool isHolding_ = false;
};

}  // namespace perilymph::gui
