// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A gauge of three zones for the force on the hand.

#include <QWidget>
#include <optional>

#include "gui/kiosk/ForceLevel.h"

namespace perilymph::gui {

/// Zones from "gentle" at the bottom to "too much" at the top, in proportion to their forces. A
/// pointer shows the force now, a hollow one the largest so far; the zone of the force now is filled.
class LevelGauge : public QWidget {
  Q_OBJECT
public:
  explicit LevelGauge(QWidget* parent);

  /// Without a range, there are no zones and only the number is shown.
  void setRange(std::optional<analysis::PrintedRange> measured);
  /// Size of the words [px, before textScale()].
  void setLetterSize(int size_px);
  /// @param peak_N  The largest force so far, as the engine found it.
  void show(double force_N, double peak_N);

  std::optional<ForceLevel> level() const;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  double share(double force_N) const;
  void paintZone(QPainter& painter, ForceLevel zone, const QRectF& place) const;
  void paintNumber(QPainter& painter, const QRectF& place) const;
  void paintMarks(QPainter& painter, const QRectF& bar) const;

  std::optional<analysis::PrintedRange> measured_;
  int letter_px_ = 20;
  double force_N_ = 0.0, peak_N_ = 0.0;
};

}  // namespace perilymph::gui
