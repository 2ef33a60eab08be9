// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tooltips of the text over the 3D view, which itself passes the mouse through.

#include <QPoint>
#include <vector>

class QWidget;

namespace perilymph::gui {

class PhaseLine;

/// The texts over a 3D view that have tooltips.
struct ReadOutTips {
  QWidget *travel, *angle, *force, *forceLabel, *speed, *magnification, *viewName;
  PhaseLine* phase;

  /// Sets the texts of the tooltips.
  void set() const;
  /// Shows the tooltip of the text at a place of the view. False if there is none.
  bool show(QWidget& view, const QPoint& place, const QPoint& onScreen) const;
};

}  // namespace perilymph::gui
