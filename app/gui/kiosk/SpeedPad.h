// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A wide plate that advances the array while it is pressed, faster toward the right.

#include <QWidget>
#include <optional>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// For one finger, or the mouse's left button.
class SpeedPad : public QWidget {
  Q_OBJECT
public:
  static constexpr Speed slowest = millimetersPerSecond(0.5);
  static constexpr Speed fastest = millimetersPerSecond(6.0);

  explicit SpeedPad(QWidget* parent);

  bool isHeld() const { return place_.has_value(); }
  /// Speed for the pressed position; zero while it is not pressed.
  Speed speed() const;
  /// Releases the plate, even if it is still touched.
  void release();
  /// Size of its caption [px, before textScale()].
  void setLetterSize(int size_px);
  void retranslate();

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
  int side() const;

  int letter_px_ = 26;
  std::optional<double> place_;  ///< 0 at the left edge, 1 at the right one.
};

}  // namespace perilymph::gui
