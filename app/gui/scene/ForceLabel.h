// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Interpretation of the forces, below the force read-out.

#include <QWidget>

#include "gui/scene/ForceInterpretation.h"

namespace perilymph::gui {

/// Two lines on a plate, because the 3D view may be behind them. A highlighted line has a mark in
/// addition to its color.
class ForceLabel : public QWidget {
  Q_OBJECT
public:
  explicit ForceLabel(QWidget* parent);

  /// Shows the forces of a tick, or instead of that on the partition how it ruptured.
  void show(const haptics::TickOutput& now);
  const QString& handText() const { return hand_.text; }
  const QString& partitionText() const { return partition_.text; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  int lineHeight() const;

  ForceThresholds known_;
  QString sources_;  ///< Sources of the thresholds.
  ForceMeaning hand_, partition_;
};

}  // namespace perilymph::gui
