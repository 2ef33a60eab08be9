#pragma once

// A wide plate to push the array with: while it is held the array moves, the farther right the
// faster.

#include <QWidget>
#include <optional>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// Under one finger, or the mouse's left button.
class PushPad : public QWidget {
  Q_OBJECT
public:
  static constexpr Speed slowest = millimetersPerSecond(0.5);
  static constexpr Speed fastest = millimetersPerSecond(6.0);

  explicit PushPad(QWidget* parent);

  bool isHeld() const { return place_.has_value(); }
  /// Asked for by where the pad is held; zero while nobody holds it.
  Speed speed() const;
  /// Let go of, whatever the finger does.
  void release();

Q_SIGNALS:
  void heldChanged(bool isHeld);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void hideEvent(QHideEvent*) override { release(); }
  void changeEvent(QEvent* event) override;

private:
  void hold(int x);

  std::optional<double> place_;  ///< 0 at the left edge, 1 at the right one.
};

}  // namespace perilymph::gui
