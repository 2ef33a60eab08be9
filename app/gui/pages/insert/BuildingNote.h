#pragma once

// What is being built, over the foot of the picture, once somebody has waited for a second.

#include <QFrame>

class QLabel;

namespace perilymph::gui {

/// Says that the window waits for a cochlea, and lets the person go back to the one before.
class BuildingNote : public QFrame {
  Q_OBJECT
public:
  /// Shorter waits are over before they could be read about.
  static constexpr int patience_ms = 1000;

  /// Lies over `page`, whose size it follows.
  explicit BuildingNote(QWidget* page);

  /// @param busyFor_ms  How long it has been building; 0 when it is not.
  void show(qint64 busyFor_ms);

Q_SIGNALS:
  void cancelAsked();

protected:
  bool eventFilter(QObject* target, QEvent* event) override;

private:
  void place();

  QLabel* text_;
};

}  // namespace perilymph::gui
